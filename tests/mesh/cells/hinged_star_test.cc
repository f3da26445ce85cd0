#include <auxfem/mesh/sets.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <cmath>
#include <set>

using namespace auxfem;

namespace
{
  Lattice hinged_star(const std::string                 &text,
                      const std::array<unsigned int, 3> &n_cells = {{1, 1, 1}})
  {
    return make_array(cell_from_text("hinged star", text)->build(), n_cells);
  }

  std::string hinged_star_refusal(const std::string &text)
  {
    return input_error_of([&]() { hinged_star(text); });
  }

  unsigned int joint(const Lattice &lattice, const std::string &name)
  {
    const auto &set = lattice.joint_sets.at(name);
    EXPECT_EQ(set.size(), 1u) << name;
    return set.at(0);
  }

  dealii::Point<3> position(const Lattice &lattice, const std::string &name)
  {
    return lattice.joints[joint(lattice, name)];
  }

  void expect_position(const Lattice     &lattice,
                       const std::string &name,
                       const double       x,
                       const double       y)
  {
    // Round-off of sines and cosines on one metre.
    EXPECT_NEAR(position(lattice, name).distance({x, y, 0}), 0, 1e-15) << name;
  }

  /** Whether the only strut of @p set has the ends @p first and @p second. */
  void expect_bar(const Lattice     &lattice,
                  const std::string &first,
                  const std::string &second)
  {
    const auto &set = lattice.strut_sets.at("bar " + first + second);
    ASSERT_EQ(set.size(), 1u);
    const std::set<unsigned int> ends(lattice.struts[set[0]].joints.begin(),
                                      lattice.struts[set[0]].joints.end());
    EXPECT_EQ(ends,
              (std::set<unsigned int>{joint(lattice, first),
                                      joint(lattice, second)}));
    EXPECT_NEAR(lattice.length(lattice.struts[set[0]]), 0.5, 1e-15);
  }

  const double cosine_of_30 = std::sqrt(0.75);
} // namespace

TEST(HingedStarCell, PlacesOfTheJoints)
{
  const auto lattice = hinged_star("set Half width    = 0.6\n"
                                   "set Notch depth   = 0.1\n"
                                   "set Cell gap      = 0.2\n"
                                   "set Rod clearance = 0.05\n");
  EXPECT_EQ(lattice.joints.size(), 12u);
  // L1 = 0.5 m and theta0 = 30 deg: rise 0.25 m, run 0.433 m.
  const double side = 0.6 - 0.5 * cosine_of_30;
  expect_position(lattice, "F", -0.6, -0.25);
  expect_position(lattice, "A", -side, 0);
  expect_position(lattice, "B", -0.6, 0.25);
  expect_position(lattice, "E", 0.6, -0.25);
  expect_position(lattice, "D", side, 0);
  expect_position(lattice, "C", 0.6, 0.25);
  expect_position(lattice, "m", 0, 0.15);
  expect_position(lattice, "n", 0, 0.25);
  expect_position(lattice, "p", 0, -0.15);
  expect_position(lattice, "q", 0, -0.25);
  expect_position(lattice, "rod top", 0, 0);
  expect_position(lattice, "rod foot", 0, -0.4);
  EXPECT_EQ(lattice.joint_sets.at("axis").size(), 6u);
}

TEST(HingedStarCell, AutomaticMeasures)
{
  const auto cell    = cell_from_text("hinged star", "")->build();
  const auto lattice = make_array(cell, {{1, 1, 1}});
  // 1.1 L1; L1 sin(30 deg) / 2; L1 / 5; a fifth of the half width.
  expect_position(lattice, "C", 0.55, 0.25);
  expect_position(lattice, "m", 0, 0.125);
  expect_position(lattice, "rod foot", 0, -0.35);
  EXPECT_NEAR(cell.vectors[0][0], 2 * 0.55 + 0.11, 1e-15);
  EXPECT_NEAR(cell.vectors[1][1], 2 * 0.25 + 0.1, 1e-15);
}

