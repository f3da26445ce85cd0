#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double EI = 2;

  SceneText cantilever()
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .section({1e6, 1e9, EI})
      .support("wall", "0", "clamp")
      .set("Effects/Large rotation", "off")
      .mesh(6)
      .time(1, 1, "static");
  }
} // namespace

// The tip of a cantilever under q x^2 by influence functions:
// w = int q x^2 (x^2 (3 - x) / 6) dx / EI.
TEST(LoadDistribution, LineLoadsFollowAnExpression)
{
  SceneRun run(cantilever().add(
    "Loads/snow",
    "Type = line | Struts = all | Force per length y = -3 * t | "
    "Distribution = (x / xmax)^2"));
  run.run();
  const double exact = -3 / EI * (3. / 5 - 1. / 6) / 6;
  EXPECT_NEAR(run.motion(1, 1) / exact, 1, 1e-5);
  EXPECT_NEAR(run.reaction("wall", 1), 3 * (1. / 3), 1e-7);
}

TEST(LoadDistribution, JointLoadsFollowAnExpression)
{
  SceneRun run(
    cantilever()
      .frame("0 0; 1 0; 2 0", "0 1; 1 2")
      .add("Loads/push",
           "Joints = x > 0.5 | Force x = t | Distribution = 10 * x"));
  run.run();
  EXPECT_NEAR(run.reaction("wall", 0), -30, 1e-9);
}

TEST(LoadDistribution, RefusesWhatItCannotDo)
{
  const auto refusal = [](const SceneText &scene) {
    try
      {
        SceneRun run(scene);
      }
    catch (const std::exception &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  expect_parts(refusal(cantilever().add(
                 "Loads/snow",
                 "Type = line | Struts = all | Force per length y = 1 | "
                 "Distribution = r")),
               {"Loads/snow/Distribution", "x, y, z"});
  expect_parts(refusal(cantilever()
                         .set("Effects/Large rotation", "on")
                         .add("Loads/push",
                              "Joints = 1 | Force x = 1 | Distribution = x | "
                              "Direction = follows the joint")),
               {"Loads/push/Distribution", "follows the joint"});
}
