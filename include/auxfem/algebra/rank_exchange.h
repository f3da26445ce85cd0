#ifndef auxfem_algebra_rank_exchange_h
#define auxfem_algebra_rank_exchange_h

#include <auxfem/algebra/unknowns.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace auxfem
{
  /** @name Work on a list that every rank has, divided among the ranks */
  ///@{
  /**
   * This rank's part of @p n items, [begin, end). The parts of the ranks are
   * consecutive.
   */
  inline std::array<std::size_t, 2> share_of_rank(const UnknownLayout &layout,
                                                  const std::size_t    n)
  {
    return {{n * layout.rank() / layout.n_ranks(),
             n * (layout.rank() + 1) / layout.n_ranks()}};
  }

  /**
   * Numbers of items of the ranks, and the index of each rank's first item in
   * their concatenation.
   */
  class ItemsOfRanks
  {
  public:
    /** Collective. @param n_mine number of items of this rank */
    ItemsOfRanks(std::size_t n_mine, MPI_Comm communicator);

    /** Items are the unknowns owned by each rank. */
    explicit ItemsOfRanks(const UnknownLayout &layout);

    std::size_t n() const
    {
      return first.back();
    }

    /**
     * Gathers the items of all ranks, @p size bytes each, on all ranks.
     * Collective.
     */
    void gather(const void *mine, std::size_t size, void *all) const;

    std::vector<int> sizes, first;

  private:
    MPI_Comm communicator;
  };

  /**
   * Concatenates the items of all ranks on all ranks. Collective. deal.II's
   * all_gather() would compress them, which is slower to run and to compile.
   */
  template <typename T>
  std::vector<T> gather_over_ranks(const std::vector<T> &mine,
                                   const MPI_Comm        communicator)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    const ItemsOfRanks items(mine.size(), communicator);
    std::vector<T>     all(items.n());
    items.gather(mine.data(), sizeof(T), all.data());
    return all;
  }

  /**
   * Results of @p result_of for the numbers 0 to @p n - 1, the same on all
   * ranks; long lists are divided among the ranks. Collective.
   */
  template <class ResultOf>
  auto shared_results(const std::size_t    n,
                      const UnknownLayout &layout,
                      const ResultOf      &result_of)
  {
    // For fewer items, communication costs more than the work.
    constexpr std::size_t many      = 1000;
    const bool            is_shared = layout.n_ranks() > 1 && n >= many;
    const auto [begin, end] =
      is_shared ? share_of_rank(layout, n) : std::array<std::size_t, 2>{{0, n}};
    std::vector<decltype(result_of(begin))> results;
    results.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i)
      results.push_back(result_of(i));
    return is_shared ? gather_over_ranks(results, layout.communicator())
                     : results;
  }

  /**
   * Values of all ranks' unknowns by global number: @p mine on one rank, else
   * gathered into @p room. Collective.
   */
  inline const std::vector<double> &
  by_global_number(const std::vector<double> &mine,
                   const UnknownLayout       &layout,
                   std::vector<double>       &room)
  {
    if (layout.n_ranks() == 1)
      return mine;
    room.resize(layout.n_global());
    ItemsOfRanks(layout).gather(mine.data(), sizeof(double), room.data());
    return room;
  }

  /** Texts of all ranks on all ranks. Collective. */
  std::vector<std::string> gather_texts(const std::string &mine,
                                        MPI_Comm           communicator);

  /** Broadcasts @p text of @p rank. Collective. */
  std::string
  broadcast_text(unsigned int rank, std::string text, MPI_Comm communicator);
  ///@}

  /** Numbers of values, by rank. */
  using SizesByRank = std::map<unsigned int, std::size_t>;

  /** Repeated exchange of messages of fixed lengths between known ranks. */
  class NeighbourExchange
  {
  public:
    /** An exchange without messages. */
    NeighbourExchange() = default;

    /**
     * @param sent, received numbers of values by rank, consistent between the
     *   ranks.
     */
    NeighbourExchange(MPI_Comm           communicator,
                      const SizesByRank &sent,
                      const SizesByRank &received);

    /**
     * Sends @p values, concatenated by rank, and returns the received ones in
     * the same order. Collective.
     */
    template <typename T>
    std::vector<T> exchange(const std::vector<T> &values) const
    {
      static_assert(std::is_trivially_copyable_v<T>);
      std::vector<T> received_values(std::accumulate(
        received.begin(),
        received.end(),
        std::size_t(0),
        [](const std::size_t n, const auto &item) { return n + item.second; }));
      transfer(values.data(), sizeof(T), received_values.data());
      return received_values;
    }

  private:
    /** Transfers values of @p size bytes each. */
    void
    transfer(const void *values, std::size_t size, void *received_values) const;

    MPI_Comm    communicator = MPI_COMM_NULL;
    SizesByRank sent, received;
  };

  /**
   * Numbers of values that other ranks send to this one, from the numbers that
   * each sends. Collective.
   */
  SizesByRank received_sizes(const SizesByRank &sent, MPI_Comm communicator);

  /** Lists of other ranks, by rank. */
  template <typename T>
  using ListsByRank = std::map<unsigned int, std::vector<T>>;

  /** Concatenates the lists of all ranks, in ascending order of ranks. */
  template <typename T>
  std::vector<T> concatenated(const ListsByRank<T> &lists)
  {
    std::vector<T> all;
    for (const auto &[rank, list] : lists)
      all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  /** Length of each list times @p factor. */
  template <typename T>
  SizesByRank lengths(const ListsByRank<T> &lists, const std::size_t factor = 1)
  {
    SizesByRank n;
    for (const auto &[rank, list] : lists)
      n[rank] = list.size() * factor;
    return n;
  }

  /**
   * Sends each rank its list and returns the received lists. Collective.
   * deal.II's some_to_some() would compress them, which is slower.
   */
  template <typename T>
  ListsByRank<T> exchange_lists(const ListsByRank<T> &for_others,
                                const MPI_Comm        communicator)
  {
    const SizesByRank    sent     = lengths(for_others);
    const SizesByRank    received = received_sizes(sent, communicator);
    const std::vector<T> values =
      NeighbourExchange(communicator, sent, received)
        .exchange(concatenated(for_others));
    ListsByRank<T> lists;
    auto           next = values.begin();
    for (const auto &[rank, n] : received)
      {
        lists[rank].assign(next, next + n);
        next += n;
      }
    return lists;
  }

  /** Message size that MPI counts with an int. */
  inline constexpr std::size_t max_message_bytes = 1 << 30;

  /** Sends @p n values to the first rank, which calls receive(). */
  template <typename T>
  void send_to_first(const T          *values,
                     const std::size_t n,
                     const MPI_Comm    communicator)
  {
    const char *const bytes = reinterpret_cast<const char *>(values);
    for (std::size_t at = 0; at < n * sizeof(T); at += max_message_bytes)
      MPI_Send(bytes + at,
               std::min(max_message_bytes, n * sizeof(T) - at),
               MPI_BYTE,
               0,
               0,
               communicator);
  }

  /** Receives the values of send_to_first() of the rank @p from. */
  template <typename T>
  void receive(T                 *values,
               const std::size_t  n,
               const unsigned int from,
               const MPI_Comm     communicator)
  {
    char *const bytes = reinterpret_cast<char *>(values);
    for (std::size_t at = 0; at < n * sizeof(T); at += max_message_bytes)
      MPI_Recv(bytes + at,
               std::min(max_message_bytes, n * sizeof(T) - at),
               MPI_BYTE,
               from,
               0,
               communicator,
               MPI_STATUS_IGNORE);
  }
} // namespace auxfem

#endif
