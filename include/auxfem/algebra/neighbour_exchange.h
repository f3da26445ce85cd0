#ifndef auxfem_algebra_neighbour_exchange_h
#define auxfem_algebra_neighbour_exchange_h

#include <mpi.h>

#include <map>
#include <vector>

namespace auxfem
{
  /**
   * Messages of fixed lengths between ranks that know of each other, sent again
   * and again with new values.
   */
  class NeighbourExchange
  {
  public:
    /** To or from nobody. */
    NeighbourExchange() = default;

    /**
     * @param sent, received numbers of values by rank; each rank receives what
     *   the others send.
     */
    NeighbourExchange(MPI_Comm                                   communicator,
                      const std::map<unsigned int, std::size_t> &sent,
                      const std::map<unsigned int, std::size_t> &received);

    /**
     * Sends @p values, those for each rank one after the other, and returns
     * what comes in, in the same order. Collective.
     */
    std::vector<double> exchange(const std::vector<double> &values) const;

  private:
    MPI_Comm                            communicator = MPI_COMM_NULL;
    std::map<unsigned int, std::size_t> sent, received;
  };
} // namespace auxfem

#endif
