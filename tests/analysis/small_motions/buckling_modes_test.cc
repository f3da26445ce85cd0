#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // A column 1 m long with EI = 1 N m2, and GA for the shear terms to count.
  constexpr double EI = 1, GA = 1e3, EA = 2e3;

  SceneText column(const unsigned int n_struts = 1)
  {
    std::string joints = "0 0", struts;
    for (unsigned int i = 1; i <= n_struts; ++i)
      {
        joints += "; " + text(double(i) / n_struts) + " 0";
        struts +=
          (i > 1 ? "; " : "") + std::to_string(i - 1) + " " + std::to_string(i);
      }
    return SceneText()
      .frame(joints, struts)
      .section({EA, GA, EI})
      .mesh(6, 3)
      .time(1, 0.1, "static");
  }

  SceneText pressed(SceneText scene, const std::string &joint = "1")
  {
    return scene.load("press", joint, {"-t", "0", "0"});
  }

  BucklingModes buckling_of(const SceneText   &scene_text,
                            const unsigned int n,
                            const bool         is_reversed  = false,
                            const MPI_Comm     communicator = MPI_COMM_SELF)
  {
    const Scene scene = read_scene_from_text(scene_text.str(), "test.prm", {});
    LatticeRun  run(scene, communicator);
    run.prepare();
    if (scene.time.static_start)
      run.start();
    return buckling_modes(run.solver(),
                          run.solution.state,
                          {scene.time.end_time, is_reversed},
                          n);
  }

  /** Euler's load P_E with shear by Engesser (1889): P + P^2 / GA = P_E. */
  double with_shear(const double euler)
  {
    return 2 * euler / (1 + std::sqrt(1 + 4 * euler / GA));
  }
} // namespace

TEST(BucklingModes, MatchEulerColumns)
{
  // Clamped and free; pinned; clamped with one sliding end.
  const BucklingModes
    clamped = buckling_of(pressed(column().support("foot", "0", "clamp")), 4),
    pinned =
      buckling_of(pressed(column()
                            .support("foot", "0", "pin")
                            .prescribe("top", "1", {"free", "0", "free"})),
                  4),
    both = buckling_of(pressed(column()
                                 .support("foot", "0", "clamp")
                                 .prescribe("top", "1", {"free", "0", "0"})),
                       1);
  for (unsigned int i = 0; i < 4; ++i)
    {
      const double euler       = std::pow((2 * i + 1) * pi / 2, 2) * EI,
                   pinned_load = std::pow((i + 1) * pi, 2) * EI;
      EXPECT_NEAR(clamped.modes.at(i).factor / with_shear(euler), 1, 1e-8);
      EXPECT_NEAR(pinned.modes.at(i).factor / with_shear(pinned_load), 1, 1e-8);
      EXPECT_LT(clamped.modes[i].residual, 1e-6);
    }
  EXPECT_NEAR(both.modes.at(0).factor / with_shear(4 * pi * pi * EI), 1, 1e-8);
  EXPECT_TRUE(clamped.is_counted);
  EXPECT_TRUE(pinned.is_counted);
  EXPECT_NEAR(clamped.motion, 1 / EA, 1e-9);
}

TEST(BucklingModes, MatchEulerColumnsWithoutShear)
{
  // Without compensation, shear lowers the load by 5e-3 (kl)^2 / 12, on one
  // element 4e-3. The square of this remains, besides 1e-5 from the mesh.
  for (const unsigned int order : {4, 6})
    {
      const SceneText off = column()
                              .mesh(order, order == 4 ? 1 : 0)
                              .set("Effects/Shear flexibility", "off");
      const BucklingModes
        pinned =
          buckling_of(pressed(SceneText(off)
                                .support("foot", "0", "pin")
                                .prescribe("top", "1", {"free", "0", "free"})),
                      1),
        clamped =
          buckling_of(pressed(SceneText(off).support("foot", "0", "clamp")), 1);
      EXPECT_NEAR(pinned.modes.at(0).factor / (pi * pi * EI), 1, 5e-5);
      EXPECT_NEAR(clamped.modes.at(0).factor / (pi * pi / 4 * EI), 1, 5e-6);
    }
}

