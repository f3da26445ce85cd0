#include <auxfem/algebra/rank_exchange.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  namespace mpi = dealii::Utilities::MPI;

  struct Message
  {
    unsigned int from, number;
    double       value;
  };

  /** Rank r has s + 1 items for rank s, but none if both are even. */
  std::size_t n_items(const unsigned int from, const unsigned int to)
  {
    return from % 2 == 0 && to % 2 == 0 ? 0 : to + 1;
  }

  TEST(NeighbourExchange, EveryRankReceivesItsItems)
  {
    const unsigned int here    = mpi::this_mpi_process(MPI_COMM_WORLD),
                       n_ranks = mpi::n_mpi_processes(MPI_COMM_WORLD);
    ListsByRank<Message> for_others;
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      for (unsigned int i = 0; i < n_items(here, rank); ++i)
        for_others[rank].push_back({here, i, 0.5 * i});

    const ListsByRank<Message> received =
      exchange_lists(for_others, MPI_COMM_WORLD);

    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      {
        const auto list = received.find(rank);
        ASSERT_EQ(list == received.end(), n_items(rank, here) == 0);
        if (list == received.end())
          continue;
        ASSERT_EQ(list->second.size(), n_items(rank, here));
        for (unsigned int i = 0; i < list->second.size(); ++i)
          {
            EXPECT_EQ(list->second[i].from, rank);
            EXPECT_EQ(list->second[i].number, i);
            EXPECT_EQ(list->second[i].value, 0.5 * i);
          }
      }
  }

  TEST(NeighbourExchange, RepeatsWithNewValues)
  {
    // Exchange in a ring.
    const unsigned int here    = mpi::this_mpi_process(MPI_COMM_WORLD),
                       n_ranks = mpi::n_mpi_processes(MPI_COMM_WORLD),
                       next    = (here + 1) % n_ranks,
                       last    = (here + n_ranks - 1) % n_ranks;
    const NeighbourExchange ring(MPI_COMM_WORLD, {{next, 2}}, {{last, 2}});
    for (double value : {1., 2.5})
      EXPECT_EQ(ring.exchange(std::vector<double>{value, 1. * here}),
                (std::vector<double>{value, 1. * last}));
  }
} // namespace
