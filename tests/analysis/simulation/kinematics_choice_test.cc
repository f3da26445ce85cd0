#include <auxfem/analysis/simulation/kinematics_choice.h>
#include <auxfem/output/recorder.h>

#include <analysis/simulation/resumed_run.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A history with the decision about its run. */
  class DecidedHistory : public MemoryRecorder
  {
  public:
    explicit DecidedHistory(const Scene &scene)
      : MemoryRecorder(scene, MPI_COMM_WORLD)
    {}

    void begin(const Equations &equations) override
    {
      ++n_beginnings;
      is_exact = equations.model().plan.simulated.large_rotation;
      reason =
        equations.model().plan.simulated.decision("large rotation").reason;
      contact = equations.model().plan.simulated.decision("contact");
      MemoryRecorder::begin(equations);
    }

    void finish(const Solution & /*last*/, const RunResult &result) override
    {
      estimate         = result.small_displacement_error;
      n_factorizations = result.work.factorizations;
    }

    unsigned int          n_beginnings = 0;
    bool                  is_exact     = false;
    std::string           reason;
    EffectDecision        contact;
    std::optional<double> estimate;
    unsigned long         n_factorizations = 0;
  };

  struct DecidedRun
  {
    DecidedRun(SceneText scene, const std::string &large_rotation)
      : scene(read_scene_from_text(
          scene.set("Effects/Large rotation", large_rotation).str(),
          "test.prm"))
      , history(this->scene)
      , result(run_with_chosen_kinematics(this->scene, MPI_COMM_WORLD, history))
    {}

    const Scene     scene;
    DecidedHistory  history;
    const RunResult result;
  };

  /** Largest distance of the probe `tip` over its largest displacement. */
  double change(const DecidedRun &one, const DecidedRun &exact)
  {
    double largest = 0, distance = 0;
    for (std::size_t i = 0; i < exact.history.rows().size(); ++i)
      {
        double square = 0, distance_square = 0;
        for (std::size_t c = 0; c < exact.history.columns().size(); ++c)
          if (exact.history.columns()[c].name.find("tip.u") == 0)
            {
              const double now = exact.history.rows()[i][c];
              square += now * now;
              distance_square += std::pow(one.history.rows()[i][c] - now, 2);
            }
        largest  = std::max(largest, square);
        distance = std::max(distance, distance_square);
      }
    return std::sqrt(distance / largest);
  }

  /** Under @p forces (N) on its end that rise for 50 ms. */
  SceneText cantilever(const unsigned int         dimension,
                       const std::vector<double> &forces)
  {
    SceneText scene;
    scene.dimension(dimension).frame(dimension == 2 ? "0 0; 1 0"
                                                    : "0 0 0; 1 0 0",
                                     "0 1");
    scene.circle("rod", 0.005, {70e9, 2700, 0.3});
    scene.support("clamp", "0", "clamp").probe("tip", "1");
    scene.set("Loads/push/Joints", "1");
    for (unsigned int c = 0; c < dimension; ++c)
      scene.set(std::string("Loads/push/Force ") + "xyz"[c],
                text(forces[c]) + " * min(t / 0.05, 1)");
    return scene.mesh(3, 1).time(0.2, 0.001, "newmark");
  }

  /** Stocky struts, most of them under axial loads. */
  SceneText portal(const double force)
  {
    SceneText scene;
    scene.frame("0 0; 0 1; 1 1; 1 0", "0 1; 1 2; 2 3");
    scene.circle("rod", 0.02, {70e9, 2700, 0.3});
    scene.support("clamp", "0, 3", "clamp").probe("tip", "1, 2");
    scene.set("Loads/push/Joints", "1, 2")
      .set("Loads/push/Force y", text(-force) + " * t / 0.2")
      .set("Loads/push/Force x", text(force) + " * t / 2");
    return scene.mesh(3).time(0.2, 0.001, "generalized-alpha");
  }

  /** Euler load (N) of the cantilever, a quarter of that with hinged ends. */
  const double critical =
    std::pow(pi / 2, 2) * 70e9 * pi * std::pow(0.005, 4) / 4;

  /**
   * In resonance with its first bending mode. The amplitude exceeds four times
   * the static response to @p force (N).
   */
  SceneText swung(const double force)
  {
    const double frequency =
      std::pow(1.8751, 2) * std::sqrt(70e9 / 2700) * 0.005 / 2;
    return cantilever(2, {0, 0}).set("Loads/push/Force y",
                                     text(force) + " * sin(" + text(frequency) +
                                       " * t)");
  }

  SceneText statics(SceneText scene)
  {
    return scene.set("Time/Scheme", "static").set("Time/Time step", 0.01);
  }
} // namespace

