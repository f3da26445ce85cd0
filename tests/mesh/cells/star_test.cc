#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;

namespace
{
  // Coordinates are compared to 1e-15 m: a few units of round-off of the
  // cell's size of some 10 mm.
  constexpr double star_round_off = 1e-15;

  const double length = 0.010;
  const double angle  = dealii::numbers::PI / 3;
  const double a      = length * std::sin(angle);
  const double b      = length * (std::sin(angle) - std::cos(angle));
  const double e      = b + length;

  Lattice star_array(const unsigned int nx, const unsigned int ny)
  {
    const auto cell = cell_from_text("star",
                                     "set Strut length = 10 mm\n"
                                     "set Opening angle = 60 deg\n");
    return make_array(cell->build(), {{nx, ny, 1}});
  }

  /** Joint at a position; invalid_index if there is none. */
  unsigned int joint_at(const Lattice &lattice, const double x, const double y)
  {
    for (unsigned int i = 0; i < lattice.joints.size(); ++i)
      if (lattice.joints[i].distance({x, y, 0}) < star_round_off)
        return i;
    return invalid_index;
  }

  bool is_in(const Lattice     &lattice,
             const std::string &set,
             const double       x,
             const double       y)
  {
    const auto &members = lattice.joint_sets.at(set);
    return std::binary_search(members.begin(),
                              members.end(),
                              joint_at(lattice, x, y));
  }
} // namespace

TEST(StarCell, JointsLieAtTheirFormulas)
{
  const auto lattice = star_array(1, 1);
  EXPECT_EQ(lattice.joints.size(), 12u);
  for (const double sign : {-1., 1.})
    {
      EXPECT_TRUE(is_in(lattice, "tips", sign * a, a));
      EXPECT_TRUE(is_in(lattice, "tips", sign * a, -a));
      EXPECT_TRUE(is_in(lattice, "notches", sign * b, 0));
      EXPECT_TRUE(is_in(lattice, "notches", 0, sign * b));
    }
  EXPECT_TRUE(is_in(lattice, "right", e, 0));
  EXPECT_TRUE(is_in(lattice, "left", -e, 0));
  EXPECT_TRUE(is_in(lattice, "top", 0, e));
  EXPECT_TRUE(is_in(lattice, "bottom", 0, -e));
}

TEST(StarCell, TwelveStrutsOfEqualLength)
{
  const auto lattice = star_array(1, 1);
  EXPECT_EQ(lattice.struts.size(), 12u);
  for (const auto &strut : lattice.struts)
    EXPECT_NEAR(lattice.length(strut), length, 5 * star_round_off);
  EXPECT_EQ(lattice.strut_sets.at("edges").size(), 8u);
  EXPECT_EQ(lattice.strut_sets.at("stubs").size(), 4u);
}

TEST(StarCell, EdgesLeadFromTipsToTheTwoVerticesNextToThem)
{
  const auto lattice = star_array(1, 1);
  for (const unsigned int number : lattice.strut_sets.at("edges"))
    {
      const auto &joints = lattice.struts[number].joints;
      const auto &tip    = lattice.joints[joints[0]];
      const auto &notch  = lattice.joints[joints[1]];
      EXPECT_NEAR(std::abs(tip[0]), a, star_round_off);
      EXPECT_NEAR(std::abs(tip[1]), a, star_round_off);
      EXPECT_NEAR(notch.norm(), b, star_round_off);
      // Same quadrant, axes included.
      EXPECT_GE(tip[0] * notch[0], 0.);
      EXPECT_GE(tip[1] * notch[1], 0.);
    }
}

TEST(StarCell, ArrayCountsAndBoundarySets)
{
  const unsigned int nx = 5, ny = 4;
  const auto         lattice = star_array(nx, ny);
  EXPECT_EQ(lattice.n_cells, nx * ny);
  EXPECT_EQ(lattice.struts.size(), 12u * nx * ny);
  EXPECT_EQ(lattice.joints.size(),
            8u * nx * ny + (nx + 1) * ny + nx * (ny + 1));
  EXPECT_EQ(lattice.joint_sets.at("all").size(), lattice.joints.size());
  EXPECT_EQ(lattice.joint_sets.at("left").size(), ny);
  EXPECT_EQ(lattice.joint_sets.at("right").size(), ny);
  EXPECT_EQ(lattice.joint_sets.at("bottom").size(), nx);
  EXPECT_EQ(lattice.joint_sets.at("top").size(), nx);
  EXPECT_EQ(lattice.joint_sets.at("tips").size(), 4u * nx * ny);

  const double period = 2 * e;
  EXPECT_TRUE(is_in(lattice, "bottom", 2 * period, -e));
  EXPECT_TRUE(is_in(lattice, "top", 2 * period, 3 * period + e));
  EXPECT_TRUE(is_in(lattice, "right", 4 * period + e, period));
}

