#include <auxfem/mesh/strut_mesh.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  Lattice stars(const unsigned int nx, const unsigned int ny)
  {
    return make_array(cell_from_text("star", "")->build(), {{nx, ny, 1}});
  }

  /** Equally many elements in all struts. */
  std::vector<StrutDivision> all_in(const Lattice     &lattice,
                                    const unsigned int n_elements)
  {
    return std::vector<StrutDivision>(lattice.struts.size(), {2, n_elements});
  }

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

TEST(StrutMesh, EveryStrutIsAChainOfItsOwn)
{
  const Lattice   lattice = stars(2, 2);
  const StrutMesh mesh(lattice, all_in(lattice, 4), MPI_COMM_WORLD);
  EXPECT_EQ(mesh.triangulation().n_active_cells(), 4 * lattice.struts.size());
  EXPECT_EQ(mesh.triangulation().n_used_vertices(), 5 * lattice.struts.size());
}

TEST(StrutMesh, PlacesTellWhereACellLies)
{
  // So many that places need most digits of the strut's number.
  const Lattice              lattice   = stars(20, 20);
  std::vector<StrutDivision> divisions = all_in(lattice, 1);
  for (unsigned int s = 0; s < divisions.size(); ++s)
    divisions[s].n_elements = 1 + s % 8;
  const StrutMesh mesh(lattice, divisions, MPI_COMM_WORLD);

  std::vector<unsigned int> found(lattice.struts.size(), 0);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    {
      const StrutMesh::Interval interval = mesh.interval(cell);
      const double              n = divisions.at(interval.strut).n_elements;
      const unsigned int        number = found[interval.strut]++;
      EXPECT_EQ(interval.begin, number / n);
      EXPECT_EQ(interval.end, (number + 1) / n);
      EXPECT_EQ(interval.number(), number);
    }
  for (unsigned int s = 0; s < divisions.size(); ++s)
    EXPECT_EQ(found[s], divisions[s].n_elements);
}

TEST(StrutMesh, CellsOfAStrutFollowOneAnother)
{
  const Lattice   lattice = stars(2, 1);
  const StrutMesh mesh(lattice, all_in(lattice, 4), MPI_COMM_WORLD);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    {
      const StrutMesh::Interval interval = mesh.interval(cell);
      for (const unsigned int end : {0, 1})
        {
          const bool at_end =
            end == 0 ? interval.begin == 0. : interval.end == 1.;
          ASSERT_EQ(cell->at_boundary(end), at_end);
          if (at_end)
            continue;
          const StrutMesh::Interval next = mesh.interval(cell->neighbor(end));
          EXPECT_EQ(next.strut, interval.strut);
          EXPECT_EQ(end == 0 ? next.end : next.begin,
                    end == 0 ? interval.begin : interval.end);
        }
    }
}

TEST(StrutMesh, RigidStrutsHaveNoCells)
{
  Lattice lattice              = stars(2, 2);
  lattice.struts[0].rigid_part = lattice.struts[7].rigid_part = 0;
  const StrutMesh        mesh(lattice, all_in(lattice, 2), MPI_COMM_WORLD);
  std::set<unsigned int> struts;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    struts.insert(mesh.interval(cell).strut);
  EXPECT_EQ(struts.size(), lattice.struts.size() - 2);
  EXPECT_EQ(struts.count(0), 0u);
  EXPECT_EQ(struts.count(7), 0u);
  EXPECT_EQ(*struts.rbegin(), lattice.struts.size() - 1);
}

TEST(StrutMesh, AnUnrefinedStrutIsOneCell)
{
  const Lattice   lattice = stars(1, 1);
  const StrutMesh mesh(lattice, all_in(lattice, 1), MPI_COMM_WORLD);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    {
      const StrutMesh::Interval interval = mesh.interval(cell);
      EXPECT_EQ(interval.begin, 0.);
      EXPECT_EQ(interval.end, 1.);
    }
}

TEST(StrutMesh, OneRankOwnsAllStruts)
{
  const std::vector<unsigned int> ranks = partition_struts(stars(2, 2), 1);
  EXPECT_EQ(ranks, std::vector<unsigned int>(48, 0));
}

TEST(StrutMesh, MetisDividesTheStrutsEvenlyAndInOnePieceEach)
{
  const Lattice lattice = stars(10, 10);
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

TEST(StrutMesh, ArraysInSpaceAreDividedEvenly)
{
  const Lattice lattice =
    make_array(cell_from_text("space star", "", ".", 3)->build(), {{4, 4, 4}});
  const std::vector<unsigned int> ranks = partition_struts(lattice, 4);
  const double                    even  = double(lattice.struts.size()) / 4;
  for (const unsigned int size : sizes(ranks, 4))
    // METIS balances recursive bisections to a few per cent.
    EXPECT_NEAR(size, even, 0.05 * even);
}

TEST(StrutMesh, ACutMeetsFewJoints)
{
  const Lattice                       lattice = stars(10, 10);
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

TEST(StrutMesh, CellsBelongToTheRankOfTheirStrut)
{
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const Lattice   lattice = stars(3, 3);
  const StrutMesh mesh(lattice, all_in(lattice, 4), MPI_COMM_WORLD);
  const std::vector<unsigned int> ranks = partition_struts(lattice, n_ranks);
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    EXPECT_EQ(cell->subdomain_id(), ranks[mesh.interval(cell).strut]);
}

TEST(StrutMesh, TooManyRanksAreRefused)
{
  EXPECT_ANY_THROW(partition_struts(stars(1, 1), 13));
}