TEST(KinematicsChoice, SmallLoadsNeedOneIterationAStep)
{
  const SceneText  scene = cantilever(3, {0, 0.03, 0.02});
  const DecidedRun chosen(scene, "auto"), exact(scene, "on");
  EXPECT_FALSE(chosen.history.is_exact);
  EXPECT_EQ(chosen.history.n_beginnings, 1u);
  EXPECT_EQ(chosen.result.work.iterations, 200u);
  // Factorizations of the steps, and of exact kinematics: at rest, at the
  // predicted response, and at rest again.
  EXPECT_EQ(chosen.history.n_factorizations, 4u);
  EXPECT_GT(exact.result.work.iterations, 380u);
  EXPECT_LT(change(chosen, exact), 1e-3);
  EXPECT_NE(chosen.history.reason.find("small displacements"),
            std::string::npos);
}

TEST(KinematicsChoice, AGrowingLoadRestartsTheRun)
{
  const SceneText  scene = swung(0.05);
  const DecidedRun chosen(scene, "auto"), exact(scene, "on");
  EXPECT_EQ(chosen.history.n_beginnings, 2u);
  EXPECT_TRUE(chosen.history.is_exact);
  EXPECT_EQ(chosen.history.rows(), exact.history.rows());
  for (const char *words :
       {"error of small displacements is", "run again from the start"})
    EXPECT_NE(chosen.history.reason.find(words), std::string::npos)
      << chosen.history.reason;
  EXPECT_GT(chosen.result.work.iterations, exact.result.work.iterations);
  EXPECT_EQ(chosen.result.work.steps, exact.result.work.steps);
}

TEST(KinematicsChoice, DetectsCompressionWithoutMotion)
{
  // A transverse load bends a column until half the time, with the largest
  // error of small displacements; then twice its buckling load acts.
  const auto pressed = [](const double part) {
    SceneText scene = statics(cantilever(2, {0, 0}));
    scene.set("Loads/push/Force x",
              text(-part * critical) + " * max(0, t / 0.1 - 1)");
    scene.set("Loads/push/Force y",
              "0.1 * min(t / 0.1, 1) * (1 - 0.01 * max(0, t / 0.1 - 1))");
    return scene.set("Time/Time step", 0.001);
  };
  const DecidedRun relieved(pressed(0), "auto"), chosen(pressed(2), "auto"),
    exact(pressed(2), "on");
  EXPECT_FALSE(relieved.history.is_exact);
  EXPECT_TRUE(chosen.history.is_exact);
  EXPECT_EQ(chosen.history.n_beginnings, 2u);
  EXPECT_EQ(chosen.history.rows(), exact.history.rows());
}

TEST(KinematicsChoice, DetectsABriefLoadOnAStraightColumn)
{
  // No bending; the load acts before the first check, and between two checks.
  const auto pressed =
    [&](const double part, const double time, const std::string &scheme) {
      return cantilever(2, {0, 0})
        .set("Loads/push/Force x",
             text(-critical) + " * (0.02 + " + text(part) + " * exp(-((t - " +
               text(time) + ") / 0.002)^2))")
        .set("Time/Scheme", scheme)
        .set("Time/Time step", 0.0001);
    };
  for (const std::string scheme : {"static", "newmark"})
    for (const double time : {0.005, 0.105})
      {
        SCOPED_TRACE(scheme + ", " + text(time));
        const DecidedRun little(pressed(0.5, time, scheme), "auto"),
          much(pressed(1.5, time, scheme), "auto");
        EXPECT_FALSE(little.history.is_exact) << little.history.reason;
        EXPECT_TRUE(much.history.is_exact);
        EXPECT_NE(much.history.reason.find("not positive"), std::string::npos)
          << much.history.reason;
      }
}

