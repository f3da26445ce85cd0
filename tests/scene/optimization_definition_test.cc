#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText designed_cantilever()
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .section({1, 1, 1})
      .support("clamp", "0", "clamp")
      .set("Constants", "length = 3 mm, width = 2 * length")
      .set("Design variables/Time/End time", "0.5:2 s")
      .set("Optimization/Objective", "minimize strain");
    return scene.time(1, 0.1, "static");
  }

  OptimizationDefinition optimization_of(const SceneText &scene)
  {
    return read_scene_from_text(scene, "test.prm").optimization;
  }

  DesignVariable variable_from(const std::string &bounds)
  {
    return optimization_of(
             designed_cantilever().set("Design variables/Time/End time",
                                       bounds))
      .variables.at(0);
  }

  OptimizationDefinition optimization_with(const std::string &parameter,
                                           const std::string &value)
  {
    return optimization_of(
      designed_cantilever().set("Optimization/" + parameter, value));
  }

  std::string refusal_of_design(const std::string &path,
                                const std::string &value)
  {
    return input_error_of(
      [&]() { optimization_of(designed_cantilever().set(path, value)); });
  }
} // namespace

TEST(DesignVariables, HaveBoundsAndAUnit)
{
  const DesignVariable linear = variable_from("500:1500 ms");
  EXPECT_EQ(linear.path, "Time/End time");
  EXPECT_EQ(linear.unit, "ms");
  EXPECT_EQ(linear.value_at(0.25), 750);
  EXPECT_EQ(linear.part_at(750), 0.25);
  EXPECT_EQ(linear.text_at(0), "500 ms");
  EXPECT_EQ(linear.text_at(1), "1500 ms");

  const DesignVariable logarithmic = variable_from("0.01:100 s logarithmic");
  EXPECT_TRUE(logarithmic.is_logarithmic);
  EXPECT_EQ(logarithmic.unit, "s");
  EXPECT_DOUBLE_EQ(logarithmic.value_at(0.5), 1);
  EXPECT_DOUBLE_EQ(logarithmic.part_at(10), 0.75);
  EXPECT_EQ(logarithmic.text_at(1), "100 s");
}

TEST(DesignVariables, BoundsThatAreNotUnderstoodAreRefused)
{
  const std::string path = "Design variables/Time/End time";
  expect_parts(refusal_of_design(path, "2:1 s"),
               {path, "2:1 s", "lower bound", "LOWER:UPPER"});
  expect_parts(refusal_of_design(path, "1:2:0.1 s"), {path, "two bounds"});
  expect_parts(refusal_of_design(path, "soft:hard"), {path, "\"soft\""});
  expect_parts(refusal_of_design(path, "0:1 s logarithmic"),
               {path, "positive"});
}

TEST(DesignVariables, HavePathsWithoutFurtherBlanks)
{
  SceneText scene = designed_cantilever();
  scene.remove("Design variables");
  std::string text = scene.str() +
    "\nsubsection Design variables\n  set Time / End time = 1:2 s\n";
  EXPECT_EQ(read_scene_from_text(text + "end\n", "test.prm")
              .optimization.variables.at(0)
              .path,
            "Time/End time");
  text += "  set Time/End time = 1:3 s\nend\n";
  expect_parts(input_error_of(
                 [&]() { read_scene_from_text(text, "test.prm"); }),
               {"Design variables/Time/End time", "given twice"});
}

TEST(OptimizationDefinition, ObjectivesAndConstraintsAreExpressions)
{
  const OptimizationDefinition two =
    optimization_with("Objective", "maximize energy / mass; minimize peak");
  ASSERT_EQ(two.objectives.size(), 2u);
  EXPECT_TRUE(two.objectives[0].is_maximized);
  EXPECT_EQ(two.objectives[0].expression, "energy / mass");
  EXPECT_EQ(two.objectives[1].text(), "minimize peak");

  const OptimizationDefinition limited =
    optimization_with("Constraints",
                      "mass <= 20 g; travel >= -a; k <= 3; "
                      "2 MPa <= if(E >= 1, E, 0)");
  ASSERT_EQ(limited.limits.size(), 4u);
  EXPECT_EQ(limited.limits[0].expression, "mass");
  EXPECT_EQ(limited.limits[0].limit, "0.02");
  EXPECT_TRUE(limited.limits[0].is_upper);
  EXPECT_EQ(limited.limits[1].limit, "-a");
  EXPECT_FALSE(limited.limits[1].is_upper);
  EXPECT_EQ(limited.limits[2].limit, "3");
  EXPECT_EQ(limited.limits[3].expression, "if(E >= 1, E, 0)");
  EXPECT_EQ(limited.limits[3].limit, "2000000");
  EXPECT_EQ(limited.limits[3].unit, "MPa");
  EXPECT_FALSE(limited.limits[3].is_upper);
}

