#include <auxfem/optimization/design_runs.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <nlohmann/json.hpp>
#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText designed_scene()
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .section({1, 1, 1})
      .support("clamp", "0", "clamp")
      .set("Constants", "a = 3 mm, b = 2 * a")
      .set("Output/Checkpoints", "7")
      .set("Optimization/Objective", "minimize r");
    return scene.time(1, 0.1, "static");
  }

  Scene scene_with_variable(const std::string &path, const std::string &bounds)
  {
    return read_scene_from_text(designed_scene().set("Design variables/" + path,
                                                     bounds),
                                "test.prm");
  }

  std::string refusal_of_start(const std::string &path,
                               const std::string &bounds)
  {
    return input_error_of(
      [&]() { first_design(scene_with_variable(path, bounds)); });
  }

  Design design_with(const double merit, const double excess)
  {
    Design design;
    design.exit_state = "completed";
    design.verdict    = "sound";
    design.goals      = {{merit}, {1 + excess}, {1}};
    return design;
  }
} // namespace

TEST(FirstDesign, IsThatOfTheScene)
{
  EXPECT_EQ(first_design(scene_with_variable("Time/End time", "0:4 s")),
            DesignPoint{0.25});
  EXPECT_EQ(first_design(scene_with_variable("Time/End time", "500:2500 ms")),
            DesignPoint{0.25});
  EXPECT_DOUBLE_EQ(first_design(
                     scene_with_variable("Time/Time step", "50:250 ms"))[0],
                   0.25);
  EXPECT_DOUBLE_EQ(first_design(
                     scene_with_variable("Constants/a", "1:9 mm"))[0],
                   0.25);
  EXPECT_DOUBLE_EQ(first_design(scene_with_variable("Constants/a",
                                                    "1:9 mm logarithmic"))[0],
                   0.5);
}

TEST(FirstDesign, MustBeANumberWithinItsBounds)
{
  expect_parts(refusal_of_start("Time/Beginning", "1:2 s"),
               {"Design variables/Time/Beginning", "no such parameter"});
  expect_parts(refusal_of_start("Time/End time", "2:3 s"),
               {"Design variables/Time/End time", "not within", "2 s", "3 s"});
  expect_parts(refusal_of_start("Constants/b", "1:9 mm"),
               {"Design variables/Constants/b", "2 * a", "vary the constant"});
  expect_parts(refusal_of_start("Constants/a", "0.001:0.01"),
               {"Design variables/Constants/a", "bounds need a unit"});
  expect_parts(refusal_of_start("Constants/a", "1:9 kg"),
               {"Design variables/Constants/a",
                "bounds are in kg",
                "the value of the scene, 3 mm"});
  // A number without unit is in the unit of its parameter.
  expect_parts(refusal_of_start("Time/Time step", "1:9 mm"),
               {"Design variables/Time/Time step", "bounds are in mm", "in s"});
}

TEST(Designs, RunWithoutGraphicsInTheirFolders)
{
  const Scene scene = scene_with_variable("Constants/a", "1:9 mm");
  const Scene one =
    scene_of_case(scene,
                  case_of_design(scene, {0.5}, "somewhere/0003").overrides);
  EXPECT_EQ(one.output.directory, "somewhere/0003");
  EXPECT_FALSE(one.output.graphics);
  EXPECT_EQ(one.output.checkpoints, 0u);
  EXPECT_DOUBLE_EQ(one.context.constants[0].second, 5e-3);
  EXPECT_DOUBLE_EQ(one.context.constants[1].second, 1e-2);
}

TEST(Designs, AreBetterWithinConstraintsThenByMerit)
{
  const Scene scene =
    read_scene_from_text(designed_scene()
                           .set("Design variables/Constants/a", "1:9 mm")
                           .set("Optimization/Constraints", "s <= 1"),
                         "test.prm");
  const Goals goals(scene, {{"r", 2}, {"s", 1}});
  const auto  is_better_one = [&goals](const Design &one, const Design &other) {
    return is_better(one, other, goals, 1e-3);
  };
  EXPECT_TRUE(is_better_one(design_with(1, 0), design_with(2, 0)));
  EXPECT_FALSE(is_better_one(design_with(2, 0), design_with(2, 0)));
  // An excess within the tolerance is none.
  EXPECT_TRUE(is_better_one(design_with(1, 9e-4), design_with(2, -1)));
  EXPECT_TRUE(is_better_one(design_with(2, 0), design_with(1, 0.1)));
  EXPECT_TRUE(is_better_one(design_with(2, 0.1), design_with(1, 0.2)));
  Design failed     = design_with(0, 0);
  failed.exit_state = "no convergence";
  EXPECT_FALSE(failed.is_usable());
  EXPECT_TRUE(is_better_one(design_with(2, 0.1), failed));
  EXPECT_FALSE(is_better_one(failed, design_with(2, 0.1)));
  Design wrong  = design_with(0, 0);
  wrong.verdict = "not to be used";
  EXPECT_FALSE(wrong.is_usable());
}

TEST(Designs, ComeBackFromJson)
{
  Design design      = design_with(3, 0.25);
  design.point       = {0.125, 1};
  design.folder      = "runs/0001";
  const Design again = design_of(Json::parse(json_of(design).dump()));
  EXPECT_EQ(again.point, design.point);
  EXPECT_EQ(again.folder, design.folder);
  EXPECT_EQ(again.goals->objectives, design.goals->objectives);
  EXPECT_EQ(again.goals->limited, design.goals->limited);
  design.goals.reset();
  EXPECT_FALSE(design_of(json_of(design)).goals.has_value());
}
