#include <auxfem/optimization/goals.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <limits>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const NamedResults results = {{"evaluation.bodies.foot.y.peak_force", 4},
                                {"evaluation.bodies.head.y.peak_force", 6},
                                {"mass_kilogram", 0.5},
                                {"travel", -0.2}};

  Scene scene_with_goals(const std::string &objective,
                         const std::string &constraints)
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .section({1, 1, 1})
      .support("clamp", "0", "clamp")
      .set("Constants", "n = 3")
      .set("Design variables/Time/End time", "0.5:2 s")
      .set("Optimization/Objective", objective)
      .set("Optimization/Constraints", constraints);
    return read_scene_from_text(scene.time(1, 0.1, "static"), "test.prm");
  }
} // namespace

TEST(Goals, AreExpressionsOfResultsByTheEndsOfTheirPaths)
{
  const Scene scene = scene_with_goals(
    "maximize n * foot.y.peak_force / mass_kilogram",
    "evaluation.bodies.head.y.peak_force <= 8; travel >= -0.1");
  Goals goals(scene, results);
  ASSERT_EQ(goals.first().objectives.size(), 1u);
  EXPECT_EQ(goals.first().objectives[0], 24);
  EXPECT_EQ(goals.first().limited, (std::vector<double>{6, -0.2}));
  EXPECT_EQ(goals.first().limits, (std::vector<double>{8, -0.1}));

  NamedResults better(results);
  better[0].second  = 6;
  better[3].second  = -0.05;
  const auto values = goals.values(better);
  ASSERT_TRUE(values.has_value());
  EXPECT_EQ(goals.merit(goals.first()), -1);
  EXPECT_EQ(goals.merit(*values), -1.5);
  EXPECT_DOUBLE_EQ(goals.excess(goals.first(), 0), -0.25);
  EXPECT_DOUBLE_EQ(goals.excess(goals.first(), 1), 1);
  EXPECT_DOUBLE_EQ(goals.excess(*values, 1), -0.5);
  EXPECT_DOUBLE_EQ(goals.largest_excess(*values), -0.25);
}

TEST(Goals, HaveNoValuesWhereAResultIsMissingOrNoNumber)
{
  const Scene scene =
    scene_with_goals("minimize mass_kilogram", "travel >= -1");
  Goals goals(scene, results);
  EXPECT_FALSE(goals.values({{"mass_kilogram", 1}}).has_value());
  NamedResults infinite(results);
  infinite[2].second = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(goals.values(infinite).has_value());
  // Results that no expression refers to may be missing.
  EXPECT_TRUE(goals.values({{"travel", 0}, {"mass_kilogram", 1}}).has_value());
}

TEST(Goals, NamesThatNoResultHasAreRefused)
{
  const auto refusal = [](const std::string &objective) {
    return input_error_of(
      [&]() { Goals(scene_with_goals(objective, "none"), results); });
  };
  expect_parts(refusal("minimize force"),
               {"Optimization/Objective = force",
                "evaluation.bodies.foot.y.peak_force"});
  expect_parts(refusal("minimize mass_kilo"),
               {"no number \"mass_kilo\"", "did you mean \"mass_kilogram\""});
  expect_parts(refusal("minimize peak_force"),
               {"Optimization/Objective = peak_force",
                "several results end in \"peak_force\"",
                "evaluation.bodies.head.y.peak_force"});
  expect_parts(refusal("minimize 1 / (travel - travel)"), {"no finite number"});
  expect_parts(refusal("minimize 2 * n"), {"minimize 2 * n", "no result"});
}

TEST(Goals, LimitsMustConcernResultsInTheirUnits)
{
  const auto refusal = [](const std::string &constraint) {
    return input_error_of([&]() {
      Goals(scene_with_goals("minimize travel", constraint), results);
    });
  };
  expect_parts(refusal("n <= 4"), {"n <= 4", "limits no design"});
  expect_parts(refusal("mass_kilogram <= 3 N"),
               {"mass_kilogram <= 3 N", "is in kg, its limit in N"});
  expect_parts(refusal("abs(foot.y.peak_force) <= 20 mm"),
               {"foot.y.peak_force is in N, its limit in mm"});
  EXPECT_EQ(refusal("10 lbf >= foot.y.peak_force; travel <= 3 mm"), "");
}
