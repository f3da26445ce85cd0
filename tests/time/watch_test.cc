#include <analysis/simulation/resumed_run.h>
#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/run_program.h>
#include <support/scene_text.h>
#include <verification/one_mass_scene.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A clamped column of EI = 2 N m2 and 1 m in compression. It buckles at (pi
   * / 2)^2 EI = 4.93 N, reached at t = 0.123 s.
   */
  const SceneText column =
    SceneText()
      .frame("0 0; 1 0", "0 1")
      .given("s", {0.01, 0.01, 2e-6}, {1e6, 100, 0})
      .support("foot", "0", "clamp")
      .add("Loads/press", "Joints = 1 | Force x = -40 * t | Force y = 0")
      .mesh(3, 2)
      .time("0.2 s", "10 ms", "static");

  const std::string swinging_mass =
    one_mass_scene("Law = spring | Spring stiffness = 4",
                   "End time = 20 | Time step = 0.1",
                   mass_and_velocity(1, 1));
} // namespace

namespace
{
  /**
   * A cantilever of EI = 2 N m2, EA = 1e4 N and 1 m with 2^n elements of order
   * 1; shear adds 1e-3 of its compliance.
   */
  std::vector<Finding>
  findings_of_cantilever(const std::string              &load,
                         const unsigned int              n,
                         const std::vector<std::string> &overrides = {})
  {
    const SceneText scene = SceneText()
                              .frame("0 0; 1 0", "0 1")
                              .given("s", {0.01, 0.01, 2e-6}, {1e6, 100, 0})
                              .support("foot", "0", "clamp")
                              .add("Loads/load", "Joints = 1 | " + load)
                              .set("Effects/Shear flexibility", "on")
                              .mesh(1, n)
                              .time("1 s", "1 s", "static");
    return findings_of(scene, overrides);
  }
} // namespace

TEST(BendingWatch, KnowsTheErrorOfLinearElements)
{
  // Reduced integration misses 1 / (4 n^2) of a cantilever's deflection (T. J.
  // R. Hughes, R. L. Taylor, W. Kanoknukulchai, Int. J. Numer. Meth. Eng. 11
  // (1977) 1529-1543).
  const std::string across = "Force y = 1e-3";
  const auto        one    = findings_of_cantilever(across, 0),
             two           = findings_of_cantilever(across, 1);
  ASSERT_EQ(one.size(), 1u) << verdict_text(one);
  expect_contains(one[0].text, {"miss about 25 % of the compliance"});
  ASSERT_EQ(two.size(), 1u) << verdict_text(two);
  expect_contains(two[0].text, {"miss about 6.2 % of the compliance"});
  EXPECT_EQ(two[0].verdict, Verdict::doubtful);
  EXPECT_TRUE(findings_of_cantilever(across, 2).empty());
}

TEST(BendingWatch, RelatesBendingToItsOwnShear)
{
  for (const auto &[along_y, along_z] : {std::pair("t", "0"), {"0", "t"}})
    {
      const auto found =
        findings_of(static_space_frame("0 0; 1 0", "0 1")
                      .space_section({1e4, 5000, 5000, 1, 2, 0.5})
                      .support("foot", "0", "clamp")
                      .load("load",
                            "1",
                            {"0",
                             std::string("1e-4 * ") + along_y,
                             std::string("1e-4 * ") + along_z},
                            {"0", "0", "0"})
                      .set("Effects/Shear flexibility", "on")
                      .mesh(1)
                      .time(1, 1));
      ASSERT_EQ(found.size(), 1u) << along_y << verdict_text(found);
      expect_contains(found[0].text, {"miss about 25 % of the compliance"});
    }
}

TEST(BendingWatch, IsSilentWithoutBendingError)
{
  // There is no bending, or elements represent it.
  EXPECT_TRUE(findings_of_cantilever("Force x = 1e-3", 0).empty());
  EXPECT_TRUE(findings_of_cantilever("Moment z = 1e-3", 0).empty());
  const std::string across = "Force y = 1e-3";
  EXPECT_TRUE(
    findings_of_cantilever(across, 0, {"Effects/Shear flexibility=off"})
      .empty());
  EXPECT_TRUE(
    findings_of_cantilever(across, 0, {"Discretization/Order=2"}).empty());
}

TEST(BendingWatch, ContinuesInResumedRuns)
{
  const RecordedRun run =
    expect_same_when_resumed(static_scene()
                               .cells("star", 2, 2)
                               .rectangle("all", 4e-4, 4e-4, {70e9, 2700})
                               .support("foot", "bottom", "clamp")
                               .load("weight", "top", {"0", "-0.1 * t", "0"})
                               .set("Effects/Shear flexibility", "on")
                               .mesh(1)
                               .time(1, 0.02, "newmark"));
  expect_contains(verdict_text(run.result.findings), {"Elements of order 1"});
}

