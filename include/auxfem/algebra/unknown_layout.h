#ifndef auxfem_algebra_unknown_layout_h
#define auxfem_algebra_unknown_layout_h

#include <auxfem/algebra/vector.h>

#include <deal.II/base/mpi_noncontiguous_partitioner.h>

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
} // namespace auxfem

#endif
