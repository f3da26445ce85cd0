#include <auxfem/rigid/effects/rigid_part_group.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Joints that move together, slide along lines and act through levers, against
// closed forms.

namespace
{
  constexpr double tied_EI = 3, ladder_gravity = 9.81;

  /** Cantilevers of 1 m and 2 m along x, whose tips 1 and 3 carry @p load. */
  SceneText tied_cantilevers(const SpaceTexts &load)
  {
    return SceneText()
      .frame("0 0; 1 0; 0 1; 2 1", "0 1; 2 3")
      .section({1e9, 1e9, tied_EI})
      .support("walls", "0, 2", "clamp")
      .load("load", "1", load)
      .set("Effects/Large rotation", "off")
      .time(1, 1, "static");
  }

  /** A bar of 1 m and 1 kg whose ends slide along a wall and a floor, let go
   * at @p angle from the wall. */
  SceneText sliding_ladder(const double angle, const double dt)
  {
    const std::string top  = "0 " + text(std::cos(angle)),
                      foot = text(std::sin(angle)) + " 0";
    return SceneText()
      .frame(top + "; " + foot, "0 1")
      .rigid_part("bar", "all", 1)
      .add("Constraints/wall", "Type = line | Joints = 0 | Direction = 0 1")
      .add("Constraints/floor", "Type = line | Joints = 1 | Direction = 1 0")
      .set("Gravity/Acceleration y", -ladder_gravity)
      .time(0.4, dt, "energy-momentum");
  }
} // namespace

TEST(Constraints, TiedTipsShareTheirLoad)
{
  // Tip stiffnesses 3 EI / l^3; tied rotations would change them.
  SceneRun run(tied_cantilevers({"0", "0.01", "0"})
                 .add("Constraints/tips", "Joints = 1, 3 | Components = y"));
  run.run();
  const double    k_1 = 3 * tied_EI, k_2 = 3 * tied_EI / 8;
  ComparisonTable table("Cantilevers of 1 m and 2 m with tied tips");
  table.relative("deflection", run.motion(1, 1), 0.01 / (k_1 + k_2), 1e-6);
  table.row("difference", run.motion(1, 1) - run.motion(3, 1), 0, 1e-15);
}

TEST(Constraints, TiedRotationsShareTheirMoment)
{
  // Rotational stiffnesses EI / l of a tip that is free to deflect.
  SceneRun run(
    tied_cantilevers({"0", "0", "0.01"})
      .add("Constraints/tips", "Joints = 1, 3 | Components = rotation z"));
  run.run();
  ComparisonTable table("Cantilevers with tied rotations of their tips");
  table.relative("rotation",
                 run.motion(1, rotation_z),
                 0.01 / (tied_EI + tied_EI / 2),
                 1e-9);
}

TEST(Constraints, ALeverMultipliesForces)
{
  // v_3 = -2 v_1: a virtual displacement of tip 1 moves tip 3 twice as far.
  SceneRun run(
    tied_cantilevers({"0", "0.01", "0"})
      .add("Constraints/lever",
           "Type = linear relation | Relation = 4 y of 1; 2 y of 3"));
  run.run();
  ComparisonTable table("Cantilevers joined by a lever");
  table.relative("deflection",
                 run.motion(1, 1),
                 0.01 / (3 * tied_EI + 4 * 3 * tied_EI / 8),
                 1e-6);
  table.relative("at the other end",
                 run.motion(3, 1),
                 -0.02 / (3 * tied_EI + 4 * 3 * tied_EI / 8),
                 1e-6);
}

TEST(Constraints, ALadderSlidesDown)
{
  // Its centre moves on a circle of half its length: with the angle a from the
  // wall 2/3 a'^2 L = g (1 - cos a ...), by energy
  // a'^2 = 3 g (cos a_0 - cos a) / L.
  const double    start = 0.3;
  ComparisonTable table("Ladder between a wall and a floor");
  const auto      error = [&](const double dt) {
    SceneRun run(sliding_ladder(start, dt));
    run.run();
    EXPECT_LT(std::abs(run.balance()), 1e-10);
    const double height = std::cos(start) + run.motion(0, 1),
                 width  = std::sin(start) + run.motion(1, 0);
    EXPECT_NEAR(std::hypot(height, width), 1, 1e-12);
    EXPECT_NEAR(run.motion(0, 0), 0, 1e-15);
    // x = L sin a has the velocity L cos a a'.
    const double rate = run.velocity(1, 0) / height;
    return std::abs(rate -
                    std::sqrt(3 * ladder_gravity * (std::cos(start) - height)));
  };
  const double coarse = error(0.01), fine = error(0.005);
  table.row("error of its spin at 5 ms (1/s)", fine, 0, 2e-3);
  table.row("order", std::log2(coarse / fine), 2, 0.1);
}

TEST(Constraints, AMassOnAnInclineFallsWithoutFriction)
{
  ComparisonTable table("Mass on a line in space, 1 s of fall");
  for (const char *scheme : {"newmark", "energy-momentum", "generalized-alpha"})
    {
      SceneRun run(SceneText()
                     .dimension(3)
                     .frame("0 0 0; 1 0 0; 0 0 5", "0 1")
                     .circle("rod", 0.01, {1e9, 1000})
                     .support("wall", "0", "clamp")
                     .mass("bead", "2", 2)
                     .add("Constraints/wire",
                          "Type = line | Joints = 2 | Direction = 1 2 -2")
                     .set("Gravity/Acceleration z", -ladder_gravity)
                     .time(1, 0.001, scheme));
      run.run();
      // g sin = 2 g / 3 along the line.
      const double way = ladder_gravity / 3;
      table.relative(scheme, run.motion(2, 2), -way * 2 / 3, 1e-9);
      EXPECT_NEAR(run.motion(2, 0), way / 3, 1e-9);
      EXPECT_NEAR(run.motion(2, 1), way * 2 / 3, 1e-9);
    }
}