TEST(BucklingModes, ReversedLoadsChangeSign)
{
  const SceneText pulled =
    column().support("foot", "0", "clamp").load("pull", "1", {"t", "0", "0"});
  EXPECT_NEAR(buckling_of(pulled, 1, /*is_reversed=*/true).modes.at(0).factor,
              with_shear(pi * pi / 4 * EI),
              1e-8);
}

TEST(BucklingModes, SquareColumnInSpaceHasPairs)
{
  const BucklingModes found =
    buckling_of(SceneText()
                  .dimension(3)
                  .frame("0 0 0; 1 0 0", "0 1")
                  .space_section({EA, GA, GA, 0.5, EI, EI})
                  .support("foot", "0", "clamp")
                  .load("press", "1", {"-t", "0", "0"}, {"0", "0", "0"})
                  .mesh(4, 3)
                  .time(1, 0.1, "static"),
                6);
  ASSERT_EQ(found.modes.size(), 6u);
  EXPECT_TRUE(found.is_counted);
  for (unsigned int i = 0; i < 6; ++i)
    EXPECT_NEAR(found.modes[i].factor /
                  with_shear(std::pow((2 * (i / 2) + 1) * pi / 2, 2) * EI),
                1,
                1e-7);
}

TEST(BucklingModes, MatchLateralBucklingOfThinCantilever)
{
  // Timoshenko & Gere 1961, art. 6.3: 4.0126 sqrt(EI_2 GJ) / L^2, without
  // warping, shear and prebuckling deflection.
  const double        across = 1e-3, torsion = 2e-3;
  const BucklingModes found =
    buckling_of(SceneText()
                  .dimension(3)
                  .frame("0 0 0; 1 0 0", "0 1")
                  .space_section({1e6, 1e6, 1e6, torsion, across, 1e3})
                  .support("foot", "0", "clamp")
                  .load("tip", "1", {"0", "-t", "0"}, {"0", "0", "0"})
                  .mesh(4, 3)
                  .time(1, 0.1, "static"),
                1);
  EXPECT_NEAR(found.modes.at(0).factor / std::sqrt(across * torsion),
              4.0126,
              5e-4);
}

TEST(BucklingModes, MatchSwayingPortal)
{
  // Clamped feet, loads on the columns, all struts alike: k h cot(k h) = -6,
  // from y = A (1 - cos k x) and the moment 6 EI / b of the beam.
  const double kh = [] {
    double low = 2, high = 3;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double x                         = (low + high) / 2;
        (x / std::tan(x) + 6 > 0 ? low : high) = x;
      }
    return low;
  }();
  const BucklingModes found =
    buckling_of(SceneText()
                  .frame("0 0; 0 1; 1 1; 1 0", "0 1; 1 2; 2 3")
                  .section({1e7, 1e7, 1})
                  .support("feet", "0, 3", "clamp")
                  .load("press", "1, 2", {"0", "-t", "0"})
                  .mesh(4, 2)
                  .time(1, 0.1, "static"),
                2);
  EXPECT_NEAR(found.modes.at(0).factor / (kh * kh), 1, 1e-5);
}

TEST(BucklingModes, IncludeConnectorAndConstraintForces)
{
  // A post of 2 m on a pin, held at its top by a spring of 3 N/m: P = k L. As a
  // connector, and as a rigid strut.
  const SceneText as_connector =
    SceneText()
      .frame("0 0; 0 2; 5 0; 6 0", "2 3")
      .section({1e3, 1e3, 1})
      .support("ground", "0, 2, 3", "clamp")
      .connector("post", "spring", "Between = 0 1 | Spring stiffness = 1e4")
      .connector("side",
                 "spring",
                 "Between = ground: 1 | Ground offset = -1, 0 | Spring "
                 "stiffness = 3")
      .load("press", "1", {"0", "-t", "0"})
      .time(1, 0.1, "static");
  const SceneText as_rigid_strut =
    SceneText()
      .frame("0 0; 0 2", "0 1")
      .add("Rigid parts/post", "Struts = all | Mass = 1")
      .support("ground", "0", "pin")
      .connector("side",
                 "spring",
                 "Between = ground: 1 | Ground offset = -1, 0 | Spring "
                 "stiffness = 3")
      .load("press", "1", {"0", "-t", "0"})
      .time(1, 0.1, "static");
  for (const SceneText &scene : {as_connector, as_rigid_strut})
    EXPECT_NEAR(buckling_of(scene, 1).modes.at(0).factor, 6, 1e-7);
}