TEST(HingedStarCell, StrutsAndTheirSets)
{
  const auto lattice = hinged_star("");
  EXPECT_EQ(lattice.struts.size(), 11u);
  EXPECT_EQ(lattice.strut_sets.at("bars").size(), 4u);
  expect_bar(lattice, "A", "F");
  expect_bar(lattice, "A", "B");
  expect_bar(lattice, "C", "D");
  expect_bar(lattice, "D", "E");

  const auto joints_of = [&](const std::string &set) {
    std::multiset<unsigned int> joints;
    for (const auto strut : lattice.strut_sets.at(set))
      joints.insert(lattice.struts[strut].joints.begin(),
                    lattice.struts[strut].joints.end());
    return joints;
  };
  const auto named = [&](const std::vector<std::string> &names) {
    std::multiset<unsigned int> joints;
    for (const auto &name : names)
      joints.insert(joint(lattice, name));
    return joints;
  };
  EXPECT_EQ(joints_of("upper part"), named({"m", "m", "m", "B", "C", "n"}));
  EXPECT_EQ(joints_of("lower part"), named({"p", "p", "p", "F", "E", "q"}));
  EXPECT_EQ(joints_of("rod"), named({"rod top", "rod foot"}));
}

TEST(HingedStarCell, PairsAndPorts)
{
  const auto lattice = hinged_star("");
  const auto ends    = [&](const std::string &name) {
    const auto &pairs = lattice.pair_sets.at(name);
    EXPECT_EQ(pairs.size(), 1u) << name;
    return std::make_pair(pairs.at(0).first, pairs.at(0).second);
  };
  EXPECT_EQ(ends("in-cell"),
            std::make_pair(joint(lattice, "m"), joint(lattice, "rod top")));
  EXPECT_EQ(ends("sides"),
            std::make_pair(joint(lattice, "A"), joint(lattice, "D")));
  EXPECT_TRUE(lattice.pair_sets.at("side neighbours").empty());
  EXPECT_TRUE(lattice.pair_sets.at("rod seats").empty());

  EXPECT_EQ(joint(lattice, "left"), joint(lattice, "A"));
  EXPECT_EQ(joint(lattice, "right"), joint(lattice, "D"));
  EXPECT_EQ(joint(lattice, "top"), joint(lattice, "n"));
  EXPECT_EQ(joint(lattice, "bottom"), joint(lattice, "rod foot"));
}

TEST(HingedStarCell, SelectionsTakeTheNamesAsTheyAre)
{
  const auto         lattice = hinged_star("");
  const SceneContext context;
  const auto         n_joints = [&](const std::string &text) {
    return select_joints(lattice, text, context, "").size();
  };
  EXPECT_EQ(n_joints("A + B + C + D + E + F"), 6u);
  EXPECT_EQ(n_joints("rod top + rod foot"), 2u);
  EXPECT_EQ(n_joints("axis + m"), 6u);
  EXPECT_EQ(
    select_struts(lattice, "bar AF + upper part + rod", context, "").size(),
    5u);
  EXPECT_EQ(select_pairs(lattice, "in-cell", context, "").size(), 1u);
}

TEST(HingedStarCell, RodsStandOnTheCellBelow)
{
  const auto lattice = hinged_star("", {{3, 2, 1}});
  // The three feet of the upper row are the stub ends below them.
  EXPECT_EQ(lattice.joints.size(), 6u * 12u - 3u);
  EXPECT_EQ(lattice.struts.size(), 6u * 11u);
  EXPECT_TRUE(lattice.pair_sets.at("rod seats").empty());
  EXPECT_EQ(lattice.joint_sets.at("bottom").size(), 3u);
  EXPECT_EQ(lattice.joint_sets.at("top").size(), 3u);
  EXPECT_EQ(lattice.joint_sets.at("left").size(), 2u);
}