TEST(StepWatch, KnowsTheErrorOfAVibration)
{
  // omega = 2/s: (omega dt)^2 / 12.
  EXPECT_TRUE(findings_of(swinging_mass, {}).empty());
  const auto doubtful = findings_of(swinging_mass, {"Time/Time step=0.5"});
  ASSERT_EQ(doubtful.size(), 1u) << verdict_text(doubtful);
  EXPECT_EQ(doubtful[0].verdict, Verdict::doubtful);
  const auto ruinous = findings_of(swinging_mass, {"Time/Time step=2"});
  EXPECT_EQ(verdict_of(ruinous), Verdict::not_to_be_used)
    << verdict_text(ruinous);
}

TEST(StepWatch, ReportsTooFewSteps)
{
  for (const char *n_steps : {"1", "2"})
    {
      const std::string end = std::string("Time/End time=") + n_steps;
      const auto found = findings_of(swinging_mass, {end, "Time/Time step=1"});
      ASSERT_EQ(found.size(), 1u) << verdict_text(found);
      EXPECT_EQ(found[0].verdict, Verdict::doubtful);
      expect_contains(found[0].text, {"three consecutive"});
      // Error-controlled steps are judged one by one.
      const auto by_tolerance = findings_of(swinging_mass,
                                            {end,
                                             "Time/Time step=1",
                                             "Time/Relative tolerance=0.01",
                                             "Time/Scheme=esdirk"});
      expect_without(verdict_text(by_tolerance), {"three consecutive"});
    }
  // A mass at rest stays at rest in any step.
  EXPECT_TRUE(findings_of(one_mass_scene("Law = spring | Spring stiffness = 4",
                                         "End time = 2 | Time step = 1",
                                         mass_and_velocity(1, 0)),
                          {})
                .empty());
  // Three steps reveal that they are too long.
  const auto known =
    findings_of(swinging_mass, {"Time/End time=3", "Time/Time step=1"});
  ASSERT_EQ(known.size(), 1u) << verdict_text(known);
  expect_contains(known[0].text, {"each misses about"});
}

TEST(StepWatch, AllowsLongerRungeKuttaSteps)
{
  // Order 4 needs few steps: 6 a period suffice, 2 are too few for any scheme.
  const std::vector<std::string> sound    = {"Time/Scheme=esdirk",
                                             "Time/Time step=0.5"},
                                 doubtful = {"Time/Scheme=esdirk",
                                             "Time/Time step=1.5"};
  EXPECT_TRUE(findings_of(swinging_mass, sound).empty());
  EXPECT_GE(verdict_of(findings_of(swinging_mass, doubtful)),
            Verdict::doubtful);
}

namespace
{
  /** Half a sine. */
  const std::string three_steps = "sin(pi * t / 0.3) * (t < 0.3)";

  /** A weakly supported mass under a force along x, in steps of 0.1 s. */
  std::string pushed_mass(const std::string &force)
  {
    return one_mass_scene("Law = spring | Spring stiffness = 1e-3",
                          "End time = 10 | Time step = 0.1",
                          SceneText(mass_and_velocity(1, 0))
                            .add("Loads/push",
                                 "Joints = 0 | Force x = " + force));
  }
} // namespace

TEST(LoadStepWatch, KnowsTheStepErrorOfAPulse)
{
  // The trapezoidal rule of half a sine in n steps: pi / 2n * cot(pi / 2n).
  const auto found = findings_of(pushed_mass(three_steps));
  ASSERT_EQ(found.size(), 1u) << verdict_text(found);
  EXPECT_EQ(found[0].verdict, Verdict::doubtful);
  EXPECT_NE(found[0].text.find("Loads/push/Force x"), std::string::npos);
  EXPECT_NE(found[0].text.find("miss 9.3 % of its impulse"), std::string::npos)
    << found[0].text;
  EXPECT_TRUE(
    findings_of(pushed_mass("sin(pi * t / 0.6) * (t < 0.6)")).empty());
  EXPECT_TRUE(
    findings_of(pushed_mass(three_steps), {"Time/Scheme=esdirk"}).empty());
}

TEST(LoadStepWatch, KnowsWholePeriodsWithinSteps)
{
  // Zero at all ends of steps, like its impulse over each step.
  for (const char *load : {"sin(20 * pi * t)", "sin(60 * pi * t)"})
    for (const char *scheme : {"newmark", "esdirk", "energy-momentum"})
      {
        const auto found = findings_of(pushed_mass(load),
                                       {std::string("Time/Scheme=") + scheme});
        ASSERT_GE(found.size(), 1u) << load << ' ' << scheme;
        EXPECT_EQ(found[0].verdict, Verdict::doubtful);
        expect_contains(found[0].text, {"Loads/push/Force x", "within steps"});
      }
}

