#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/sets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "ladder.h"

using namespace auxfem;

namespace
{
  using Indices = std::vector<unsigned int>;

  class Sets : public ::testing::Test
  {
  protected:
    Sets() : lattice(make_array(ladder()->build(), {{1, 1, 1}}))
    {
      context.constants = {{"width", 2.}};
    }

    Indices joints(const std::string &text) const
    {
      return select_joints(lattice, text, context, "Supports/base");
    }

    Indices struts(const std::string &text) const
    {
      return select_struts(lattice, text, context, "Sections/main");
    }

    std::vector<JointPair> pairs(const std::string &text) const
    {
      return select_pairs(lattice, text, context, "Connectors/damper");
    }

    std::string joints_refusal(const std::string &text) const
    {
      return input_error_of([&]() { joints(text); });
    }

    Lattice      lattice;
    SceneContext context;
  };

  /** Selections in space: an array of 2 x 1 x 3 stars. */
  class SetsInSpace : public ::testing::Test
  {
  protected:
    SetsInSpace()
      : lattice(make_array(cell_from_text("space star",
                                          "set Strut length = 1 m\n"
                                          "set Opening angle = 90 deg",
                                          ".",
                                          3)
                             ->build(),
                           {{2, 1, 3}}))
    {
      context.dimension = 3;
    }

    Indices joints(const std::string &text) const
    {
      return select_joints(lattice, text, context, "Supports/base");
    }

    Lattice      lattice;
    SceneContext context;
  };
} // namespace

TEST_F(Sets, JointsByName)
{
  EXPECT_EQ(joints("bottom"), (Indices{0, 1, 2}));
  EXPECT_EQ(joints(" bottom + left "), (Indices{0, 1, 2, 3}));
}

TEST_F(Sets, JointsByNumber)
{
  EXPECT_EQ(joints("5, 3, 5"), (Indices{3, 5}));
  EXPECT_EQ(joints("4"), (Indices{4}));
  EXPECT_EQ(joints("5 3 5"), (Indices{3, 5}));
  EXPECT_EQ(joints("5 3, 0"), (Indices{0, 3, 5}));
  EXPECT_EQ(joints("5, bottom"), (Indices{0, 1, 2, 5}));
}

TEST_F(Sets, NearestJoint)
{
  EXPECT_EQ(joints("nearest: 1.2, 0.8"), (Indices{4}));
  EXPECT_EQ(joints("nearest: 1900 mm, 1"), (Indices{5}));
  EXPECT_EQ(struts("nearest: 0.1, 0.5"), (Indices{4}));
}

TEST_F(Sets, JointsByCondition)
{
  EXPECT_EQ(joints("y > ymax - 1e-6 && x < 1.5"), (Indices{3, 4}));
  EXPECT_EQ(joints("abs(x - width) < 1e-6"), (Indices{2, 5}));
  EXPECT_EQ(joints("x == xmin || x >= xmax"), (Indices{0, 2, 3, 5}));
  EXPECT_EQ(joints("sin(pi * x / 2) > 0.5"), (Indices{1, 4}));
}

TEST_F(Sets, StrutsAreTestedAtTheirMiddles)
{
  EXPECT_EQ(struts("x > 0.4 && x < 0.6"), (Indices{0, 2}));
  EXPECT_EQ(struts("abs(y - 0.5) < 0.1"), (Indices{4, 5, 6}));
  EXPECT_EQ(struts("2, 3"), (Indices{2, 3}));
}

TEST_F(Sets, UnknownNamesComeWithSuggestions)
{
  const auto message = joints_refusal("left + botom");
  EXPECT_TRUE(contains(message, "Supports/base")) << message;
  EXPECT_TRUE(contains(message, "named \"botom\"; did you mean \"bottom\"?"))
    << message;
  EXPECT_TRUE(contains(message, "\"all\", \"bottom\", \"left\"")) << message;
}

TEST_F(Sets, NumbersThatDoNotExist)
{
  const auto message = joints_refusal("3, 6");
  EXPECT_TRUE(contains(message, "there is no joint 6")) << message;
  EXPECT_TRUE(contains(message, "from 0 to 5")) << message;
  EXPECT_TRUE(contains(joints_refusal("-1"), "\"-1\""));
  EXPECT_TRUE(contains(joints_refusal("1, two"), "\"two\""));
  EXPECT_TRUE(contains(joints_refusal("1.5"), "\"1.5\""));
  EXPECT_TRUE(contains(joints_refusal("99999999999"), "not the number"));
}

TEST_F(Sets, EmptySelections)
{
  const auto message = joints_refusal("x > 3");
  EXPECT_TRUE(contains(message, "selects no joint")) << message;
  EXPECT_TRUE(contains(message, "between (0, 0) m and (2, 1) m")) << message;
  EXPECT_TRUE(contains(joints_refusal("  "), "no joints are named"));
}

TEST_F(Sets, ConditionsThatCannotBeParsed)
{
  const auto message = joints_refusal("y > ymaxx - 1");
  EXPECT_TRUE(contains(message, "Supports/base")) << message;
  EXPECT_TRUE(contains(message, "\"y > ymaxx - 1\"")) << message;
  EXPECT_TRUE(contains(message, "\"ymaxx\" found at position 4")) << message;
  EXPECT_TRUE(contains(joints_refusal("x = 0"), "write \"==\""));
  EXPECT_TRUE(contains(joints_refusal("sqrt(x - 1)"), "not a number"));
}

TEST_F(Sets, ConstantsMayNotHidePlaces)
{
  context.constants = {{"x", 2.}};
  EXPECT_TRUE(
    contains(joints_refusal("y > 0"), "'x' cannot be the name of a constant"));
}