TEST(HingedStarCell, RodsWithClearanceArePairedWithTheirSeats)
{
  const auto lattice = hinged_star("set Rod clearance = 20 mm", {{1, 3, 1}});
  EXPECT_EQ(lattice.joints.size(), 3u * 12u);
  const auto &seats = lattice.pair_sets.at("rod seats");
  ASSERT_EQ(seats.size(), 2u);
  for (unsigned int i = 0; i < 2; ++i)
    {
      EXPECT_EQ(seats[i].cell, i);
      // From the stub end up to the foot, in rows of 0.6 m.
      const auto &seat = lattice.joints[seats[i].first];
      EXPECT_NEAR(seat.distance({0, 0.25 + 0.6 * i, 0}), 0, 1e-15);
      EXPECT_NEAR(lattice.joints[seats[i].second].distance(
                    {0, 0.27 + 0.6 * i, 0}),
                  0,
                  1e-15);
    }
}

TEST(HingedStarCell, SidesFaceThoseOfTheNextColumn)
{
  const auto  lattice    = hinged_star("set Column gap = 0.1", {{2, 2, 1}});
  const auto &neighbours = lattice.pair_sets.at("side neighbours");
  ASSERT_EQ(neighbours.size(), 2u);
  EXPECT_EQ(neighbours[0].cell, 0u);
  EXPECT_EQ(neighbours[1].cell, 2u);
  for (const auto &pair : neighbours)
    {
      const auto span =
        lattice.joints[pair.second] - lattice.joints[pair.first];
      // The column gap and the two side notches, each L1 cos(30 deg) deep.
      EXPECT_NEAR(span[0], 0.1 + 2 * 0.5 * cosine_of_30, 1e-15);
      EXPECT_NEAR(span[1], 0, 1e-15);
    }
}

TEST(HingedStarCell, RefusesSideNotchesThatCross)
{
  const auto message = hinged_star_refusal("set Half width = 0.4");
  for (const auto part : {"Lattice/Half width: 0.4 m",
                          "L1 cos(theta0) = 0.433013 m",
                          "the side notches cross",
                          "Increase 'Half width'"})
    EXPECT_TRUE(contains(message, part)) << part << " in: " << message;
  // They meet.
  EXPECT_TRUE(
    contains(hinged_star_refusal("set Bar length = 1\nset Angle = 60\n"
                                 "set Half width = 0.5"),
             "cross or the joints A and D meet"));
  EXPECT_EQ(hinged_star_refusal("set Half width = 0.434"), "");
}

TEST(HingedStarCell, RefusesNotchesThatMeet)
{
  // At the rise L1 sin(30 deg) = 0.25 m both notches reach the middle.
  const auto message = hinged_star_refusal("set Notch depth = 0.25");
  for (const auto part : {"Lattice/Notch depth: 0.25 m",
                          "L1 sin(theta0) = 0.25 m",
                          "the upper and lower notch cross or meet",
                          "Reduce 'Notch depth'"})
    EXPECT_TRUE(contains(message, part)) << part << " in: " << message;
  EXPECT_EQ(hinged_star_refusal("set Notch depth = 0.249"), "");
}

TEST(HingedStarCell, RefusesARodThatEndsInTheLowerStub)
{
  const auto message =
    hinged_star_refusal("set Cell gap = 0.1\nset Rod clearance = 0.11");
  for (const auto part : {"Lattice/Rod clearance: 0.11 m",
                          "cell gap g = 0.1 m",
                          "Reduce 'Rod clearance'"})
    EXPECT_TRUE(contains(message, part)) << part << " in: " << message;
  EXPECT_EQ(hinged_star_refusal("set Cell gap = 0.1\nset Rod clearance = 0.1"),
            "");
}

TEST(HingedStarCell, RefusesFlatAndUprightBars)
{
  for (const auto angle : {"0", "90", "-30", "120"})
    EXPECT_ANY_THROW(hinged_star(std::string("set Angle = ") + angle)) << angle;
  EXPECT_ANY_THROW(hinged_star("set Cell gap = 0"));
}