// Steps end at kinks and jumps.
TEST(LoadStepWatch, AcceptsPiecewiseLinearLoads)
{
  EXPECT_TRUE(
    findings_of(pushed_mass("min(t / 0.17, 1) * (t < 0.33)")).empty());
}

TEST(StabilityWatch, SaysWhenAndWhereAColumnBucklesInStatics)
{
  const auto straight = findings_of(column, {});
  ASSERT_EQ(straight.size(), 1u) << verdict_text(straight);
  EXPECT_EQ(straight[0].verdict, Verdict::doubtful);
  // The first step beyond it or the next one, as factorizations are reused.
  EXPECT_GE(straight[0].time, 0.123);
  EXPECT_LE(straight[0].time, 0.15);
  EXPECT_NE(straight[0].location.find("joint 1"), std::string::npos)
    << straight[0].location;
  EXPECT_NE(straight[0].text.find("Force x: '-40 * t' = -5"), std::string::npos)
    << straight[0].text;

  const auto below = findings_of(column, {"Time/End time=0.12"});
  EXPECT_TRUE(below.empty()) << verdict_text(below);
  // A lateral load bends it, and the bent column is stable.
  const auto bent = findings_of(column, {"Loads/press/Force y=0.5*t"});
  EXPECT_TRUE(bent.empty()) << verdict_text(bent);
}

TEST(StabilityWatch, SaysWhenAColumnBucklesInMotion)
{
  const std::vector<std::string> motion = {"Time/Scheme=newmark",
                                           "Time/Time step=2 ms",
                                           "Time/End time=2"};
  const auto                     with   = [&motion](const std::string &load) {
    auto overrides = motion;
    overrides.push_back("Loads/press/Force x=" + load);
    return overrides;
  };
  // The slowest disturbance grows as exp(13 t / s).
  const auto pressed = findings_of(column, with("-40 * min(1, 10 * t)"));
  ASSERT_EQ(pressed.size(), 1u) << verdict_text(pressed);
  EXPECT_EQ(pressed[0].verdict, Verdict::doubtful);
  EXPECT_NE(pressed[0].text.find("disturbance"), std::string::npos);
  const auto below = findings_of(column, with("-4 * min(1, 10 * t)"));
  EXPECT_TRUE(below.empty()) << verdict_text(below);
}

TEST(StabilityWatch, ChecksMotionsOfFewSteps)
{
  // A disturbance grows as exp(13 t / s), here over 2 s in 40 iterations.
  const std::vector<std::string> few   = {"Time/Scheme=newmark",
                                          "Time/Time step=50 ms",
                                          "Time/End time=2",
                                          "Loads/press/Force x=-40 * min(1, t)"};
  const auto                     found = findings_of(column, few);
  ASSERT_GE(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, Verdict::doubtful);
  expect_contains(found[0].text, {"Stability is lost", "disturbance"});
}

TEST(StabilityWatch, ChecksFollowerLoads)
{
  // Follower load, of which the part n rotates with the tip: cos(k l) = -n /
  // (1 - n) (Ziegler, Principles of Structural Stability); n = 1/4 yields 7.3
  // N.
  const std::vector<std::string> partly_following = {
    "Loads/press/Force x=-30 * t",
    "Loads/press along the tip/Joints=1",
    "Loads/press along the tip/Direction=follows the joint",
    "Loads/press along the tip/Force x=-10 * t",
    "Time/End time=0.25"};
  const auto found = findings_of(column, partly_following);
  ASSERT_EQ(found.size(), 1u) << verdict_text(found);
  EXPECT_GE(found[0].time, 0.1825);
  EXPECT_LE(found[0].time, 0.2);
  EXPECT_NE(found[0].text.find("at least 1 mode"), std::string::npos)
    << found[0].text;

  auto below = partly_following;
  below.push_back("Time/End time=0.18");
  EXPECT_TRUE(findings_of(column, below).empty());
}

TEST(StabilityWatch, ChecksIterativelySolvedScenes)
{
  const std::vector<std::string> motion = {
    "Time/Scheme=newmark",
    "Time/Time step=2 ms",
    "Time/End time=2",
    "Loads/press/Force x=-40 * min(1, 10 * t)"};
  for (const auto &overrides : {std::vector<std::string>(), motion})
    {
      const auto direct       = findings_of(column, overrides);
      auto       by_iteration = overrides;
      by_iteration.push_back("Solver/Type=gmres");
      const auto found = findings_of(column, by_iteration);
      ASSERT_EQ(direct.size(), 1u);
      ASSERT_EQ(found.size(), 1u) << verdict_text(found);
      EXPECT_EQ(found[0].verdict, Verdict::doubtful);
      EXPECT_EQ(found[0].location, direct[0].location);
      EXPECT_EQ(found[0].time, direct[0].time);
    }
}