TEST(OptimizationDefinition, WhatIsNotUnderstoodIsRefused)
{
  const std::string objective   = "Optimization/Objective",
                    constraints = "Optimization/Constraints";
  expect_parts(refusal_of_design(objective, "peak"),
               {objective, "minimize EXPRESSION"});
  expect_parts(refusal_of_design(objective,
                                 "minimize a; minimize b; minimize c"),
               {objective, "one or two"});
  expect_parts(refusal_of_design(constraints, "mass = 3"),
               {constraints, "mass = 3", "EXPRESSION <= LIMIT"});
  expect_parts(refusal_of_design(constraints, "1 <= mass <= 2"),
               {constraints, "1 <= mass <= 2", "two of them"});
  expect_parts(refusal_of_design(constraints, "mass < 2"),
               {constraints, "mass < 2", "EXPRESSION <= LIMIT"});
  expect_parts(refusal_of_design(constraints, "mass <="),
               {constraints, "EXPRESSION <= LIMIT"});
}

TEST(OptimizationDefinition, NeedsVariablesAndAnObjective)
{
  expect_parts(refusal_of_design("Optimization/Objective", "none"),
               {"need an objective", "minimize peak_force"});
  SceneText scene;
  scene.frame("0 0; 1 0", "0 1")
    .section({1, 1, 1})
    .support("clamp", "0", "clamp")
    .time(1, 0.1, "static")
    .set("Optimization/Objective", "minimize strain");
  expect_parts(input_error_of([&]() { optimization_of(scene); }),
               {"Optimization/Objective needs", "Design variables"});
  expect_parts(refusal_of_design("Sweep/Time/End time", "1, 2 s"),
               {"Sweep and Design variables", "Remove one"});
  expect_parts(refusal_of_design("Analysis", "study"),
               {"results of one run", "Analysis = study"});
}

TEST(OptimizationDefinition, CasesAreScenesWithoutIt)
{
  const Scene scene = read_scene_from_text(designed_cantilever(), "test.prm");
  const Scene one   = scene_of_case(scene, {"Time/End time=0.7"});
  EXPECT_FALSE(one.optimization.is_given());
  EXPECT_EQ(one.time.end_time, 0.7);
}

// A section with a base follows it, as with --set.
TEST(OptimizationDefinition, CasesInheritFromChangedSections)
{
  SceneText text;
  text.frame("0 0; 1 0; 2 0", "0 1; 1 2")
    .rectangle("edge", "10 mm", "20 mm", {1, 1000})
    .set("Sections/edge/Struts", "0")
    .add("Sections/stub", "Base = edge | Struts = 1")
    .support("clamp", "0", "clamp")
    .time(1, 0.1, "static");
  const Scene scene = read_scene_from_text(text.str(), "test.prm");
  const Scene one   = scene_of_case(scene, {"Sections/edge/Height=40 mm"});
  for (const SectionDefinition &section : one.sections)
    EXPECT_DOUBLE_EQ(section.section.area, 4e-4) << section.name;
}

TEST(Constants, MayStandInNumbersOfParameters)
{
  SceneText scene = designed_cantilever();
  scene.set("Time/End time", "4 * length / 3 mm");
  EXPECT_TRUE(
    contains(input_error_of([&]() { optimization_of(scene); }), "End time"));
  scene.set("Time/End time", "500 * length");
  const Scene found = read_scene_from_text(scene, "test.prm");
  EXPECT_DOUBLE_EQ(found.time.end_time, 1.5);
  // Files of the run keep the expression.
  EXPECT_TRUE(contains(found.all_parameters, "500 * length"));
  const Scene varied = scene_of_case(found, {"Constants/length=1 mm"});
  EXPECT_DOUBLE_EQ(varied.time.end_time, 0.5);
}

TEST(Constants, AreVariedOneByOne)
{
  const auto constants = [](const std::vector<std::string> &overrides) {
    return read_scene_from_text(designed_cantilever(), "test.prm", overrides)
      .context.constants;
  };
  using Pairs = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(constants({"Constants/length=5 mm"}),
            (Pairs{{"length", 5e-3}, {"width", 1e-2}}));
  EXPECT_EQ(constants({"Constants/width=0.5"}),
            (Pairs{{"length", 3e-3}, {"width", 0.5}}));
  expect_parts(input_error_of([&]() { constants({"Constants/height=1"}); }),
               {"Constants/height", "no constant", "height = 1"});
}

TEST(ChangedParameters, ReadBackAsTheSameScene)
{
  const Scene scene = read_scene_from_text(designed_cantilever(), "test.prm");
  const Scene again =
    read_scene_from_text(scene.changed_parameters, "test.prm");
  EXPECT_EQ(again.all_parameters, scene.all_parameters);
  EXPECT_LT(scene.changed_parameters.size(), scene.all_parameters.size() / 4);
}
