#include <auxfem/algebra/neighbour_exchange.h>

namespace auxfem
{
  NeighbourExchange::NeighbourExchange(
    const MPI_Comm                             communicator,
    const std::map<unsigned int, std::size_t> &sent,
    const std::map<unsigned int, std::size_t> &received)
    : communicator(communicator)
    , sent(sent)
    , received(received)
  {}

  std::vector<double>
  NeighbourExchange::exchange(const std::vector<double> &values) const
  {
    constexpr int tag     = 0;
    std::size_t   n_comes = 0;
    for (const auto &[rank, n] : received)
      n_comes += n;
    std::vector<double>      comes(n_comes);
    std::vector<MPI_Request> requests;
    double                  *in = comes.data();
    for (const auto &[rank, n] : received)
      {
        MPI_Irecv(in,
                  n,
                  MPI_DOUBLE,
                  rank,
                  tag,
                  communicator,
                  &requests.emplace_back());
        in += n;
      }
    const double *out = values.data();
    for (const auto &[rank, n] : sent)
      {
        MPI_Isend(out,
                  n,
                  MPI_DOUBLE,
                  rank,
                  tag,
                  communicator,
                  &requests.emplace_back());
        out += n;
      }
    MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    return comes;
  }
} // namespace auxfem
