#include <gtest/gtest.h>
#include <support/run_program.h>
#include <support/scene_text.h>
#include <verification/hard_case.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// The catalogue of hard cases: bodies that fly, mechanisms, ends that meet,
// noise.

namespace
{
  /** A bar of two struts that turns about z and a little about the others. */
  HardCase spinning_bar()
  {
    SceneText scene;
    scene.dimension(3)
      .frame("-0.5 0 0; 0 0 0; 0.5 0.1 0", "0 1; 1 2")
      .circle("rod", 0.02, {1e9, 1000, 0.3})
      .set("Initial velocities/spin/Joints", "all")
      .set("Initial velocities/spin/Angular velocity x", 1)
      .set("Initial velocities/spin/Angular velocity y", 2)
      .set("Initial velocities/spin/Angular velocity z", 60)
      .mesh(2)
      .time(10.5, 0.75e-3);
    return {"A hundred revolutions in space", scene.str(), {}, 2, true};
  }

  /** Three struts hinged to each other, thrown at both ends. */
  HardCase thrown_chain()
  {
    SceneText scene;
    scene.frame("0 0; 1 0; 2 0; 3 0", "0 1; 1 2; 2 3")
      .section({1e5, 1e5, 1e4})
      .set("Sections/section 0/Density", 1e-5)
      .hinge("links", "1, 2")
      .set("Initial velocities/left/Joints", "0")
      .set("Initial velocities/left/Velocity y", 1)
      .set("Initial velocities/right/Joints", "3")
      .set("Initial velocities/right/Velocity y", 3)
      .set("Newton/Tolerance", 1e-10)
      .mesh(2)
      .time(2, 2e-3);
    return {"Three hinged struts that are thrown", scene.str(), {}, 4, true};
  }

  /** Three bars hinged to each other and to a wall, let go from the horizontal.
   */
  HardCase hanging_chain()
  {
    SceneText scene;
    scene.frame("0 0; 1 0; 2 0; 3 0", "0 1; 1 2; 2 3")
      .section({1e6, 1e6, 1e3})
      .set("Sections/section 0/Density", 1e-6)
      .support("wall", "0", "pin")
      .hinge("links", "0, 1, 2")
      .set("Gravity/Acceleration y", -9.81)
      .mesh(2)
      .time(1.5, 2e-3);
    return {"A hanging chain of hinged bars", scene.str()};
  }

  /** The cell of rigid parts, pulled out until its bars, at 60 degrees at
   * first, stand upright, and through there: the side joints come to the other
   * side. */
  HardCase cell_through_upright()
  {
    return {"A cell of rigid bars through cos theta = 0",
            prm_text("rigid-cell.prm"),
            {"Lattice/Angle=60 deg",
             "Connectors/damper/Spring stiffness=2 kN/m",
             "Loads/impact/Force y=2000"}};
  }

  /** A four-bar linkage of rigid bars that comes within a thousandth of the
   * position in which all lie on one line. */
  HardCase flat_linkage()
  {
    SceneText scene;
    scene.frame("0 0; 0 0.3; 1 0.3; 1.001 0", "0 1; 1 2; 2 3")
      .add("Rigid parts/bars",
           "Struts = all | Parts = single struts | Mass = 1")
      .support("ground", "0, 3", "pin")
      .load("push", "1", {"5 * (t < 0.3)", "0", "0"})
      .time(2, 1e-3);
    return {"A linkage that passes its flat position", scene.str()};
  }

  /** A rigid part whose joints lie on a line but for 0.1 mm, in space, with a
   * strut hinged to its middle. */
  HardCase slim_rigid_part()
  {
    SceneText scene;
    scene.dimension(3)
      .frame("0 0 0; 0.5 1e-4 0; 1 0 0; 0.5 1 0.2", "0 1; 1 2; 1 3")
      .circle("rod", 0.01, {1e9, 1000, 0.3})
      .add("Rigid parts/bar", "Struts = 0, 1 | Mass = 1")
      .set("Initial velocities/throw/Joints", "3")
      .set("Initial velocities/throw/Velocity x", 1)
      .set("Initial velocities/throw/Velocity z", 2)
      .mesh(2)
      .time(0.5, 1e-3);
    return {"A rigid part with hardly any rotary inertia", scene.str()};
  }

