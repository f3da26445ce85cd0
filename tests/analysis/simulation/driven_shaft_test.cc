#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A shaft along x between two ball bearings with an arm along y; its
   * rotation about x alone is prescribed at joint 1. */
  SceneText driven_shaft(const std::string &angle)
  {
    return SceneText()
      .dimension(3)
      .frame("0 0 0; 2 0 0; 0 1 0", "2 0; 0 1")
      .rectangle("beam", 0.01, 0.01, {200e9, 100, 0})
      .support("bearing", "0", "pin")
      .prescribe("drive", "1", {"0", "0", "0"}, {angle, "free", "free"})
      .set("Newton/Tolerance", 1e-10);
  }
} // namespace

TEST(DrivenShaft, TurnsItsArmByThePrescribedAngle)
{
  for (const std::string rotation : {"on", "off"})
    {
      SceneRun run(driven_shaft("0.01 * t")
                     .time(1, 0.5, "static")
                     .set("Effects/Large rotation", rotation));
      run.run();
      EXPECT_NEAR(run.motion(2, 2), 0.01, 1e-6);
      EXPECT_NEAR(run.reaction("drive", 3), 0, 1e-6);
    }
}

TEST(DrivenShaft, TurnsByMoreThanAWholeTurn)
{
  SceneRun run(driven_shaft("8 * t").time(1, 0.05, "static"));
  run.run();
  EXPECT_NEAR(run.motion(2, 1), std::cos(8.) - 1, 1e-7);
  EXPECT_NEAR(run.motion(2, 2), std::sin(8.), 1e-7);
}

TEST(DrivenShaft, TwistsAgainstAClampByItsTorque)
{
  // The arm is clamped: GJ / L on 0.01 rad.
  SceneRun run(driven_shaft("0.01 * t")
                 .support("bearing", "0", "clamp")
                 .time(1, 1, "static"));
  run.run();
  const double J = 0.140577 * 1e-8, torque = 100e9 * J / 2 * 0.01;
  EXPECT_NEAR(run.reaction("drive", 3), torque, 1e-4 * torque);
}

TEST(DrivenShaft, MovesTheSameByEveryScheme)
{
  // Rotated to 0.3 rad so slowly that the arm hardly bends.
  for (const std::string scheme :
       {"newmark", "generalized-alpha", "esdirk", "energy-momentum"})
    {
      SCOPED_TRACE(scheme);
      SceneRun run(driven_shaft("0.3 * (10*(t/4)^3 - 15*(t/4)^4 + 6*(t/4)^5)")
                     .time(4, 0.05, scheme));
      run.run();
      EXPECT_NEAR(run.motion(2, 1), std::cos(0.3) - 1, 2e-4);
      EXPECT_NEAR(run.motion(2, 2), std::sin(0.3), 2e-4);
    }
}

TEST(DrivenShaft, BeginsWithoutAnAngle)
{
  const std::string refusal = input_error_of(
    [] { SceneRun run(driven_shaft("0.1 + t").time(1, 1, "static")); });
  EXPECT_NE(refusal.find("Supports/drive/Rotation x"), std::string::npos)
    << refusal;
  EXPECT_NE(refusal.find("begins with zero"), std::string::npos) << refusal;
}
