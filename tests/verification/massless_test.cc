#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Unknowns without mass follow from equilibrium.

namespace
{
  /** A mass of 1 kg at joint 0, thrown with 1 m/s, @p near from it to joint 1,
   * which has no mass, and 300 N/m from there to the ground. */
  SceneText series(const std::string &near, const std::string &scheme)
  {
    return SceneText()
      .frame("0 0; 1 0; 0 -1; 1 -1", "2 3")
      .circle("idle", 1e-3, {1, 1})
      .support("idle", "2, 3", "clamp")
      .support("guide", "0, 1", "roller x")
      .add("Connectors/near", "Between = 0 1 | " + near)
      .add("Connectors/far",
           "Between = ground: 1 | Geometry = direction | "
           "Direction = 1 0 | Law = spring | Spring stiffness = 300")
      .set("Effects/Large rotation", "off")
      .set("Newton/Tolerance", 1e-13)
      .add("Time", "End time = 2 | Time step = 0.01 | Scheme = " + scheme)
      .add(mass_and_velocity(1, 1));
  }

  const std::string spring_law = "Law = spring | Spring stiffness = 100";
} // namespace

TEST(Massless, AJointBetweenTwoSpringsIsInEquilibrium)
{
  for (const char *scheme : {"newmark", "hht | HHT alpha = 0"})
    {
      // In series 75 N/m; the same scheme for both.
      SceneRun both(series(spring_law, scheme)),
        one(one_mass_scene(
          "Law = spring | Spring stiffness = 75",
          std::string("End time = 2 | Time step = 0.01 | Scheme = ") + scheme,
          mass_and_velocity(1, 1)));
      for (unsigned int step = 1; step <= 200; ++step)
        {
          both.advance();
          one.advance();
          EXPECT_NEAR(both.motion(0, 0), one.motion(0, 0), 1e-12);
          EXPECT_NEAR(both.motion(1, 0), both.motion(0, 0) / 4, 1e-12);
          // Differences over the last steps, a period being 73 of them.
          if (step > 1)
            {
              EXPECT_NEAR(both.velocity(1, 0), both.velocity(0, 0) / 4, 2e-3);
            }
        }
    }
}

namespace
{
  /** A clamped beam of two struts without density, a mass at the middle joint
   * and a force at the end. */
  SceneText massless_beam(const std::string &scheme)
  {
    return SceneText()
      .frame("0 0; 1 0; 2 0", "0 1; 1 2")
      .given("s", {0.01, 0.01, 2e-06}, {1e6, 0, 0})
      .support("c", "0", "clamp")
      .add("Loads/p", "Joints = 2 | Force y = 0.5*min(t,1)")
      .mass("m", "1", "0.1 kg")
      .mesh(3, 2)
      .time(2, 0.01, scheme);
  }
} // namespace

TEST(Massless, StrutsWithLargeRotationsMoveWithAFewIterationsAStep)
{
  SceneRun newmark(massless_beam("newmark")),
    damped(massless_beam("generalized-alpha"));
  newmark.run();
  damped.run();
  EXPECT_EQ(newmark.work().retries, 0u);
  EXPECT_LT(newmark.work().iterations, 10 * newmark.work().steps);
  // Both are of second order, 126 steps a period.
  for (unsigned int c = 0; c < 2; ++c)
    EXPECT_NEAR(newmark.motion(2, c), damped.motion(2, c), 5e-3);
  EXPECT_GT(newmark.motion(2, 1), 0.3);
}

TEST(Massless, DashpotsOnMasslessJointsAreRefusedByUndampedSchemes)
{
  const std::string dashpot = "Law = dashpot | Damping coefficient = 2";
  expect_parts(input_error_of(
                 [&] { SceneRun run(series(dashpot, "newmark")); }),
               {"horizontal displacement of joint 1",
                "has no inertia",
                "Masses",
                "Law = maxwell",
                "generalized-alpha"});
  EXPECT_EQ(input_error_of(
              [&] { SceneRun run(series(dashpot, "generalized-alpha")); }),
            "");
}
