#include <auxfem/mesh/cell.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  /** A unit square of four struts whose neighbours share a side. */
  UnitCell square()
  {
    UnitCell cell;
    cell.joints            = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    cell.struts            = {{0, 1, 0, {"rails"}},
                              {1, 2, 0, {"posts"}},
                              {3, 2, 0, {"rails"}},
                              {0, 3, 0, {"posts"}}};
    cell.vectors[0][0]     = 1;
    cell.vectors[1][1]     = 1;
    cell.pairs["diagonal"] = {{0, 2}};
    cell.pairs["left"]     = {{0, 3}, {1, 2}};
    return cell;
  }
} // namespace

TEST(Array, SharedStrutsAreKeptOnce)
{
  const auto lattice = make_array(square(), {{3, 2, 1}});
  EXPECT_EQ(lattice.n_cells, 6u);
  EXPECT_EQ(lattice.joints.size(), 12u);
  EXPECT_EQ(lattice.struts.size(), 17u);
  EXPECT_EQ(lattice.strut_sets.at("rails").size(), 9u);
  EXPECT_EQ(lattice.strut_sets.at("posts").size(), 8u);
  EXPECT_EQ(lattice.strut_sets.at("all").size(), 17u);
}

TEST(Array, SharedPairsAreKeptOnce)
{
  const auto lattice = make_array(square(), {{3, 1, 1}});
  EXPECT_EQ(lattice.pair_sets.at("diagonal").size(), 3u);
  EXPECT_EQ(lattice.pair_sets.at("left").size(), 4u);
}

TEST(Array, PairsAcrossLinkCellsThatHaveANextOne)
{
  UnitCell cell             = square();
  cell.pairs_across["skew"] = {{0, 2, {{1, 0, 0}}}, {1, 3, {{0, 1, 0}}}};
  const auto lattice        = make_array(cell, {{3, 2, 1}});
  // Two neighbours along x in each of two rows, one along y in three columns.
  const auto &pairs = lattice.pair_sets.at("skew");
  ASSERT_EQ(pairs.size(), 7u);
  unsigned int n_along_x = 0;
  for (const auto &pair : pairs)
    {
      const dealii::Point<3> corner(pair.cell % 3, pair.cell / 3, 0);
      const auto             from = lattice.joints[pair.first] - corner;
      const auto             to   = lattice.joints[pair.second] - corner;
      if (from[0] == 0)
        {
          ++n_along_x;
          EXPECT_LT(pair.cell % 3, 2u);
          EXPECT_EQ(from, dealii::Point<3>(0, 0, 0));
          EXPECT_EQ(to, dealii::Point<3>(2, 1, 0));
        }
      else
        {
          EXPECT_LT(pair.cell, 3u);
          EXPECT_EQ(from, dealii::Point<3>(1, 0, 0));
          EXPECT_EQ(to, dealii::Point<3>(0, 2, 0));
        }
    }
  EXPECT_EQ(n_along_x, 4u);
}

TEST(Array, PairsAcrossInSpace)
{
  UnitCell cell;
  cell.joints                = {{0, 0, 0}, {0, 0, 0.5}};
  cell.struts                = {{0, 1}};
  cell.pairs_across["seats"] = {{1, 0, {{0, 0, 1}}}};
  for (unsigned int d = 0; d < 3; ++d)
    cell.vectors[d][d] = 1;
  const auto  lattice = make_array(cell, {{2, 2, 3}});
  const auto &pairs   = lattice.pair_sets.at("seats");
  ASSERT_EQ(pairs.size(), 8u);
  for (unsigned int i = 0; i < pairs.size(); ++i)
    {
      EXPECT_EQ(pairs[i].cell, i);
      EXPECT_EQ(lattice.joints[pairs[i].second] -
                  lattice.joints[pairs[i].first],
                (dealii::Point<3>(0, 0, 0.5)));
    }
}

TEST(Array, PairsAcrossMayBeMissing)
{
  UnitCell cell               = square();
  cell.pairs_across["x"]      = {{1, 3, {{1, 0, 0}}}};
  cell.pairs_across["shared"] = {{1, 0, {{1, 0, 0}}}};
  // One cell has no neighbour.
  const auto one = make_array(cell, {{1, 2, 1}});
  EXPECT_TRUE(one.pair_sets.at("x").empty());
  EXPECT_TRUE(one.pair_sets.at("shared").empty());
  // The lower right joint of a cell is the lower left one of the next.
  const auto two = make_array(cell, {{2, 1, 1}});
  EXPECT_EQ(two.pair_sets.at("x").size(), 1u);
  EXPECT_TRUE(two.pair_sets.at("shared").empty());
}

TEST(Array, CellsAreNumberedAlongXFirst)
{
  const auto lattice = make_array(square(), {{3, 2, 1}});
  const auto pairs   = lattice.pair_sets.at("diagonal");
  for (unsigned int i = 0; i < pairs.size(); ++i)
    {
      EXPECT_EQ(pairs[i].cell, i);
      EXPECT_EQ(lattice.joints[pairs[i].first],
                dealii::Point<3>(i % 3, i / 3, 0));
    }
  EXPECT_EQ(lattice.struts.back().cell, 5u);
}