TEST(StarCell, InCellPairsSpanTheCell)
{
  const auto lattice = star_array(2, 2);
  for (const auto &[name, x, y] : {std::make_tuple("in-cell", 0., b),
                                   std::make_tuple("in-cell x", -b, 0.)})
    {
      const auto &pairs = lattice.pair_sets.at(name);
      ASSERT_EQ(pairs.size(), 4u);
      for (unsigned int cell = 0; cell < 4; ++cell)
        {
          const double cx = 2 * e * (cell % 2), cy = 2 * e * (cell / 2);
          EXPECT_EQ(pairs[cell].cell, cell);
          EXPECT_EQ(pairs[cell].first, joint_at(lattice, cx + x, cy + y));
          EXPECT_EQ(pairs[cell].second, joint_at(lattice, cx - x, cy - y));
        }
    }
}

TEST(StarCell, RodEndsAtTheStubOfTheCellBelow)
{
  const auto  lattice = star_array(1, 3);
  const auto &rods    = lattice.pair_sets.at("rod");
  ASSERT_EQ(rods.size(), 3u);
  for (unsigned int row = 0; row < 3; ++row)
    {
      EXPECT_EQ(rods[row].first, joint_at(lattice, 0, 2 * e * row + b));
      EXPECT_EQ(rods[row].second, joint_at(lattice, 0, 2 * e * row - e));
    }
  // The foundation in the lowest row, above it a joint that the stub of the
  // cell below reaches too.
  EXPECT_EQ(rods[0].second, lattice.joint_sets.at("bottom")[0]);
  const auto reaches = [&](const Strut &strut) {
    return strut.cell == 0 &&
      (strut.joints[0] == rods[1].second || strut.joints[1] == rods[1].second);
  };
  EXPECT_EQ(std::count_if(lattice.struts.begin(),
                          lattice.struts.end(),
                          reaches),
            1);
}

TEST(StarCell, RefusesCrossingNotches)
{
  const auto message = input_error_of([]() {
    cell_from_text("star", "set Strut length = 0.01\nset Opening angle = 30");
  });
  EXPECT_TRUE(contains(message, "Lattice")) << message;
  EXPECT_TRUE(contains(message, "theta0 = 30 deg")) << message;
  EXPECT_TRUE(contains(message, "sin(theta0) - cos(theta0)) > 0 fails"))
    << message;
  EXPECT_TRUE(contains(message, "b = -0.00366025 m")) << message;
  EXPECT_TRUE(contains(message, "general star")) << message;
}

TEST(StarCell, OpeningAngleLimits)
{
  const auto message_at = [](const std::string &angle) {
    return input_error_of(
      [&]() { cell_from_text("star", "set Opening angle = " + angle); });
  };
  // At 45 deg the vertices meet, at 90 deg the edges form a square.
  EXPECT_NE(message_at("45 deg"), "");
  EXPECT_EQ(message_at("45.001 deg"), "");
  EXPECT_EQ(message_at("90 deg"), "");
  EXPECT_TRUE(contains(message_at("90.001 deg"), "theta0 <= 90 deg fails"));
}

TEST(StarCell, SquareAt90DegKeepsTheTipsOfNeighboursApart)
{
  const auto cell =
    cell_from_text("star",
                   "set Strut length = 10 mm\nset Opening angle = 90 deg")
      ->build();
  const auto lattice = make_array(cell, {{2, 1, 1}});
  EXPECT_EQ(lattice.joints.size(), 2u * 12u - 1u);
  // Gap between the tips: 2 L (1 - cos theta0) = 2 L.
  EXPECT_NEAR(cell.vectors[0][0] - 2 * cell.joints[0][0],
              0.02,
              star_round_off * 10);
}