TEST(KinematicsChoice, DetectsAPulseBetweenTwoChecks)
{
  // The pulse lasts a tenth of the interval between checks; loads are sampled
  // at quarters of the time.
  const auto pulse = [](const double force) {
    return statics(cantilever(2, {0, 0}))
      .set("Loads/push/Force y",
           text(force) + " * exp(-((t - 0.105) / 0.001)^2)")
      .set("Time/Time step", 0.0002);
  };
  const DecidedRun small(pulse(0.01), "auto"), chosen(pulse(10), "auto"),
    exact(pulse(10), "on");
  EXPECT_FALSE(small.history.is_exact);
  EXPECT_TRUE(chosen.history.is_exact);
  EXPECT_EQ(chosen.history.rows(), exact.history.rows());
  // Three and a half times the load within the tolerance.
  const auto raised = [](const double part) {
    return statics(cantilever(2, {0, 0}))
      .set("Loads/push/Force y",
           "0.25 * (1 + " + text(part) + " * exp(-((t - 0.105) / 0.001)^2))")
      .set("Time/Time step", 0.0002);
  };
  const DecidedRun level(raised(0), "auto");
  EXPECT_FALSE(level.history.is_exact) << level.history.reason;
  EXPECT_TRUE(DecidedRun(raised(3), "auto").history.is_exact);
}

TEST(KinematicsChoice, ContactNeedsLargeMotions)
{
  const DecidedRun small(cantilever(2, {0, 0.03}), "auto");
  EXPECT_FALSE(small.history.is_exact);
  EXPECT_FALSE(small.history.contact.on);
  EXPECT_NE(small.history.contact.reason.find("small displacements"),
            std::string::npos);
  // Starts with small displacements, then uses exact ones.
  const DecidedRun grown(swung(0.05), "auto");
  EXPECT_EQ(grown.history.n_beginnings, 2u);
  EXPECT_TRUE(grown.history.contact.on);
  EXPECT_NE(grown.history.contact.reason.find("may touch"), std::string::npos);
}

TEST(KinematicsChoice, DetectsContactOfPrescribedMotions)
{
  // No rotations. Small displacements know no contact, and one strut would end
  // up beyond the other.
  const auto pushed = [](const std::string &way) {
    SceneText scene;
    scene.frame("0 0; 1 0; 0.3 0.1; 0.7 0.1", "0 1; 2 3")
      .circle("rod", 0.005, {70e9, 2700, 0.3})
      .prescribe("push", "2, 3", {"0", "-" + way, "0"})
      .probe("tip", "1");
    return scene.mesh(3, 2).time(1, 0.002, "generalized-alpha");
  };
  const DecidedRun apart(pushed("0.08 * t"), "auto");
  EXPECT_FALSE(apart.history.is_exact);
  // Moves to the end, or briefly: at 90 mm of the way the axes are 10 mm
  // apart.
  const std::array<std::pair<std::string, double>, 2> ways = {
    {{"0.3 * t", 0.3}, {"0.0901 * exp(-((t - 0.525) / 0.01)^2)", 0.525}}};
  for (const auto &[way, time] : ways)
    {
      SCOPED_TRACE(way);
      const DecidedRun touching(pushed(way), "auto"), exact(pushed(way), "on");
      EXPECT_TRUE(touching.history.is_exact);
      EXPECT_EQ(touching.history.n_beginnings, 2u);
      const std::string &reason = touching.history.reason,
                        words   = "struts 0 and 1 touch (t = ";
      ASSERT_NE(reason.find(words), std::string::npos) << reason;
      EXPECT_NEAR(std::stod(reason.substr(reason.find(words) + words.size())),
                  time,
                  0.0021);
      EXPECT_EQ(touching.history.rows(), exact.history.rows());
    }
}

TEST(KinematicsChoice, ResumedRunsKeepTheDecision)
{
  // Small displacements; exact ones from the start; small ones first.
  for (SceneText scene : {cantilever(2, {0, 0.03}),
                          statics(cantilever(3, {0, 0.03, 0.03})),
                          cantilever(2, {0, 100}),
                          swung(0.05)})
    expect_same_when_resumed(scene.set("Effects/Large rotation", "auto"));
}

TEST(KinematicsChoice, LargeLoadsStartWithExactKinematics)
{
  const DecidedRun chosen(cantilever(2, {0, 100}), "auto");
  EXPECT_EQ(chosen.history.n_beginnings, 1u);
  EXPECT_TRUE(chosen.history.is_exact);
  EXPECT_NE(chosen.history.reason.find("rotations reach"), std::string::npos);
}

