#ifndef auxfem_algebra_neighbour_exchange_h
#define auxfem_algebra_neighbour_exchange_h

#include <mpi.h>

#include <map>
#include <numeric>
#include <type_traits>
#include <vector>

namespace auxfem
{
  /** Numbers of values, by rank. */
  using SizesByRank = std::map<unsigned int, std::size_t>;

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
     * @param sent, received numbers of values; each rank receives what the
     *   others send.
     */
    NeighbourExchange(MPI_Comm           communicator,
                      const SizesByRank &sent,
                      const SizesByRank &received);

    /**
     * Sends @p values, those for each rank one after the other, and returns
     * what comes in, in the same order. Collective.
     */
    template <typename T>
    std::vector<T> exchange(const std::vector<T> &values) const
    {
      static_assert(std::is_trivially_copyable_v<T>);
      std::vector<T> comes(std::accumulate(
        received.begin(),
        received.end(),
        std::size_t(0),
        [](const std::size_t n, const auto &item) { return n + item.second; }));
      transfer(values.data(), sizeof(T), comes.data());
      return comes;
    }

  private:
    /** Of values of @p size bytes each. */
    void transfer(const void *values, std::size_t size, void *comes) const;

    MPI_Comm    communicator = MPI_COMM_NULL;
    SizesByRank sent, received;
  };

  /** What other ranks send to this one, of what each sends to others.
   * Collective. */
  SizesByRank sizes_from_others(const SizesByRank &sent, MPI_Comm communicator);

  /** Of other ranks, by rank. */
  template <typename T>
  using ListsByRank = std::map<unsigned int, std::vector<T>>;

  /** Those of all ranks, in the order of these. */
  template <typename T>
  std::vector<T> one_after_the_other(const ListsByRank<T> &lists)
  {
    std::vector<T> all;
    for (const auto &[rank, list] : lists)
      all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  /** Of each list, how many values it has, times @p factor. */
  template <typename T>
  SizesByRank lengths(const ListsByRank<T> &lists, const std::size_t factor = 1)
  {
    SizesByRank n;
    for (const auto &[rank, list] : lists)
      n[rank] = list.size() * factor;
    return n;
  }

  /** The lists that others have for this rank, of those that each has @p for_others.
   * Collective. deal.II's some_to_some() would compress them, which takes
   * longer than sending them. */
  template <typename T>
  ListsByRank<T> exchange_lists(const ListsByRank<T> &for_others,
                                const MPI_Comm        communicator)
  {
    const SizesByRank    sent     = lengths(for_others);
    const SizesByRank    received = sizes_from_others(sent, communicator);
    const std::vector<T> comes = NeighbourExchange(communicator, sent, received)
                                   .exchange(one_after_the_other(for_others));
    ListsByRank<T> lists;
    auto           next = comes.begin();
    for (const auto &[rank, n] : received)
      {
        lists[rank].assign(next, next + n);
        next += n;
      }
    return lists;
  }
} // namespace auxfem

#endif
