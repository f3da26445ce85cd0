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

  /** How many of all ranks' items each has, and of those of all ranks, one
   * after the other, each one's first and the end. */
  class ItemsOfRanks
  {
  public:
    /** Collective. @param n_mine number of items of this rank */
    ItemsOfRanks(std::size_t n_mine, MPI_Comm communicator);

    /** Of the unknowns that each rank owns. */
    explicit ItemsOfRanks(const UnknownLayout &layout);

    std::size_t n() const
    {
      return first.back();
    }

    /** Brings the items of all ranks, @p size bytes each, to all of them.
     * Collective. */
    void gather(const void *mine, std::size_t size, void *all) const;

    std::vector<int> sizes, first;

  private:
    MPI_Comm communicator;
  };

  /** What the ranks have, one after the other, on all of them. Collective.
   * deal.II's all_gather() would compress it, which takes longer than all else,
   * and longest to compile. */
  template <typename T>
  std::vector<T> over_all_ranks(const std::vector<T> &mine,
                                const MPI_Comm        communicator)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    const ItemsOfRanks items(mine.size(), communicator);
    std::vector<T>     all(items.n());
    items.gather(mine.data(), sizeof(T), all.data());
    return all;
  }

  /** What @p result_of makes of each of @p n items, by its number; of many each
   * rank looks at a share. The same on all ranks. Collective. */
  template <class ResultOf>
  auto shared_results(const std::size_t    n,
                      const UnknownLayout &layout,
                      const ResultOf      &result_of)
  {
    // Fewer are looked at sooner than ranks tell each other of them.
    constexpr std::size_t many      = 1000;
    const bool            is_shared = layout.n_ranks() > 1 && n >= many;
    const auto [begin, end] =
      is_shared ? share_of_rank(layout, n) : std::array<std::size_t, 2>{{0, n}};
    std::vector<decltype(result_of(begin))> results;
    results.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i)
      results.push_back(result_of(i));
    return is_shared ? over_all_ranks(results, layout.communicator()) : results;
  }

  /** Values of all ranks' unknowns by global number: @p mine on one rank, else
   * brought into @p room. Collective. */
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

  /** The texts of all ranks on all of them. Collective. */
  std::vector<std::string> texts_of_all_ranks(const std::string &mine,
                                              MPI_Comm           communicator);

  /** On every rank, @p text of @p rank. Collective. */
  std::string
  text_of_rank(unsigned int rank, std::string text, MPI_Comm communicator);
  ///@}

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
  SizesByRank received_sizes(const SizesByRank &sent, MPI_Comm communicator);

  /** Of other ranks, by rank. */
  template <typename T>
  using ListsByRank = std::map<unsigned int, std::vector<T>>;

  /** Those of all ranks, in the order of these. */
  template <typename T>
  std::vector<T> concatenated(const ListsByRank<T> &lists)
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
    const SizesByRank    received = received_sizes(sent, communicator);
    const std::vector<T> comes = NeighbourExchange(communicator, sent, received)
                                   .exchange(concatenated(for_others));
    ListsByRank<T> lists;
    auto           next = comes.begin();
    for (const auto &[rank, n] : received)
      {
        lists[rank].assign(next, next + n);
        next += n;
      }
    return lists;
  }

  /** More do not fit into the int of one message. */
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

  /** What the rank @p from has sent by send_to_first(). */
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