TEST(KinematicsChoice, DetectsRotationsInResonance)
{
  struct Family
  {
    std::string                      name;
    std::function<SceneText(double)> scene;
  };
  const std::vector<Family> families = {
    {"cantilever",
     [](const double f) {
       return cantilever(2, {0, f});
     }},
    {"cantilever in space",
     [](const double f) {
       return cantilever(3, {-10 * f, f, 2 * f});
     }},
    {"column with a side load",
     [](const double f) {
       return cantilever(2, {-100 * f, f});
     }},
    {"portal", [](const double f) { return portal(100 * f); }},
    {"portal at rest",
     [](const double f) { return statics(portal(100 * f)); }}};
  for (const Family &family : families)
    for (double force = 1e-3; force < 10; force *= 4)
      {
        // Steps need not resolve motions, which are only compared.
        const SceneText scene =
          family.scene(force).set("Time/Time step", 0.004);
        const DecidedRun chosen(scene, "auto"), exact(scene, "on"),
          small(scene, "off");
        const double error = change(small, exact);
        if (error < 1e-3 / 3)
          {
            EXPECT_FALSE(chosen.history.is_exact)
              << family.name << ' ' << force << ": " << error << ", "
              << chosen.history.reason;
          }
        if (error > 3e-3)
          {
            EXPECT_TRUE(chosen.history.is_exact)
              << family.name << ' ' << force << ": " << error << ", "
              << chosen.history.estimate.value_or(-1);
          }
      }
}

TEST(KinematicsChoice, ABuckledColumnIsExact)
{
  // Straight columns, which only their stiffness reveals as unstable.
  for (const double part : {0.7, 1.1})
    {
      const DecidedRun chosen(statics(cantilever(2, {-part * critical, 0})),
                              "auto");
      EXPECT_EQ(chosen.history.is_exact, part > 1) << chosen.history.reason;
      EXPECT_EQ(chosen.result.findings.empty(), part < 1);
    }
}

TEST(KinematicsChoice, LoadsThatFollowTheJointAreExact)
{
  // The stiffness includes the current load: a pull that rotates with the end
  // of a straight rod destabilizes it.
  const DecidedRun chosen(statics(cantilever(2, {critical, 0}))
                            .mesh(3)
                            .set("Loads/push/Direction", "follows the joint"),
                          "auto");
  EXPECT_TRUE(chosen.history.is_exact) << chosen.history.reason;
  EXPECT_EQ(chosen.history.n_beginnings, 1u);
}

TEST(KinematicsChoice, DetectsTheStretchOfClampedStruts)
{
  // A clamped rod of 1 m under 1 mm of deflection carries a quarter of its
  // thickness by membrane forces, which small displacements lack.
  const auto held = [](const double force, const std::string &scheme) {
    SceneText scene;
    scene.frame("0 0; 0.5 0; 1 0", "0 1; 1 2");
    scene.circle("rod", 0.002, {70e9, 2700, 0.3});
    scene.support("clamp", "0, 2", "clamp").probe("tip", "1");
    scene.set("Loads/push/Joints", "1")
      .set("Loads/push/Force y", text(force) + " * min(t / 0.05, 1)");
    return scene.mesh(3, 4).time(0.2, 0.001, scheme);
  };
  for (const std::string scheme : {"static", "newmark"})
    for (double force = 1e-3; force < 2; force *= 2)
      {
        SCOPED_TRACE(scheme + ", " + text(force));
        const SceneText  scene = held(force, scheme);
        const DecidedRun chosen(scene, "auto");
        const double     error =
          change(DecidedRun(scene, "off"), DecidedRun(scene, "on"));
        if (error < 1e-4)
          {
            EXPECT_FALSE(chosen.history.is_exact) << error;
          }
        if (error > 2e-3)
          {
            EXPECT_TRUE(chosen.history.is_exact) << error;
          }
      }
}