  /** Two cantilevers whose tips, joints 1 and 2, a spring of a tenth of their
   * length connects; a mass at joint 1 is to be struck. */
  SceneText linked_cantilevers(const std::string &joints,
                               const Stiffnesses &stiffnesses)
  {
    SceneText scene;
    scene.frame(joints, "0 1; 2 3")
      .section(stiffnesses)
      .set("Sections/section 0/Density", 1e-4)
      .support("walls", "0, 3", "clamp")
      .mass("tip", "1", 0.1)
      .connector("link",
                 "kelvin-voigt",
                 "Between = 1 2 | Spring stiffness = 5 | "
                 "Damping coefficient = 0.05")
      .set("Initial velocities/strike/Joints", "1")
      .mesh(3);
    return scene;
  }

  /** Struck across: one tip passes the other one closely. */
  HardCase ends_that_pass()
  {
    SceneText scene =
      linked_cantilevers("0 0; 1 0; 0.985 0.1; 2 0.1", {1e4, 1e4, 1});
    scene.set("Initial velocities/strike/Velocity y", 2).time(1, 1e-3);
    return {"Connector ends that pass each other", scene.str()};
  }

  /** Struck head on. */
  HardCase ends_that_collide()
  {
    SceneText scene =
      linked_cantilevers("0 0; 1 0; 1.1 0; 2.1 0", {100, 100, 100});
    scene.set("Initial velocities/strike/Velocity x", 5).time(0.5, 0.5e-3);
    return {"Connector ends that meet head on", scene.str()};
  }

  /** A rigid bar a hundred-thousandth as long as the struts that it joins. */
  HardCase short_rigid_part()
  {
    SceneText scene;
    scene.frame("0 0; 1 0; 1.00001 0; 1.7 0.7", "0 1; 1 2; 2 3")
      .section({1e5, 1e5, 10})
      .set("Sections/section 0/Density", 1e-5)
      .add("Rigid parts/knot",
           "Struts = 1 | Mass = 0.1 | Elastic struts = clamped")
      .support("wall", "0", "clamp")
      .load("end", "3", {"0", "-2 * min(t / 0.5, 1)", "0"})
      .mesh(3)
      .time(2, 5e-3);
    return {"A rigid part a hundred-thousandth as long as its struts",
            scene.str()};
  }

  /** A cantilever of eight linear struts under a force at its end that grows,
   * its joints thrown to and fro along its axis in turn. */
  HardCase noisy_cantilever()
  {
    SceneText scene;
    scene
      .frame("0 0; 1 0; 2 0; 3 0; 4 0; 5 0; 6 0; 7 0; 8 0",
             "0 1; 1 2; 2 3; 3 4; 4 5; 5 6; 6 7; 7 8")
      .section({1e6, 1e6, 100})
      .set("Sections/section 0/Density", 1e-6)
      .support("wall", "0", "clamp")
      .load("end", "8", {"0", "0.2 * min(t / 5, 1)", "0"})
      .set("Initial velocities/forth/Joints", "1, 3, 5, 7")
      .set("Initial velocities/forth/Velocity x", 0.1)
      .set("Initial velocities/back/Joints", "2, 4, 6, 8")
      .set("Initial velocities/back/Velocity x", -0.1)
      .mesh(1)
      .time(20, 20e-3);
    return {"Noise at the highest frequency", scene.str()};
  }
} // namespace

TEST(StabilityOfMotions, ManyRevolutions)
{
  go_through(spinning_bar());
}

TEST(StabilityOfMotions, Mechanisms)
{
  go_through(thrown_chain());
  go_through(hanging_chain());
}

// Side joints, 0.25 m from the axis, go to it and beyond.
TEST(StabilityOfMotions, BarsThatComeUpright)
{
  const Course cell = go_through(cell_through_upright());
  EXPECT_LT(cell.motions.back().at(0), -0.6);
  EXPECT_GT(cell.motions.back().at(6), 0.6);
}

TEST(StabilityOfMotions, RigidPartsNearlySingular)
{
  // The crank, 0.3 m up at the start, goes to the other side.
  const Course linkage = go_through(flat_linkage());
  double       lowest  = 0;
  for (const auto &motions : linkage.motions)
    lowest = std::min(lowest, motions.at(3));
  EXPECT_LT(lowest, -0.3);
  go_through(slim_rigid_part());
  go_through(short_rigid_part());
}

TEST(StabilityOfMotions, EndsThatMeet)
{
  // The ends come nearer than the watch of connectors allows.
  const Course passing = go_through(ends_that_pass());
  double       nearest = 0.1;
  for (const auto &motions : passing.motions)
    nearest = std::min(nearest,
                       std::hypot(1 + motions.at(2) - 0.985 - motions.at(4),
                                  motions.at(3) - 0.1 - motions.at(5)));
  EXPECT_LT(nearest, 0.05 * 0.1);
  go_through(ends_that_collide());
}

TEST(StabilityOfMotions, NoiseAtTheHighestFrequency)
{
  go_through(noisy_cantilever());
}