TEST(Array, WithoutPortsTheFacesOfTheBoundingBoxAreSets)
{
  const auto lattice = make_array(square(), {{3, 2, 1}});
  EXPECT_EQ(lattice.joint_sets.at("left").size(), 3u);
  EXPECT_EQ(lattice.joint_sets.at("right").size(), 3u);
  EXPECT_EQ(lattice.joint_sets.at("bottom").size(), 4u);
  EXPECT_EQ(lattice.joint_sets.at("top").size(), 4u);
  for (const auto joint : lattice.joint_sets.at("top"))
    EXPECT_EQ(lattice.joints[joint][1], 2);
  EXPECT_EQ(lattice.joint_sets.count("front"), 0u);
}

TEST(Array, CubesHaveFrontAndBack)
{
  UnitCell cell;
  for (unsigned int i = 0; i < 8; ++i)
    cell.joints.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  cell.struts = {{0, 4}};
  for (unsigned int d = 0; d < 3; ++d)
    cell.vectors[d][d] = 1;
  const auto lattice = make_array(cell, {{2, 2, 2}});
  EXPECT_EQ(lattice.joints.size(), 27u);
  EXPECT_EQ(lattice.joint_sets.at("front").size(), 9u);
  EXPECT_EQ(lattice.joint_sets.at("back").size(), 9u);
}

TEST(Array, ArcsToBothSidesOfAChordAreTwoStruts)
{
  UnitCell cell = square();
  cell.struts   = {{0, 3, 0.1}, {1, 2, -0.1}, {1, 2, 0.2}};
  // Inner posts carry 0.1, -0.1 and 0.2; outer ones 0.1 or -0.1 and 0.2.
  EXPECT_EQ(make_array(cell, {{2, 1, 1}}).struts.size(), 6u);
  // The same arc seen from its other end is one strut.
  cell.struts = {{0, 3, 0.1}, {2, 1, -0.1}};
  EXPECT_EQ(make_array(cell, {{2, 1, 1}}).struts.size(), 3u);
}

TEST(Array, ArcsInTwoPlanesOverAChordAreTwoStruts)
{
  const dealii::Tensor<1, 3> along_x = dealii::Point<3>(1, 0, 0);
  UnitCell                   cell    = square();
  // Outer posts carry one of the two, the inner one both.
  cell.struts = {{0, 3, 0.1, {}, along_x}, {1, 2, 0.1}};
  EXPECT_EQ(make_array(cell, {{2, 1, 1}}).struts.size(), 4u);
  // The same arc seen from the other side of its plane is one strut.
  cell.struts = {{0, 3, 0.1, {}, along_x}, {1, 2, -0.1, {}, -along_x}};
  EXPECT_EQ(make_array(cell, {{2, 1, 1}}).struts.size(), 3u);
}

TEST(Array, StrutsAcrossLinkCellsThatHaveANextOne)
{
  UnitCell cell      = square();
  cell.struts_across = {{"braces", {{0, 2, {{1, 0, 0}}}}},
                        {"walls", {{0, 3, {{0, 1, 0}}}}}};
  const auto lattice = make_array(cell, {{3, 2, 1}});
  // Two neighbours along x in each of two rows, one along y in three columns.
  EXPECT_EQ(lattice.struts.size(), 17u + 4u + 3u);
  EXPECT_EQ(lattice.strut_sets.at("braces").size(), 4u);
  EXPECT_EQ(lattice.strut_sets.at("walls").size(), 3u);
  const auto &brace = lattice.struts[lattice.strut_sets.at("braces")[3]];
  EXPECT_EQ(brace.cell, 4u);
  EXPECT_EQ(lattice.joints[brace.joints[0]], dealii::Point<3>(1, 1, 0));
  EXPECT_EQ(lattice.joints[brace.joints[1]], dealii::Point<3>(3, 2, 0));
}

TEST(Array, JointsOfOneCellStayApart)
{
  UnitCell cell;
  cell.joints = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  cell.struts = {{0, 1}, {2, 3}};
  EXPECT_EQ(make_array(cell, {{1, 1, 1}}).joints.size(), 4u);
}

TEST(Array, RoundOffOfCellCentresDoesNotSplitJoints)
{
  UnitCell cell      = square();
  cell.vectors[0][0] = 0.1 * 3;
  cell.joints[1] = cell.joints[2] = {0.3, 0, 0};
  cell.joints[2][1]               = 1;
  const auto lattice              = make_array(cell, {{200, 1, 1}});
  EXPECT_EQ(lattice.joints.size(), 402u);
}

TEST(Array, RefusesToRepeatWithoutPeriod)
{
  UnitCell cell             = square();
  cell.vectors[1][1]        = 0;
  cell.no_vector_reasons[1] = "It has a roof.";
  const auto message = input_error_of([&]() { make_array(cell, {{1, 3, 1}}); });
  EXPECT_TRUE(contains(message, "3 cells along y")) << message;
  EXPECT_TRUE(contains(message, "It has a roof.")) << message;
  EXPECT_TRUE(contains(input_error_of([&]() {
                         make_array(cell, {{0, 1, 1}});
                       }),
                       "along x is 0"));
}

TEST(Array, LargeStarArray)
{
  const auto cell    = cell_from_text("star", "")->build();
  const auto lattice = make_array(cell, {{100, 100, 1}});
  EXPECT_EQ(lattice.struts.size(), 120000u);
  // Eight joints a cell and the stub ends, one for each two cells that meet.
  EXPECT_EQ(lattice.joints.size(), 80000u + 2u * 100u * 101u);
}
