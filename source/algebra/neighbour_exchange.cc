#include <auxfem/algebra/neighbour_exchange.h>

#include <deal.II/base/mpi.h>

namespace auxfem
{
  NeighbourExchange::NeighbourExchange(const MPI_Comm     communicator,
                                       const SizesByRank &sent,
                                       const SizesByRank &received)
    : communicator(communicator)
    , sent(sent)
    , received(received)
  {}

  void NeighbourExchange::transfer(const void       *values,
                                   const std::size_t size,
                                   void             *comes) const
  {
    constexpr int tag = 0;
    // As bytes they might be more than MPI counts.
    const auto item =
      dealii::Utilities::MPI::create_mpi_data_type_n_bytes(size);
    std::vector<MPI_Request> requests;
    char                    *in = static_cast<char *>(comes);
    for (const auto &[rank, n] : received)
      {
        MPI_Irecv(in,
                  static_cast<int>(n),
                  *item,
                  static_cast<int>(rank),
                  tag,
                  communicator,
                  &requests.emplace_back());
        in += n * size;
      }
    const char *out = static_cast<const char *>(values);
    for (const auto &[rank, n] : sent)
      {
        MPI_Isend(out,
                  static_cast<int>(n),
                  *item,
                  static_cast<int>(rank),
                  tag,
                  communicator,
                  &requests.emplace_back());
        out += n * size;
      }
    MPI_Waitall(static_cast<int>(requests.size()),
                requests.data(),
                MPI_STATUSES_IGNORE);
  }

  SizesByRank sizes_from_others(const SizesByRank &sent,
                                const MPI_Comm     communicator)
  {
    int n_ranks = 0;
    MPI_Comm_size(communicator, &n_ranks);
    std::vector<unsigned long> to(n_ranks), from(n_ranks);
    for (const auto &[rank, n] : sent)
      to[rank] = n;
    MPI_Alltoall(to.data(),
                 1,
                 MPI_UNSIGNED_LONG,
                 from.data(),
                 1,
                 MPI_UNSIGNED_LONG,
                 communicator);
    SizesByRank received;
    for (int rank = 0; rank < n_ranks; ++rank)
      if (from[rank] > 0)
        received[rank] = from[rank];
    return received;
  }
} // namespace auxfem