TEST(KinematicsChoice, DetectsBucklingThatTheErrorDoesNotShow)
{
  // Brief loads: a strip that buckles laterally (Prandtl: 4.013 sqrt(EI GJ) /
  // L^2) without strut compression, and a straight column beside a rod that
  // bends more than the column's load.
  const auto raised = [](const double part) {
    return "(0.3 + " + text(part) + " * exp(-((t - 0.105) / 0.002)^2))";
  };
  const auto strip = [&](const double part) {
    const double thickness = 0.0005, height = 0.1;
    const double bending = 70e9 * height * std::pow(thickness, 3) / 12,
                 torsion = 70e9 / 2.6 * height * std::pow(thickness, 3) / 3 *
      (1 - 0.63 * thickness / height);
    SceneText scene;
    scene.dimension(3).frame("0 0 0; 1 0 0", "0 1");
    scene.rectangle("strip", thickness, height, {70e9, 2700, 0.3});
    scene.support("clamp", "0", "clamp");
    return statics(scene.mesh(3, 3))
      .load("push",
            "1",
            {"0",
             "0",
             text(-4.013 * std::sqrt(bending * torsion)) + " * " +
               raised(part)})
      .time(0.2, 0.0002, "static");
  };
  const auto column = [&](const double part) {
    SceneText scene;
    scene.frame("0 0; 1 0; 0 1; 1 1", "0 1; 2 3");
    scene.circle("rod", 0.005, {70e9, 2700, 0.3});
    scene.support("clamp", "0, 2", "clamp");
    scene.load("press",
               "1",
               {text(-critical) + " * " + raised(part), "0", "0"});
    return scene.load("bend", "3", {"0", "0.1", "0"})
      .mesh(3, 1)
      .time(0.2, 0.0002, "static");
  };
  // A strut whose compression stays below that of a neighbour: both ends
  // clamped, with a third of pi^2 EI / L^2.
  const auto beside = [&](const double part) {
    SceneText scene = column(part);
    scene.set("Lattice/Joints", "0 0; 1 0; 0 1; 1 1; 0 -1; 1 -1")
      .set("Lattice/Struts", "0 1; 2 3; 4 5")
      .set("Supports/clamp/Joints", "0, 2, 4");
    scene.support("guide", "5", "prescribed")
      .set("Supports/guide/Displacement y", "0")
      .set("Supports/guide/Rotation z", "0");
    return scene.load("hold", "5", {text(-4 * critical / 3), "0", "0"});
  };
  // Low compression suffices: a row of twelve struts buckles at 0.003 pi^2 EI
  // / L^2 each.
  const auto row = [&](const double part) {
    std::string joints = "0 0", struts;
    for (unsigned int i = 1; i <= 12; ++i)
      {
        joints += "; " + text(i / 12.) + " 0";
        struts +=
          (i > 1 ? "; " : "") + std::to_string(i - 1) + ' ' + std::to_string(i);
      }
    SceneText scene = column(part);
    return scene.set("Lattice/Joints", joints + "; 0 1; 1 1")
      .set("Lattice/Struts", struts + "; 13 14")
      .set("Supports/clamp/Joints", "0, 13")
      .set("Loads/press/Joints", "12")
      .set("Loads/bend/Joints", "14");
  };
  for (const double part : {0.3, 1.2})
    {
      SCOPED_TRACE(part);
      for (const SceneText &scene :
           {strip(part), column(part), beside(part), row(part)})
        {
          const DecidedRun chosen(scene, "auto");
          EXPECT_EQ(chosen.history.is_exact, part > 1) << chosen.history.reason;
        }
    }
  expect_same_when_resumed(beside(1.2).set("Effects/Large rotation", "auto"));
}

TEST(KinematicsChoice, ChecksStrains)
{
  SceneText scene;
  scene.frame("0 0; 1 0", "0 1").circle("rod", 0.02, {4e6, 1000, 0.3});
  scene.support("clamp", "0", "clamp");
  scene.set("Loads/pull/Joints", "1").set("Loads/pull/Force x", "4000 * t");
  const DecidedRun chosen(scene.mesh(1).time(1, 0.1, "static"), "auto");
  EXPECT_TRUE(chosen.history.is_exact) << chosen.history.reason;
  EXPECT_FALSE(chosen.result.findings.empty());
}

TEST(KinematicsChoice, WithoutLoadsTheWatchDecides)
{
  SceneText scene = cantilever(2, {0, 0});
  scene.set("Initial velocities/throw/Joints", "1")
    .set("Initial velocities/throw/Velocity y", "1e-4");
  const DecidedRun slow(scene, "auto");
  EXPECT_FALSE(slow.history.is_exact) << slow.history.reason;
  scene.set("Initial velocities/throw/Velocity y", "10");
  const DecidedRun fast(scene, "auto");
  EXPECT_TRUE(fast.history.is_exact);
  EXPECT_EQ(fast.history.n_beginnings, 2u);
}
