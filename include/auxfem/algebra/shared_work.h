#ifndef auxfem_algebra_shared_work_h
#define auxfem_algebra_shared_work_h

#include <auxfem/algebra/unknown_layout.h>

#include <array>
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
  std::vector<T> of_all_ranks(const std::vector<T> &mine,
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
    return is_shared ? of_all_ranks(results, layout.communicator()) : results;
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
} // namespace auxfem

#endif
