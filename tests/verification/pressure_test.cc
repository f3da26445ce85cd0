#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>
#include <verification/momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Pressure on struts in the plane.

namespace
{
  constexpr double axial_stiffness = 100;

  /** A quarter of a ring of radius 1, counterclockwise: inside is left. */
  SceneText quarter_ring()
  {
    return SceneText()
      .frame("1 0; 0 1", "0 1 " + text(std::sqrt(0.5) - 1))
      .section({axial_stiffness, axial_stiffness, 1})
      .prescribe("side", "0", {"free", "0", "0"})
      .prescribe("top", "1", {"0", "free", "0"})
      .set("Effects/Large rotation", "on")
      .set("Newton/Tolerance", 1e-12)
      .mesh(4, 3);
  }
} // namespace

// N = EA w / R = P (R + w) under the pressure P inside: it acts on the current
// length.
TEST(Pressure, InflatesARing)
{
  SceneRun run(
    quarter_ring()
      .add("Loads/gas", "Type = pressure | Struts = all | Pressure = -10 * t")
      .time(1, 0.1, "static"));
  run.run();
  const double radius = 10 / (axial_stiffness - 10);
  EXPECT_NEAR(run.motion(0, 0) / radius, 1, 1e-6);
  EXPECT_NEAR(run.motion(1, 1) / radius, 1, 1e-6);
  EXPECT_LT(std::abs(run.balance()), 1e-3 * run.state.largest_energy);
}

// A closed frame under constant pressure: no resultant, and energy is
// conserved with the potential of the enclosed area.
TEST(Pressure, OnAClosedFrameHasNoResultant)
{
  SceneRun run(
    SceneText()
      .frame("0 0; 1 0; 1.3 0.8; 0.1 1.2", "0 1; 1 2; 2 3; 3 0")
      .section({50, 50, 0.1})
      .set("Sections/section 0/Density", 0)
      .mass("corners", "all", 1)
      .add("Loads/gas", "Type = pressure | Struts = all | Pressure = -0.5")
      .add("Initial velocities/spin",
           "Joints = 2 | Velocity x = 0.3 | Velocity y = 0.2")
      .set("Effects/Large rotation", "on")
      .set("Newton/Tolerance", 1e-12)
      .mesh(3)
      .time(2, 0.02, "energy-momentum"));
  MomentumMeter meter(run);
  const Momenta before = meter();
  run.run();
  const Momenta after = meter();
  EXPECT_NEAR(after.x, before.x, 1e-9);
  EXPECT_NEAR(after.y, before.y, 1e-9);
  EXPECT_NEAR(after.moment, before.moment, 1e-9);
  EXPECT_LT(std::abs(run.balance()), 1e-9 * run.state.largest_energy);
}

TEST(Pressure, IsRefusedInSpace)
{
  try
    {
      SceneRun run(
        SceneText()
          .dimension(3)
          .frame("0 0 0; 1 0 0", "0 1")
          .add("Loads/gas", "Type = pressure | Struts = all | Pressure = 1"));
      FAIL();
    }
  catch (const std::exception &error)
    {
      expect_parts(error.what(), {"Loads/gas/Type", "space"});
    }
}