TEST_F(Sets, NearestNeedsAPlace)
{
  EXPECT_TRUE(contains(joints_refusal("nearest: 1"), "1 coordinates"));
  EXPECT_TRUE(contains(joints_refusal("nearest: 1 kg, 2"), "kg"));
  EXPECT_TRUE(contains(joints_refusal("neares: 1, 2"), "\"neares:\""));
}

TEST_F(Sets, PairsByNumberAndToGround)
{
  for (const char *text : {"0 4; 1 5", "0, 4; 1,5"})
    {
      const auto numbered = pairs(text);
      ASSERT_EQ(numbered.size(), 2u);
      EXPECT_EQ(numbered[1].first, 1u);
      EXPECT_EQ(numbered[1].second, 5u);
    }

  const auto ground = pairs("ground: top");
  ASSERT_EQ(ground.size(), 3u);
  EXPECT_EQ(ground[0].first, 3u);
  EXPECT_EQ(ground[0].second, invalid_index);
}

TEST_F(Sets, ImpossiblePairs)
{
  const auto refusal = [&](const std::string &text) {
    return input_error_of([&]() { pairs(text); });
  };
  EXPECT_TRUE(contains(refusal("0 9"), "there is no joint 9"));
  EXPECT_TRUE(contains(refusal("2 2"), "with itself"));
  EXPECT_TRUE(contains(refusal("0 1 2"), "not a pair"));
  EXPECT_TRUE(contains(refusal("in-cell"), "offers none by name"));
  EXPECT_TRUE(contains(refusal(""), "Connectors/damper"));

  lattice.pair_sets["in-cell"] = {{0, 4}};
  EXPECT_EQ(pairs("in-cell").size(), 1u);
  EXPECT_TRUE(contains(refusal("incell"), "did you mean \"in-cell\"?"));

  lattice.pair_sets["neighbours"] = {};
  for (const auto part : {"Connectors/damper",
                          "no joint pairs \"neighbours\"",
                          "one cell has no neighbour",
                          "'Cells x', 'Cells y'"})
    EXPECT_TRUE(contains(refusal("neighbours"), part)) << part;
  lattice.n_cells = 2;
  EXPECT_TRUE(contains(refusal("neighbours"), "in their direction"));
}

TEST_F(SetsInSpace, ByConditionsInZ)
{
  EXPECT_EQ(joints("z < zmin + 1e-6"), lattice.joint_sets.at("back"));
  EXPECT_EQ(joints("abs(z - zmax) < 1e-6 && x < 1"),
            (Indices{lattice.joint_sets.at("front")[0]}));
  const auto stubs = select_struts(lattice, "stubs", context, "Sections/stubs");
  const auto low =
    select_struts(lattice, "z < zmin + 0.75", context, "Sections/stubs");
  // The two lowest stubs, middles half a strut above the lowest joints.
  ASSERT_EQ(low.size(), 2u);
  EXPECT_TRUE(
    std::includes(stubs.begin(), stubs.end(), low.begin(), low.end()));
}

TEST_F(SetsInSpace, Nearest)
{
  for (const unsigned int joint : {3u, 17u, 40u})
    {
      const auto        &position = lattice.joints[joint];
      std::ostringstream text;
      text << "nearest: " << position[0] + 0.01 << " m, " << 1000 * position[1]
           << " mm, " << position[2] - 0.02;
      EXPECT_EQ(joints(text.str()), (Indices{joint})) << text.str();
    }
  // Without z the plane z = 0: the stub end at the left of the first layer.
  const auto left = joints("nearest: -9, 0");
  EXPECT_EQ(left, joints("nearest: -9, 0, 0"));
  EXPECT_EQ(left[0], lattice.joint_sets.at("left")[0]);
}

TEST_F(SetsInSpace, PairsAreChosenByTheirMiddle)
{
  const auto pairs = [&](const std::string &text) {
    return select_pairs(lattice, text, context, "Connectors/damper");
  };
  const std::vector<JointPair> all = pairs("in-cell");
  // Between the first and the second of three layers.
  const auto   bounds = bounding_box(lattice);
  const double third  = bounds[0][2] + (bounds[1][2] - bounds[0][2]) / 3;
  const std::vector<JointPair> lower = pairs("in-cell where z < " +
                                             std::to_string(third)),
                               upper = pairs("in-cell where z >= " +
                                             std::to_string(third));
  EXPECT_EQ(3 * lower.size(), all.size());
  EXPECT_EQ(lower.size() + upper.size(), all.size());
  for (const JointPair &pair : lower)
    EXPECT_LT(lattice.joints[pair.first][2] + lattice.joints[pair.second][2],
              2 * third);
  EXPECT_LT(pairs("ground: left where z < " + std::to_string(third)).size(),
            pairs("ground: left").size());
  expect_parts(input_error_of([&]() { pairs("in-cell where y > 1e3"); }),
               {"Connectors/damper", "no pair", "y > 1e3"});
}

TEST_F(SetsInSpace, MessagesShowAllCoordinates)
{
  const auto refusal = [&](const std::string &text) {
    return input_error_of([&]() { joints(text); });
  };
  EXPECT_TRUE(contains(refusal("z > 100"), "(-1.70711, -1.70711, -1.70711) m"));
  EXPECT_TRUE(contains(refusal("nearest: 1, 2, 3, 4"), "0.01, 0.02, 0.03"));
  EXPECT_TRUE(contains(refusal("botom"), "\"nearest: x, y, z\""));
  lattice.pair_sets["neighbours"] = {};
  EXPECT_TRUE(contains(input_error_of([&]() {
                         select_pairs(lattice,
                                      "neighbours",
                                      context,
                                      "Connectors/damper");
                       }),
                       "'Cells z'"));
}
