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
   * How unknowns are spread over the ranks: each rank owns a contiguous range
   * of global numbers and stores ("local" numbers) its owned unknowns first,
   * then ghosts: copies of unknowns of other ranks that it needs.
   */
  class UnknownLayout
  {
  public:
    /**
     * @param ghosts global numbers of unknowns of other ranks, in the order
     * they are to be stored in, each once. Collective.
     */
    UnknownLayout(MPI_Comm                communicator,
                  unsigned int            n_owned,
                  const std::vector<int> &ghosts);

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

    /** Of all ranks. */
    unsigned int n_global() const
    {
      return first.back();
    }

    /** First global number of @p rank; with rank = n_ranks() their number. */
    int first_of(const unsigned int rank) const
    {
      return first[rank];
    }

    /** Rank that owns a global number. */
    unsigned int owner(int global) const;

    /** Whether a local number is this rank's own; false for -1. */
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

    /** Brings owned values to the ghosts of other ranks. Collective. */
    void update_ghosts(double *values) const;

    /** The same for numbers that some unknowns have. Collective. */
    void update_ghosts(std::vector<std::optional<unsigned int>> &numbers) const;

    /**
     * Appends ghosts; those that are local already are left out. The numbers
     * of the others stay. Returns whether any rank has gained one. Collective.
     */
    bool add_ghosts(const std::vector<int> &globals);

    /** @name Over all ranks, of what each contributes. Collective. */
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
    /** None on one rank. */
    std::shared_ptr<const dealii::Utilities::MPI::NoncontiguousPartitioner>
      exchange;
  };

  /** Kinds of unknowns, measured apart in convergence tests. */
  enum class UnknownKind : unsigned char
  {
    translation,
    rotation,
    prescribed,
    multiplier
  };

  /** Owned rows apart by what is measured and by whether they are free. */
  struct OwnedRows
  {
    std::vector<int> free_translations, free_rotations, prescribed_translations,
      prescribed_rotations, multipliers;
  };

  /**
   * What linear algebra knows of the unknowns of a structure beside how they
   * act on each other: which are prescribed, which lie inside a strut and can
   * be condensed there, which belong to one joint. All ghosts included.
   */
  struct Unknowns
  {
    explicit Unknowns(const UnknownLayout &layout);

    UnknownLayout layout;
    /** By local unknown. */
    std::vector<UnknownKind> kinds;
    /** Whether a local unknown is a rotation, prescribed or not. */
    std::vector<bool> is_rotation;
    /** Strut that a local unknown lies inside of; none at joints. */
    std::vector<std::optional<unsigned int>> strut;
    /**
     * Of local unknowns not inside struts: the joint they belong to, of
     * multipliers one that they constrain. The numbers are the same on all
     * ranks.
     */
    std::vector<unsigned int> joint;
    /**
     * Component of motion, 0 to 5, of local unknowns not inside struts;
     * meaningless for multipliers.
     */
    std::vector<unsigned char> component;
    /** Positions of joints, then of other things that `joint` names (m). */
    std::shared_ptr<const std::vector<dealii::Point<3>>> positions;
    /** Components of motion that nodes have: 0, 1, 5 in the plane, else all. */
    std::vector<unsigned int> components;
    /** Ties moments to forces (m). */
    double length = 1;

    /**
     * Keeps copies of further unknowns of other ranks. Returns whether any rank
     * has gained one. Collective.
     */
    bool add_ghosts(const std::vector<int> &globals);

    /**
     * What the local unknown @p i is divided by to be compared with others:
     * 1/length for rotations, measured in length times radian, else 1.
     */
    double unit(const unsigned int i) const
    {
      return is_rotation[i] ? 1 / length : 1.;
    }

    OwnedRows owned_rows() const;

    /**
     * Number of displacements and rotations that are not prescribed, over all
     * ranks. Collective.
     */
    unsigned int n_free() const;

    /** Number of unknowns of a kind, over all ranks. Collective. */
    unsigned long n_of_kind(UnknownKind kind) const;
  };

  /** Some of the unknowns of a layout, with a layout of their own. */
  struct UnknownSelection
  {
    /**
     * @param is_selected by local unknown of @p all; owned and ghost copies
     *   agree. Their order stays. Collective.
     */
    UnknownSelection(const UnknownLayout     &all,
                     const std::vector<bool> &is_selected);

    UnknownLayout layout;
    /** By local unknown of all: local unknown of the selection, or -1. */
    std::vector<int> number;
    /** Local unknowns of all, in the order of the selection. */
    std::vector<int> unknowns;
  };
} // namespace auxfem

#endif
