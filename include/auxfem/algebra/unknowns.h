#ifndef auxfem_algebra_unknowns_h
#define auxfem_algebra_unknowns_h

#include <auxfem/algebra/vector.h>

#include <deal.II/base/mpi_noncontiguous_partitioner.h>
#include <deal.II/base/point.h>

#include <memory>
#include <optional>
#include <unordered_map>

namespace auxfem
{
  /**
   * Distribution of unknowns over the ranks. Each rank owns a contiguous range
   * of global numbers and stores ("local" numbers) its owned unknowns first,
   * then ghosts, i.e. copies of other ranks' unknowns.
   */
  class UnknownLayout
  {
  public:
    /**
     * @param ghost_numbers global numbers of other ranks' unknowns in storage
     *   order, each once. Collective.
     */
    UnknownLayout(MPI_Comm                communicator,
                  unsigned int            n_owned,
                  const std::vector<int> &ghost_numbers);

    MPI_Comm communicator() const
    {
      return comm;
    }

    unsigned int rank() const
    {
      return my_rank;
    }

    unsigned int n_ranks() const
    {
      return first.size() - 1;
    }

    unsigned int n_owned() const
    {
      return first[my_rank + 1] - first[my_rank];
    }

    unsigned int n_local() const
    {
      return n_owned() + ghosts.size();
    }

    /** Number of unknowns of all ranks. */
    unsigned int n_global() const
    {
      return first.back();
    }

    /** First global number of @p rank; for n_ranks() the total number. */
    int first_of(const unsigned int rank) const
    {
      return first[rank];
    }

    /** Rank that owns a global number. */
    unsigned int owner(int global) const;

    /** Whether a local number is owned; false for -1. */
    bool is_owned(const int local) const
    {
      return local >= 0 && local < static_cast<int>(n_owned());
    }

    int global(const unsigned int local) const
    {
      return local < n_owned() ? first[my_rank] + static_cast<int>(local)
                               : ghosts[local - n_owned()];
    }

    /** Local number of a global one; -1 if it is -1 or not on this rank. */
    int local(int global) const;

    /** Copies owned values to the ghosts of other ranks. Collective. */
    void update_ghosts(double *values) const;

    /** As above for optional numbers. Collective. */
    void update_ghosts(std::vector<std::optional<unsigned int>> &numbers) const;

    /**
     * Appends ghosts that are not local yet; other local numbers do not change.
     * Returns whether any rank gained one. Collective.
     */
    bool add_ghosts(const std::vector<int> &globals);

    /** @name Reductions over all ranks. Collective. */
    ///@{
    double              sum(double mine) const;
    std::vector<double> sum(const std::vector<double> &mine) const;
    double              largest(double mine) const;
    ///@}

  private:
    void make_exchange();

    MPI_Comm                     comm;
    unsigned int                 my_rank;
    std::vector<int>             first; ///< by rank, and the end of the last
    std::vector<int>             ghosts;
    std::unordered_map<int, int> local_of_ghost;
    /** Null on one rank. */
    std::shared_ptr<const dealii::Utilities::MPI::NoncontiguousPartitioner>
      exchange;
  };

  /** Kinds of unknowns, with separate norms in convergence tests. */
  enum class UnknownKind : unsigned char
  {
    translation,
    rotation,
    prescribed,
    multiplier
  };

  /** Owned rows by kind and by whether they are prescribed. */
  struct OwnedRows
  {
    std::vector<int> free_translations, free_rotations, prescribed_translations,
      prescribed_rotations, multipliers;
  };

  /**
   * Properties of a structure's unknowns for linear algebra: which are
   * prescribed, which lie inside a strut and can be condensed, which belong to
   * one joint. Ghosts are included.
   */
  struct Unknowns
  {
    explicit Unknowns(const UnknownLayout &layout);

    UnknownLayout layout;
    /** Kind by local unknown. */
    std::vector<UnknownKind> kinds;
    /** Whether a local unknown is a rotation, prescribed or not. */
    std::vector<bool> is_rotation;
    /** Strut whose inside contains the local unknown; none at joints. */
    std::vector<std::optional<unsigned int>> strut;
    /**
     * Joint of local unknowns not inside struts, for multipliers a constrained
     * joint. The same numbering on all ranks.
     */
    std::vector<unsigned int> joint;
    /**
     * Component of motion, 0 to 5, of local unknowns not inside struts;
     * meaningless for multipliers.
     */
    std::vector<unsigned char> component;
    /** Positions of joints, then of other objects that `joint` numbers (m). */
    std::shared_ptr<const std::vector<dealii::Point<3>>> positions;
    /** Components of motion of nodes: 0, 1, 5 in the plane, else all. */
    std::vector<unsigned int> components;
    /** Length that scales moments to forces (m). */
    double length = 1;

    /** Adds ghosts. Returns whether any rank gained one. Collective. */
    bool add_ghosts(const std::vector<int> &globals);

    /**
     * Unit of the local unknown @p i for comparisons: 1/length for rotations,
     * else 1.
     */
    double unit(const unsigned int i) const
    {
      return is_rotation[i] ? 1 / length : 1.;
    }

    OwnedRows owned_rows() const;

    /**
     * Number of free displacements and rotations over all ranks. Collective.
     */
    unsigned int n_free() const;

    /** Number of unknowns of a kind, over all ranks. Collective. */
    unsigned long n_of_kind(UnknownKind kind) const;
  };

  /** A subset of the unknowns of a layout, with a layout of its own. */
  struct UnknownSelection
  {
    /**
     * @param is_selected by local unknown of @p all; owned and ghost copies
     *   must agree. The order is preserved. Collective.
     */
    UnknownSelection(const UnknownLayout     &all,
                     const std::vector<bool> &is_selected);

    UnknownLayout layout;
    /** Local unknown of the selection by local unknown of all, or -1. */
    std::vector<int> number;
    /** Local unknowns of all, in the order of the selection. */
    std::vector<int> unknowns;
  };
} // namespace auxfem

#endif
