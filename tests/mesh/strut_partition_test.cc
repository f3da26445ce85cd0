#include <auxfem/mesh/strut_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  /** Number of struts of each rank. */
  std::vector<unsigned int> sizes(const std::vector<unsigned int> &ranks,
                                  const unsigned int               n_ranks)
  {
    std::vector<unsigned int> count(n_ranks, 0);
    for (const unsigned int rank : ranks)
      ++count.at(rank);
    return count;
  }

  /** Number of connected pieces the struts of @p rank fall into. */
  unsigned int n_pieces(const Lattice                   &lattice,
                        const std::vector<unsigned int> &ranks,
                        const unsigned int               rank)
  {
    std::vector<unsigned int> piece(lattice.joints.size());
    for (unsigned int j = 0; j < piece.size(); ++j)
      piece[j] = j;
    std::set<unsigned int> used;
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      if (ranks[s] == rank)
        {
          const auto [first, second] = lattice.struts[s].joints;
          used.insert({first, second});
          const unsigned int from = piece[second], to = piece[first];
          std::replace(piece.begin(), piece.end(), from, to);
        }
    std::set<unsigned int> pieces;
    for (const unsigned int joint : used)
      pieces.insert(piece[joint]);
    return pieces.size();
  }
} // namespace

TEST(StrutPartition, OneRankOwnsAllStruts)
{
  const std::vector<unsigned int> ranks =
    partition_struts(array_of_stars(2, 2), 1);
  EXPECT_EQ(ranks, std::vector<unsigned int>(48, 0));
}

TEST(StrutPartition, MetisDividesTheStrutsEvenlyAndInOnePieceEach)
{
  const Lattice lattice = array_of_stars(10, 10);
  for (const unsigned int n_ranks : {2, 4})
    {
      const std::vector<unsigned int> ranks =
        partition_struts(lattice, n_ranks);
      ASSERT_EQ(ranks.size(), lattice.struts.size());
      const double even = double(lattice.struts.size()) / n_ranks;
      for (const unsigned int size : sizes(ranks, n_ranks))
        // METIS balances recursive bisections to a few per cent.
        EXPECT_NEAR(size, even, 0.05 * even);
      for (unsigned int rank = 0; rank < n_ranks; ++rank)
        EXPECT_EQ(n_pieces(lattice, ranks, rank), 1u);
    }
}

TEST(StrutPartition, ArraysInSpaceAreDividedEvenly)
{
  const Lattice lattice =
    make_array(cell_from_text("space star", "", ".", 3)->build(), {{4, 4, 4}});
  const std::vector<unsigned int> ranks = partition_struts(lattice, 4);
  const double                    even  = double(lattice.struts.size()) / 4;
  for (const unsigned int size : sizes(ranks, 4))
    // METIS balances recursive bisections to a few per cent.
    EXPECT_NEAR(size, even, 0.05 * even);
}

TEST(StrutPartition, ManyCellsAreNotDivided)
{
  const Lattice                   lattice = array_of_stars(15, 15);
  const std::vector<unsigned int> ranks   = partition_struts(lattice, 2);
  std::vector<unsigned int>       rank_of_cell(lattice.n_cells, 2);
  for (unsigned int s = 0; s < ranks.size(); ++s)
    {
      unsigned int &rank = rank_of_cell[lattice.struts[s].cell];
      EXPECT_TRUE(rank == 2 || rank == ranks[s]);
      rank = ranks[s];
    }
  const double even = double(ranks.size()) / 2;
  for (const unsigned int size : sizes(ranks, 2))
    EXPECT_NEAR(size, even, 0.05 * even);
  for (unsigned int rank = 0; rank < 2; ++rank)
    EXPECT_EQ(n_pieces(lattice, ranks, rank), 1u);
}

TEST(StrutPartition, ACutMeetsFewJoints)
{
  const Lattice                       lattice = array_of_stars(10, 10);
  const std::vector<unsigned int>     ranks   = partition_struts(lattice, 2);
  std::vector<std::set<unsigned int>> ranks_at(lattice.joints.size());
  for (unsigned int s = 0; s < lattice.struts.size(); ++s)
    for (const unsigned int joint : lattice.struts[s].joints)
      ranks_at[joint].insert(ranks[s]);
  const auto n_shared =
    std::count_if(ranks_at.begin(), ranks_at.end(), [](const auto &r) {
      return r.size() > 1;
    });
  // A straight cut through the stubs of 10 cells meets 10 joints; METIS is
  // heuristic, a random division would share most of the 1020 joints.
  EXPECT_GE(n_shared, 1);
  EXPECT_LE(n_shared, 30);
}

TEST(StrutPartition, TooManyRanksAreRefused)
{
  EXPECT_ANY_THROW(partition_struts(array_of_stars(1, 1), 13));
}
