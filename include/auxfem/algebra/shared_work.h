#ifndef auxfem_algebra_shared_work_h
#define auxfem_algebra_shared_work_h

#include <auxfem/algebra/unknown_layout.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <iterator>
#include <numeric>
#include <vector>

namespace auxfem
{
  /** @name Work on a list that every rank has, of which each does a part. */
  ///@{
  /** The part of @p n items that this rank looks at: [begin, end). The parts of
   * the ranks follow each other. */
  inline std::array<std::size_t, 2> share_of_rank(const UnknownLayout &layout,
                                                  const std::size_t    n)
  {
    return {{n * layout.rank() / layout.n_ranks(),
             n * (layout.rank() + 1) / layout.n_ranks()}};
  }

  /** What the ranks have, one after the other, on all of them. Collective.
   * deal.II's all_gather() would compress it, which takes longer than all else.
   */
  template <typename T>
  std::vector<T> of_all_ranks(const std::vector<T> &mine,
                              const MPI_Comm        communicator)
  {
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return mine;
    const std::vector<int> sizes =
      dealii::Utilities::MPI::all_gather(communicator, int(mine.size()));
    std::vector<int> first(1, 0);
    std::partial_sum(sizes.begin(), sizes.end(), std::back_inserter(first));
    std::vector<T>     all(first.back());
    const MPI_Datatype type = dealii::Utilities::MPI::mpi_type_id_for_type<T>;
    MPI_Allgatherv(mine.data(),
                   mine.size(),
                   type,
                   all.data(),
                   sizes.data(),
                   first.data(),
                   type,
                   communicator);
    return all;
  }
  ///@}
} // namespace auxfem

#endif