TEST(Watches, AgreeInResumedRuns)
{
  const auto findings = [](const std::string              &text,
                           const std::vector<std::string> &overrides) {
    return expect_same_when_resumed(text, overrides).result.findings;
  };
  EXPECT_EQ(findings(swinging_mass, {"Time/Time step=0.5"}).size(), 1u);
  EXPECT_EQ(findings(swinging_mass,
                     {"Time/Relative tolerance=1e-3", "Time/Time step=0.5"})
              .size(),
            0u);
  EXPECT_EQ(findings(pushed_mass(three_steps), {}).size(), 1u);
  EXPECT_EQ(findings(column, {}).size(), 1u);
  EXPECT_EQ(findings(column,
                     {"Time/Scheme=newmark",
                      "Time/Time step=2 ms",
                      "Time/End time=2",
                      "Loads/press/Force x=-40 * min(1, 10 * t)"})
              .size(),
            1u);
}

TEST(StabilityWatch, AFreeBodyIsStable)
{
  const auto free = findings_of(SceneText(column).remove("Supports/foot"),
                                {"Time/Scheme=newmark",
                                 "Time/Time step=1 ms",
                                 "Time/End time=0.4",
                                 "Loads/press/Force x=0",
                                 "Loads/press/Force y=if(t < 0.05, 1, 0)"});
  EXPECT_TRUE(free.empty()) << verdict_text(free);
}

TEST(StrainWatch, KnowsTheStrainOfABarAndItsOuterFibres)
{
  const auto findings = [](const std::string &x, const std::string &turn) {
    return findings_of(column,
                       {"Loads/press/Force x=0",
                        "Supports/pull/Type=prescribed",
                        "Supports/pull/Joints=1",
                        "Supports/pull/Displacement x=" + x,
                        "Supports/pull/Rotation z=" + turn});
  };
  const auto stretched = findings("3 * t", "0");
  ASSERT_EQ(stretched.size(), 1u) << verdict_text(stretched);
  EXPECT_EQ(stretched[0].verdict, Verdict::doubtful);
  EXPECT_EQ(stretched[0].location, "strut 0");
  EXPECT_EQ(stretched[0].time, 0.2);
  EXPECT_NE(stretched[0].text.find(" 60 %"), std::string::npos)
    << stretched[0].text;
  EXPECT_EQ(verdict_of(findings("2.4 * t", "0")), Verdict::sound);
  EXPECT_EQ(verdict_of(findings("6 * t", "0")), Verdict::not_to_be_used);

  // Without an end force the curve is a circle without stretch. A section
  // radius of a fifth of its length prevents closing.
  const auto bent = [](const double strain) {
    const double curvature = strain / 0.2,
                 stiffness = 1e6 * std::acos(-1.) / 4 * std::pow(0.2, 4);
    return findings_of(
      SceneText(column).remove("Sections/s").circle("s", 0.2, {1e6, 100, 0}),
      {"Loads/press/Force x=0",
       "Loads/press/Moment z=" + std::to_string(stiffness * curvature) +
         " * t / 0.2"});
  };
  EXPECT_EQ(verdict_of(bent(0.49)), Verdict::sound);
  EXPECT_EQ(verdict_of(bent(0.51)), Verdict::doubtful);
}

TEST(SpinWatch, KnowsAxesAboutWhichDisturbancesGrow)
{
  // A T that spins about its middle (x) or largest (z) principal axis: bars of
  // 2 m along y and of 1 m along x.
  const auto spin = [](const std::string &axis) {
    return findings_of(
      SceneText()
        .dimension(3)
        .frame("0 -1 0; 0 0 0; 0 1 0; 1 0 0", "0 1; 1 2; 1 3")
        .circle("bar", 0.05, {200e9, 7800, 0.3})
        .add("Initial velocities/spin",
             "Joints = all | Angular velocity " + axis + " = 10")
        .mesh(2)
        .time(2, 0.05, "esdirk")
        .set("Time/Relative tolerance", "1e-4"));
  };
  const auto grows = [](const Finding &finding) {
    return finding.text.find("spins about an axis") != std::string::npos;
  };
  const auto middle = spin("x"), largest = spin("z");
  const auto found = std::find_if(middle.begin(), middle.end(), grows);
  ASSERT_NE(found, middle.end()) << verdict_text(middle);
  EXPECT_EQ(found->verdict, Verdict::doubtful);
  EXPECT_TRUE(std::none_of(largest.begin(), largest.end(), grows))
    << verdict_text(largest);
}