TEST(BucklingModes, CountOnlyLoadsAddedToEquilibrium)
{
  // A load of 1 N acts from the start. Exactly P (1 + P (1 / GA - 1 / EA)) =
  // P_E.
  const SceneText scene = column()
                            .support("foot", "0", "clamp")
                            .load("press", "1", {"-1 - 0.5 * t", "0", "0"})
                            .set("Time/Start from", "static equilibrium");
  const double euler = pi * pi / 4 * EI, part = 1 / GA - 1 / EA;
  const double exact = 2 * euler / (1 + std::sqrt(1 + 4 * euler * part));
  EXPECT_NEAR(1 + 0.5 * buckling_of(scene, 1).modes.at(0).factor, exact, 1e-2);
}

TEST(BucklingModesOnRanks, AreTheSame)
{
  const SceneText scene = pressed(column(3).support("foot", "0", "clamp"), "3");
  const BucklingModes alone    = buckling_of(scene, 3),
                      together = buckling_of(scene, 3, false, MPI_COMM_WORLD);
  ASSERT_EQ(together.modes.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(together.modes[i].factor / alone.modes[i].factor, 1, 1e-9);
}

TEST(BucklingModes, ScenesWithoutBucklingAreRejected)
{
  const SceneText clamped = column().support("foot", "0", "clamp");
  expect_parts(input_error_of([&] { buckling_of(clamped, 1); }),
               {"no load", "Time of the loads"});
  expect_parts(
    input_error_of([&] {
      buckling_of(SceneText(clamped).load("tip", "1", {"0", "0", "0"}), 1);
    }),
    {"no load"});
  expect_parts(input_error_of([&] {
                 buckling_of(SceneText(clamped)
                               .load("tip", "1", {"-t", "0", "0"})
                               .set("Loads/tip/Direction", "follows the joint"),
                             1);
               }),
               {"follow their joints"});
  // The initial load exceeds the buckling load.
  expect_parts(input_error_of([&] {
                 buckling_of(SceneText(clamped)
                               .load("tip", "1", {"-10 - t", "0", "0"})
                               .set("Time/Start from", "static equilibrium"),
                             1);
               }),
               {"not stable", "negative eigenvalue"});
  // A strut beside a rigid one, which carries all of the load.
  expect_parts(input_error_of([&] {
                 buckling_of(
                   pressed(SceneText()
                             .frame("0 0; 1 0; 0.5 1", "0 1; 0 2; 2 1")
                             .section({EA, GA, EI})
                             .rigid_part("block", "0", 1)
                             .set("Rigid parts/block/Elastic struts", "clamped")
                             .support("foot", "0", "clamp")
                             .time(1, 0.1, "static")),
                   1);
               }),
               {"cause no buckling"});
}

TEST(BucklingModes, StayAccurateOnFineMeshes)
{
  // A bent frame, much stiffer along its struts than across. Reversed loads
  // have factors a thousand times smaller.
  const SceneText frame =
    SceneText()
      .frame("-0.00684 -0.00066; 0.0919 0.0621; -0.0163 0.1329; 0.0933 0.1788; "
             "0.0090 0.2412",
             "0 1; 1 2; 2 3; 3 4; 1 3")
      .circle("strut", 0.0025, {6e10, "", 0.3})
      .support("foot", "0", "pin")
      .support("side", "4", "roller x")
      .load("push", "4", {"80 * t", "0", "0"})
      .time(1, 1, "static");
  const BucklingModes coarse = buckling_of(SceneText(frame).mesh(6, 1), 3),
                      fine   = buckling_of(SceneText(frame).mesh(6, 3), 3);
  ASSERT_EQ(fine.modes.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(coarse.modes.at(i).factor / fine.modes[i].factor, 1, 2e-5);
}
