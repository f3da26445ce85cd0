#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <cmath>
#include <iomanip>
#include <sstream>

using namespace auxfem;

namespace
{
  std::string measures(const double half_width,
                       const double half_height,
                       const double side_depth,
                       const double top_depth,
                       const double horizontal_stub,
                       const double vertical_stub)
  {
    std::ostringstream text;
    text << std::setprecision(17) << "set Half width = " << half_width << '\n'
         << "set Half height = " << half_height << '\n'
         << "set Side notch depth = " << side_depth << '\n'
         << "set Top notch depth = " << top_depth << '\n'
         << "set Horizontal stub length = " << horizontal_stub << '\n'
         << "set Vertical stub length = " << vertical_stub << '\n';
    return text.str();
  }

  std::unique_ptr<Cell> general_star(const std::string &text)
  {
    return cell_from_text("general star", text);
  }

  const double cos_30 = std::sqrt(0.75);
} // namespace

TEST(GeneralStarCell, EqualsTheSymmetricStar)
{
  const double tip = 0.01 * cos_30;
  const auto   general =
    general_star(measures(tip, tip, 0.005, 0.005, 0.01, 0.01))->build();
  const auto star =
    cell_from_text("star",
                   "set Strut length = 10 mm\nset Opening angle = 60 deg")
      ->build();
  ASSERT_EQ(general.joints.size(), star.joints.size());
  // Round-off of sin and cos against the square root, on 10 mm.
  for (unsigned int i = 0; i < star.joints.size(); ++i)
    EXPECT_NEAR(general.joints[i].distance(star.joints[i]), 0, 1e-16);
  ASSERT_EQ(general.struts.size(), star.struts.size());
  for (unsigned int i = 0; i < star.struts.size(); ++i)
    {
      EXPECT_EQ(general.struts[i].first, star.struts[i].first);
      EXPECT_EQ(general.struts[i].second, star.struts[i].second);
      EXPECT_EQ(general.struts[i].sets, star.struts[i].sets);
    }
  EXPECT_EQ(general.pairs, star.pairs);
  EXPECT_NEAR((general.vectors[0] - star.vectors[0]).norm(), 0, 1e-16);
}

TEST(GeneralStarCell, TakesThePapersAngleOf30Degrees)
{
  // L = 0.5 m, w = 0.6 m > L cos(30 deg) = 0.433 m.
  const auto cell =
    general_star(measures(0.6, 0.25, 0.5 * cos_30, 0.1, 0.5, 0.1))->build();
  const auto lattice = make_array(cell, {{3, 2, 1}});
  EXPECT_EQ(lattice.struts.size(), 72u);
  // Tip to side vertex: length L, rise L sin(30 deg).
  const auto edge = cell.joints[0] - cell.joints[4];
  EXPECT_NEAR(edge.norm(), 0.5, 1e-15);
  EXPECT_NEAR(edge[1] / edge.norm(), 0.5, 1e-15);
  EXPECT_NEAR(cell.vectors[0][0], 2 * (0.6 - 0.5 * cos_30 + 0.5), 1e-15);
  EXPECT_NEAR(cell.vectors[1][1], 2 * (0.25 - 0.1 + 0.1), 1e-15);
}

TEST(GeneralStarCell, TipsThatMeetBecomeOneJoint)
{
  // Vertical stub as long as the notch is deep: the upper tips of a cell are
  // the lower tips of the next one.
  const auto cell =
    general_star(measures(0.6, 0.25, 0.4, 0.1, 0.5, 0.1))->build();
  EXPECT_EQ(make_array(cell, {{1, 2, 1}}).joints.size(), 2u * 12u - 3u);
}

TEST(GeneralStarCell, WithoutStubsTheVerticesAreThePorts)
{
  const auto cell =
    general_star(measures(0.6, 0.25, 0.4, 0.1, 0, 0.1))->build();
  EXPECT_EQ(cell.struts.size(), 10u);
  EXPECT_EQ(cell.joints.size(), 10u);
  const auto lattice = make_array(cell, {{1, 1, 1}});
  const auto right   = lattice.joint_sets.at("right");
  ASSERT_EQ(right.size(), 1u);
  EXPECT_NEAR(lattice.joints[right[0]][0], 0.2, 1e-15);
}

TEST(GeneralStarCell, RefusesNotchesThatCross)
{
  // L = 0.5 m at 30 deg with w = 0.4 m < L cos(theta0) = 0.433013 m.
  const auto sides = input_error_of(
    []() { general_star(measures(0.4, 0.25, 0.5 * cos_30, 0.1, 0.5, 0.1)); });
  for (const auto part : {"w > L cos(theta0)",
                          "Half width = 0.4 m",
                          "Side notch depth = 0.433013 m",
                          "L = 0.5 m",
                          "theta0 = 30 deg"})
    EXPECT_TRUE(contains(sides, part)) << part << " in: " << sides;

  const auto top = input_error_of(
    []() { general_star(measures(0.6, 0.25, 0.4, 0.25, 0.5, 0.3)); });
  EXPECT_TRUE(contains(top, "g > top notch depth fails")) << top;
}

TEST(GeneralStarCell, RefusesToRepeatWhenTipsReachPastEachOther)
{
  const auto cell =
    general_star(measures(0.6, 0.25, 0.4, 0.1, 0.3, 0.1))->build();
  EXPECT_NO_THROW(make_array(cell, {{1, 3, 1}}));
  const auto message = input_error_of([&]() { make_array(cell, {{2, 1, 1}}); });
  EXPECT_TRUE(contains(message, "horizontal stub length 0.3 m")) << message;
  EXPECT_TRUE(contains(message, "notch depth 0.4 m")) << message;
}
