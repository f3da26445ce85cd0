#include <auxfem/algebra/rank_exchange.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  namespace mpi = dealii::Utilities::MPI;

  struct Item
  {
    unsigned int number;
    double       value;
  };

  /** As many items as the rank's number. */
  std::vector<Item> items_of(const unsigned int rank)
  {
    std::vector<Item> items;
    for (unsigned int i = 0; i < rank; ++i)
      items.push_back({i, 0.5 * rank});
    return items;
  }

  TEST(SharedWork, ItemsOfAllRanksFollowEachOther)
  {
    const unsigned int      n_ranks = mpi::n_mpi_processes(MPI_COMM_WORLD);
    const std::vector<Item> all =
      gather_over_ranks(items_of(mpi::this_mpi_process(MPI_COMM_WORLD)),
                        MPI_COMM_WORLD);
    ASSERT_EQ(all.size(), n_ranks * (n_ranks - 1) / 2);
    std::size_t next = 0;
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      for (const Item &item : items_of(rank))
        {
          EXPECT_EQ(all[next].number, item.number);
          EXPECT_EQ(all[next].value, item.value);
          ++next;
        }
    EXPECT_EQ(gather_over_ranks<int>({3}, MPI_COMM_WORLD),
              std::vector<int>(n_ranks, 3));
  }

  TEST(SharedWork, TextsOfAllRanksMayBeEmpty)
  {
    const auto text_of = [](const unsigned int rank) {
      return std::string(3 * rank, static_cast<char>('a' + rank));
    };
    const std::vector<std::string> texts =
      gather_texts(text_of(mpi::this_mpi_process(MPI_COMM_WORLD)),
                   MPI_COMM_WORLD);
    ASSERT_EQ(texts.size(), mpi::n_mpi_processes(MPI_COMM_WORLD));
    for (unsigned int rank = 0; rank < texts.size(); ++rank)
      EXPECT_EQ(texts[rank], text_of(rank));
  }

  TEST(SharedWork, EveryRankReceivesTheTextOfOne)
  {
    const unsigned int last = mpi::n_mpi_processes(MPI_COMM_WORLD) - 1;
    EXPECT_EQ(broadcast_text(last,
                             "of rank " +
                               std::to_string(
                                 mpi::this_mpi_process(MPI_COMM_WORLD)),
                             MPI_COMM_WORLD),
              "of rank " + std::to_string(last));
  }

  TEST(SharedWork, IsDividedWithoutGaps)
  {
    const UnknownLayout layout(MPI_COMM_WORLD, 1, {});
    const std::size_t   n    = 7;
    const auto          mine = share_of_rank(layout, n);
    EXPECT_LE(mine[0], mine[1]);
    std::vector<std::size_t> bounds =
      gather_over_ranks<std::size_t>({mine[0], mine[1]}, MPI_COMM_WORLD);
    EXPECT_EQ(bounds.front(), 0u);
    EXPECT_EQ(bounds.back(), n);
    for (std::size_t i = 1; i + 1 < bounds.size(); i += 2)
      EXPECT_EQ(bounds[i], bounds[i + 1]);
  }

  TEST(SharedWork, RanksShareManyResultsOnly)
  {
    const UnknownLayout layout(MPI_COMM_WORLD, 1, {});
    for (const std::size_t n : {0, 7, 3001})
      {
        std::size_t n_mine = 0;
        const auto  results =
          shared_results(n, layout, [&](const std::size_t i) {
            ++n_mine;
            return Item{static_cast<unsigned int>(i), i / 2.};
          });
        ASSERT_EQ(results.size(), n);
        for (std::size_t i = 0; i < n; ++i)
          {
            EXPECT_EQ(results[i].number, i);
            EXPECT_EQ(results[i].value, i / 2.);
          }
        const auto mine = share_of_rank(layout, n);
        EXPECT_EQ(n_mine, n < 1000 ? n : mine[1] - mine[0]);
      }
  }
} // namespace
