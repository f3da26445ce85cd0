#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_mesh.h>

#include <gtest/gtest.h>

#include <numeric>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  /** Equally many elements in all struts. */
  std::vector<StrutDivision> all_in(const Lattice     &lattice,
                                    const unsigned int n_elements)
  {
    return std::vector<StrutDivision>(lattice.struts.size(), {2, n_elements});
  }

  std::vector<unsigned int> all_struts(const Lattice &lattice)
  {
    std::vector<unsigned int> struts(lattice.struts.size());
    std::iota(struts.begin(), struts.end(), 0u);
    return struts;
  }
} // namespace

TEST(StrutMesh, EveryStrutIsAChainOfItsOwn)
{
  const Lattice                    lattice   = array_of_stars(2, 2);
  const std::vector<StrutDivision> divisions = all_in(lattice, 4);
  const StrutMesh                  mesh(divisions, all_struts(lattice));
  EXPECT_EQ(mesh.triangulation().n_active_cells(), 4 * lattice.struts.size());
  EXPECT_EQ(mesh.triangulation().n_used_vertices(), 5 * lattice.struts.size());
}

TEST(StrutMesh, IntervalsOfCells)
{
  // Many struts: their numbers take most digits of the vertices' positions.
  const Lattice              lattice   = array_of_stars(20, 20);
  std::vector<StrutDivision> divisions = all_in(lattice, 1);
  for (unsigned int s = 0; s < divisions.size(); ++s)
    divisions[s].n_elements = 1 + s % 8;
  const StrutMesh mesh(divisions, all_struts(lattice));

  std::vector<unsigned int> found(lattice.struts.size(), 0);
  for (const StrutInterval &interval : mesh.intervals())
    {
      const double       n      = divisions.at(interval.strut).n_elements;
      const unsigned int number = found[interval.strut]++;
      EXPECT_EQ(interval.begin, number / n);
      EXPECT_EQ(interval.end, (number + 1) / n);
      EXPECT_EQ(interval.number(), number);
    }
  for (unsigned int s = 0; s < divisions.size(); ++s)
    EXPECT_EQ(found[s], divisions[s].n_elements);
}

TEST(StrutMesh, CellsOfAStrutFollowOneAnother)
{
  const Lattice                    lattice   = array_of_stars(2, 1);
  const std::vector<StrutDivision> divisions = all_in(lattice, 4);
  const StrutMesh                  mesh(divisions, all_struts(lattice));
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
    {
      const StrutInterval interval = mesh.interval(cell);
      for (const unsigned int end : {0, 1})
        {
          const bool at_end =
            end == 0 ? interval.begin == 0. : interval.end == 1.;
          ASSERT_EQ(cell->at_boundary(end), at_end);
          if (at_end)
            continue;
          const StrutInterval next = mesh.interval(cell->neighbor(end));
          EXPECT_EQ(next.strut, interval.strut);
          EXPECT_EQ(end == 0 ? next.end : next.begin,
                    end == 0 ? interval.begin : interval.end);
        }
    }
}

TEST(StrutMesh, HasTheGivenStrutsOnly)
{
  const std::vector<StrutDivision> divisions = all_in(array_of_stars(2, 2), 2);
  std::vector<unsigned int>        struts;
  for (const StrutInterval &interval :
       StrutMesh(divisions, {3, 7, 40}).intervals())
    struts.push_back(interval.strut);
  EXPECT_EQ(struts, std::vector<unsigned int>({3, 3, 7, 7, 40, 40}));
  EXPECT_TRUE(StrutMesh(divisions, {}).intervals().empty());
}

TEST(StrutMesh, AnUnrefinedStrutIsOneCell)
{
  const Lattice                    lattice   = array_of_stars(1, 1);
  const std::vector<StrutDivision> divisions = all_in(lattice, 1);
  for (const StrutInterval &interval :
       StrutMesh(divisions, all_struts(lattice)).intervals())
    {
      EXPECT_EQ(interval.begin, 0.);
      EXPECT_EQ(interval.end, 1.);
    }
}
