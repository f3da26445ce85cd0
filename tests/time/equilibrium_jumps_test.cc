#include <auxfem/time/equilibrium_jumps.h>

#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/run_program.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  struct JumpingRun
  {
    MemoryRecorder history;
    RunResult      result;
  };

  JumpingRun jumping_run_of(const SceneText                &text,
                            const std::vector<std::string> &overrides)
  {
    const Scene scene = read_scene_from_text(text.str(), "test.prm", overrides);
    MemoryRecorder history(scene, MPI_COMM_SELF);
    RunResult      result = run(scene, MPI_COMM_SELF, history);
    return {std::move(history), std::move(result)};
  }

  std::vector<Finding> jumps_of(const RunResult &result)
  {
    std::vector<Finding> jumps;
    for (const Finding &finding : result.findings)
      if (finding.text.find("The equilibrium jumps") != std::string::npos)
        jumps.push_back(finding);
    return jumps;
  }

  /** Von Mises truss of two hinged bars (EA = 3 N, span 2 m, rise 0.3 m) with
   * 0.04 t N down on its apex, joint 1. */
  const SceneText snapping_truss = SceneText()
                                     .frame("0 0; 1 0.3; 2 0", "0 1; 1 2")
                                     .given("bar", {1, 1, 1}, {3, 1, 0})
                                     .hinge("hinges", "all")
                                     .support("ends", "0, 2", "pin")
                                     .load("apex", "1", {"0", "-0.04 * t", "0"})
                                     .probe("apex", "1")
                                     .mesh(1)
                                     .time(1, 0.1, "static");

  /** Apex force with bars inclined by @p angle (rad). */
  double apex_force(const double angle)
  {
    return 6 * std::sin(angle) * (1 - 1 / std::sqrt(1.09) / std::cos(angle));
  }

  /** A frame of eight joints with equilibria close to each other. */
  SceneText random_frame()
  {
    SceneText scene;
    scene.frame(
      "0.742929114395 0.872283795284; 0.241140379909 0.116151952084; 0.079649844188 0.414984360021; 1.14023109897 0.627709377692; 0.41186133556 0.63147498684; 1.0558231487 0.0188098507964; 0.567399848961 0.327166302946; 0.0340574995915 0.979684244404",
      "0 1; 1 2; 0 3; 0 4; 3 5; 4 6; 2 7; 5 0; 1 7");
    // Width, height (m), Young's modulus (Pa).
    const double sections[9][3] = {
      {0.0158793452751, 0.0198125689708, 460557076.812},
      {0.0148847511791, 0.00834236000471, 14120039200.5},
      {0.0208202069389, 0.0196519750807, 3889001255.93},
      {0.0294361830943, 0.00606775712676, 22926516279.3},
      {0.0195003486487, 0.00775592841705, 29155045016},
      {0.0299057369728, 0.0109093449297, 211079992.752},
      {0.0224242116561, 0.0181509665891, 2493820531.07},
      {0.0224913002883, 0.0176854038677, 11748026034},
      {0.0262368539311, 0.0144967139458, 27389200042.5}};
    for (unsigned int s = 0; s < 9; ++s)
      scene
        .rectangle("s" + std::to_string(s),
                   sections[s][0],
                   sections[s][1],
                   {sections[s][2], "", 0.3})
        .set("Sections/s" + std::to_string(s) + "/Struts", s);
    scene.hinge("first", "0", "7")
      .hinge("second", "1", "8")
      .hinge("third", "7", "8");
    scene.support("clamp", "0", "clamp").support("pin", "7", "pin");
    const std::pair<const char *, SpaceTexts> loads[5] = {
      {"1", {"104.395239401 * t", "-119.61461084 * t", "0 * t"}},
      {"2", {"221.499539678 * t", "-82.1244187264 * t", "0 * t"}},
      {"3", {"-116.48952212 * t", "215.487123308 * t", "-8.203675195 * t"}},
      {"4", {"-13.732529789 * t", "-53.8801949961 * t", "10.6828478034 * t"}},
      {"5", {"-9.56718692805 * t", "38.2012330681 * t", "0 * t"}}};
    for (const auto &[joint, components] : loads)
      scene.load(std::string("l") + joint, joint, components);
    return scene.set("Lattice/Struts may cross", "true")
      .probe("tip", "1")
      .mesh(5, 1)
      .set("Effects/Large rotation", "on")
      .time(0.7, 0.05, "static");
  }
} // namespace

TEST(EquilibriumJumps, NewtonsMethodStaysOnTheConnectedPath)
{
  // Shooting with Reissner beams yields 2.0 mm. Newton's method reaches an
  // equilibrium at 76 mm in steps of 0.05 s.
  for (const char *step : {"0.05", "0.1", "0.35", "0.7"})
    {
      const JumpingRun run =
        jumping_run_of(random_frame(), {std::string("Time/Time step=") + step});
      EXPECT_NEAR(run.history.column("tip.ux").back(), 2.0e-3, 1e-4);
      EXPECT_TRUE(run.result.findings.empty())
        << verdict_text(run.result.findings);
    }
}

TEST(EquilibriumJumps, ASnapThroughIsReportedWithTimeAndJoint)
{
  const JumpingRun run   = jumping_run_of(snapping_truss, {});
  const auto       jumps = jumps_of(run.result);
  ASSERT_EQ(jumps.size(), 1u) << verdict_text(run.result.findings);
  // The energy released by a snap-through is no error.
  EXPECT_EQ(verdict_of(run.result.findings), Verdict::doubtful)
    << verdict_text(run.result.findings);
  EXPECT_EQ(jumps[0].verdict, Verdict::doubtful);
  expect_contains(jumps[0].location, {"joint 1"});
  // The limit load lies where cos^3 = cos(at rest).
  const double limit =
    apex_force(std::acos(std::cbrt(1 / std::sqrt(1.09)))) / 0.04;
  EXPECT_LE(jumps[0].time, limit);
  EXPECT_GE(jumps[0].time, limit - 0.1 / 64);
  // At the end it hangs, in tension.
  double low = std::atan(0.3), high = 1;
  while (high - low > 1e-12)
    {
      const double angle                       = (low + high) / 2;
      (-apex_force(angle) < 0.04 ? low : high) = angle;
    }
  EXPECT_NEAR(run.history.column("apex.uy").back(), -0.3 - std::tan(low), 1e-6);
}

TEST(EquilibriumJumps, JumpingLoadsAreNoJumpOfTheEquilibrium)
{
  // 0.7 of the limit load in one step, with half the stiffness at rest.
  const JumpingRun at_once =
    jumping_run_of(snapping_truss, {"Loads/apex/Force y=-0.02 * (t >= 0.5)"});
  EXPECT_TRUE(jumps_of(at_once.result).empty())
    << verdict_text(at_once.result.findings);
  const JumpingRun smooth =
    jumping_run_of(snapping_truss, {"Loads/apex/Force y=-0.025 * t^6"});
  EXPECT_TRUE(jumps_of(smooth.result).empty())
    << verdict_text(smooth.result.findings);
  EXPECT_EQ(smooth.result.work.retries, 0u);
}
