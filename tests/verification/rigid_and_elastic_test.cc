#include <auxfem/rigid/effects/rigid_part_group.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Elastic struts that end at rigid parts, clamped or hinged to them, against
// the same struts under the forces and moments that the part passes on.

namespace
{
  const Stiffnesses beam = {1e4, 1e4, 10};

  /** A cantilever of 1 m along x, clamped at the origin. */
  SceneText slender_cantilever(const std::string &joints,
                               const std::string &struts)
  {
    SceneText scene = static_frame(joints, struts);
    scene.section(beam).support("wall", "0", "clamp").mesh(4, 2);
    return scene;
  }

  SceneText &plate(SceneText         &scene,
                   const std::string &struts,
                   const std::string &elastic_struts)
  {
    const std::string path = "Rigid parts/plate/";
    scene.set(path + "Struts", struts);
    return scene.set(path + "Elastic struts", elastic_struts);
  }

  void complete(SceneText &scene, const bool is_linear)
  {
    if (is_linear)
      scene.linear();
    else
      scene.time(1, 0.25);
  }

  using Tip = std::array<double, 3>;

  Tip motion_of(const SceneRun &run, const unsigned int joint)
  {
    return {{run.motion(joint, 0),
             run.motion(joint, 1),
             run.motion(joint, rotation_z)}};
  }

  void compare(ComparisonTable &table, const Tip &found, const Tip &expected)
  {
    const char *const names[3] = {"tip ux (m)", "tip uy (m)", "tip rotation"};
    for (unsigned int c = 0; c < 3; ++c)
      // The residual's tolerance is 1e-11 of the force.
      table.row(names[c], found[c], expected[c], 1e-9);
  }
} // namespace

TEST(RigidAndElastic, ClampedPlateIsAMomentArm)
{
  // The plate's far joint is 0.2 m beyond the tip and 0.3 m above it.
  for (const bool is_linear : {false, true})
    {
      SceneText scene = slender_cantilever("0 0; 1 0; 1.2 0.3", "0 1; 1 2");
      plate(scene, "1", "clamped")
        .load("pull", "2", {{"-6 * t", "9 * t", "0"}});
      complete(scene, is_linear);
      SceneRun run(scene.str());
      run.run();
      const Tip    tip  = motion_of(run, 1);
      const double turn = is_linear
        ? tip[2]
        : run.equations.reporting().rigid_parts->rotation(0, run.state)[2];
      EXPECT_NEAR(turn, tip[2], 1e-12);
      EXPECT_GT(tip[2], 0.3);

      // Displaced position of the far joint from the tip.
      const double x = is_linear ? 0.2
                                 : 0.2 * std::cos(turn) - 0.3 * std::sin(turn),
                   y = is_linear ? 0.3
                                 : 0.2 * std::sin(turn) + 0.3 * std::cos(turn);
      SceneText bare = slender_cantilever("0 0; 1 0", "0 1");
      bare.load("pull",
                "1",
                {{"-6 * t", "9 * t", text(x * 9 + y * 6) + " * t"}});
      complete(bare, is_linear);
      SceneRun reference(bare.str());
      reference.run();
      ComparisonTable table(
        std::string("Cantilever clamped to a rigid end plate, ") +
        (is_linear ? "small displacements" : "large rotation") +
        ", against tip force and moment");
      compare(table, tip, motion_of(reference, 1));
      table.row("support moment (N m)",
                run.reaction("wall", rotation_z),
                reference.reaction("wall", rotation_z),
                1e-8);
      if (is_linear)
        {
          // u = F L^3 / 3 EI + F L / kGA + M L^2 / 2 EI, rotation F L^2 / 2 EI
          // + M L / EI.
          const double M = 0.2 * 9 + 0.3 * 6;
          table.row("tip uy, closed form",
                    tip[1],
                    9. / 30 + 9 / 1e4 + M / 20,
                    1e-9);
          table.row("tip rotation, closed form",
                    tip[2],
                    9. / 20 + M / 10,
                    1e-9);
        }
    }
}

TEST(RigidAndElastic, AHingedBeamPassesOnNoMoment)
{
  // Two equal columns under a rigid beam sway: it stays parallel, each carries
  // half the push at its tip.
  SceneText portal = static_frame("0 0; 0 1; 2 1; 2 0", "0 1; 1 2; 2 3");
  portal.section(beam).support("wall", "0, 3", "clamp").mesh(4, 2);
  plate(portal, "1", "hinged")
    .load("push", "1", {{"18 * t", "0", "0"}})
    .time(1, 0.25);
  SceneRun run(portal.str());
  run.run();

  SceneText column = static_frame("0 0; 0 1", "0 1");
  column.section(beam)
    .support("wall", "0", "clamp")
    .mesh(4, 2)
    .load("push", "1", {{"9 * t", "0", "0"}})
    .time(1, 0.25);
  SceneRun reference(column.str());
  reference.run();

  ComparisonTable table("Portal of two columns hinged to a rigid beam, against "
                        "one column under half the push");
  EXPECT_LT(reference.motion(1, rotation_z), -0.3);
  compare(table, motion_of(run, 1), motion_of(reference, 1));
  compare(table, motion_of(run, 2), motion_of(reference, 1));
  EXPECT_NEAR(run.equations.reporting().rigid_parts->rotation(0, run.state)[2],
              0,
              1e-9);
  const auto forces =
    run.equations.reporting().rigid_parts->report(0, run.state).forces;
  // The load at joint 1 acts through it, too.
  table.row("force of joint 1 on the beam (N)", forces[0][0], 9, 1e-8);
  table.row("force of joint 2 on the beam (N)", forces[1][0], -9, 1e-8);
}

TEST(RigidAndElastic, AClampedBeamKeepsTheColumnsUpright)
{
  // Small displacements, half the push on a column clamped at both ends:
  // F L^3 / (12 EI) + F L / kGA; the columns' axial forces +-N of the
  // overturning moment tilt the beam by 2 N L / (EA b).
  SceneText portal = static_frame("0 0; 0 1; 2 1; 2 0", "0 1; 1 2; 2 3");
  portal.section({1e12, 1e4, 10})
    .support("wall", "0, 3", "clamp")
    .mesh(4, 0)
    .linear();
  plate(portal, "1", "clamped").load("push", "1", {{"18 * t", "0", "0"}});
  SceneRun run(portal.str());
  run.run();
  ComparisonTable table("Portal of two columns clamped to a rigid beam, small "
                        "displacements, closed form");
  // The tilt is 1e-11.
  table.row("sway (m)", run.motion(1, 0), 9. / 120 + 9 / 1e4, 1e-9);
  table.row("rotation", run.motion(1, rotation_z), 0, 1e-9);
  table.row("moment at the feet (N m)",
            run.reaction("wall", rotation_z),
            9,
            1e-7);
}

TEST(RigidAndElastic, SupportsCarryTheWeightOfARigidPart)
{
  // An L of 4 kg, legs of 3 m and 1 m, centre at x = 1.875 m, on a pin at 0
  // and a roller at 3 m.
  SceneText scene = static_frame("0 0; 3 0; 3 1", "0 1; 1 2");
  scene.set("Rigid parts/L/Struts", "all")
    .set("Rigid parts/L/Mass", 4)
    .set("Gravity/Acceleration y", -10)
    .support("pin", "0", "pin")
    .support("roller", "1", "roller x")
    .time(1, 0.5);
  SceneRun run(scene.str());
  run.run();
  EXPECT_NEAR(run.reaction("pin", 0), 0, 1e-12);
  EXPECT_NEAR(run.reaction("pin", 1), 40 * (1 - 1.875 / 3), 1e-12);
  EXPECT_NEAR(run.reaction("roller", 1), 40 * 1.875 / 3, 1e-12);
}

TEST(RigidAndElastic, AnElasticStrutCarriesTheWeightOfARigidPart)
{
  SceneText scene = slender_cantilever("0 0; 1 0; 1.4 0.2", "0 1; 1 2");
  plate(scene, "1", "clamped")
    .set("Rigid parts/plate/Mass", 0.8)
    .set("Gravity/Acceleration y", -10)
    .set("Sections/section 0/Density", "0")
    .time(1, 0.25);
  SceneRun run(scene.str());
  run.run();
  // Displaced position of the plate's middle.
  const double x = (1 + run.motion(1, 0) + 1.4 + run.motion(2, 0)) / 2;
  EXPECT_LT(run.motion(1, rotation_z), -0.2);
  ComparisonTable table("Rigid plate of 8 N on a cantilever: its support");
  table.row("force x (N)", run.reaction("wall", 0), 0, 1e-9);
  table.row("force y (N)", run.reaction("wall", 1), 8, 1e-9);
  table.row("moment (N m)", run.reaction("wall", rotation_z), 8 * x, 1e-8);
}

TEST(RigidAndElastic, InertiaOfAClampedPlateIsThatOfAMassOnTheTip)
{
  // A rigid bar across the tip, its centre there, and a mass with the same
  // rotary inertia on the bare tip move alike.
  const auto dynamic = [](SceneText scene) {
    scene.section(beam)
      .support("wall", "0", "clamp")
      .mesh(3, 1)
      .set("Sections/section 0/Density", 1)
      .load("kick", "1", {{"0", "90 * sin(2 * t)", "20 * sin(3 * t)"}})
      .time(1, 2e-3);
    return scene;
  };
  SceneText crossed =
    dynamic(static_frame("0 0; 1 0; 1 0.3; 1 -0.3", "0 1; 1 2; 1 3"));
  plate(crossed, "1, 2", "clamped").set("Rigid parts/plate/Mass", 2);
  SceneText bare = dynamic(static_frame("0 0; 1 0", "0 1"));
  bare.set("Masses/tip/Joints", "1")
    .set("Masses/tip/Mass", 2)
    .set("Masses/tip/Rotary inertia", 2 * 0.6 * 0.6 / 12);
  const std::vector<std::string> newmark = {"Time/Scheme=newmark"};
  SceneRun run(crossed.str(), newmark), reference(bare.str(), newmark);
  run.run();
  reference.run();
  ComparisonTable table("Rigid bar across the tip of a shaken cantilever, "
                        "against a mass on the tip");
  EXPECT_GT(std::abs(run.motion(1, rotation_z)), 0.05);
  const Tip found = motion_of(run, 1), expected = motion_of(reference, 1);
  // The scheme integrates the bar's ends in place of its rotation: second order
  // in the angle of a step, and they turn slowly.
  const char *const names[3] = {"tip ux (m)", "tip uy (m)", "tip rotation"};
  for (unsigned int c = 0; c < 3; ++c)
    table.row(names[c], found[c], expected[c], 1e-7);
}
