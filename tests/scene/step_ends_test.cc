#include <auxfem/scene/step_ends.h>

#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <verification/one_mass_scene.h>

#include <cmath>
#include <fstream>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string spring = "Law = spring | Spring stiffness = 4";

  /** A mass of 1 kg on a spring of 4 N/m, from rest, pushed by @p force. */
  std::string pushed_mass(const std::string &force, const std::string &time)
  {
    return one_mass_scene(
      spring,
      time,
      mass_and_velocity(1, 0).add("Loads/push",
                                  "Joints = 0 | Force x = " + force));
  }

  using Jump = StepEnd::Jump;

  std::vector<StepEnd> ends_of(const std::string &force)
  {
    return step_ends(
      read_scene_from_text(pushed_mass(force, "End time = 1 | Time step = 0.1"),
                           "test.prm"));
  }

  /** Error of the displacement at t = 2 after a force of 3 N from 0.537 s on.
   */
  double error_after_jump(const std::string &scheme, const unsigned int n_steps)
  {
    const double jump = 0.537, end = 2, omega = 2;
    SceneRun     run(pushed_mass("if(t < 0.537, 0, 3)",
                             "Scheme = " + scheme +
                               " | End time = 2 | Time step = " +
                               std::to_string(end / n_steps)));
    run.run();
    const double exact = 3. / 4 * (1 - std::cos(omega * (end - jump)));
    return std::abs(run.motion(0, 0) - exact);
  }
} // namespace

TEST(StepEnds, AreKinksAndJumpsOfLoadsInsideTheRun)
{
  const std::vector<StepEnd> ends =
    ends_of("min(t / 0.25, 1) + if(t < 0.6, 0, 2) + max(0, t - 3)");
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0].time, 0.25, 1e-12);
  EXPECT_EQ(ends[0].jump, Jump::none);
  EXPECT_NEAR(ends[1].time, 0.6, 1e-12);
  EXPECT_EQ(ends[1].jump, Jump::accelerations);
  EXPECT_TRUE(ends_of("sin(3 * t)").empty());
}

TEST(StepEnds, KinksWithinAStepOfEachOtherAreSampledJumpsAreNot)
{
  // Kinks every 0.05 s, half a step; a jump between two of them.
  const std::vector<StepEnd> ends =
    ends_of("abs(sin(pi * t / 0.05)) + if(t < 0.52, 0, 1)");
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_NEAR(ends[0].time, 0.52, 1e-12);
}

TEST(StepEnds, IncludeAllBendsOfMotions)
{
  const auto ends_of_motion = [](const std::string &scheme) {
    return step_ends(read_scene_from_text(
      one_mass_scene(
        spring,
        "Scheme = " + scheme + " | End time = 1 | Time step = 0.1",
        mass_and_velocity(1, 0).add("Supports/shaker",
                                    "Joints = 0 | Type = prescribed | "
                                    "Displacement x = max(0, t - 0.23)^2 + "
                                    "max(0, t - 0.52) + max(0, t - 0.53)")),
      "test.prm"));
  };
  const std::vector<StepEnd> ends = ends_of_motion("newmark");
  ASSERT_EQ(ends.size(), 3u);
  EXPECT_NEAR(ends[0].time, 0.23, 1e-12);
  EXPECT_EQ(ends[0].jump, Jump::accelerations);
  EXPECT_NEAR(ends[1].time, 0.52, 1e-12);
  EXPECT_EQ(ends[1].jump, Jump::velocities);
  EXPECT_NEAR(ends[2].time, 0.53, 1e-12);
  EXPECT_EQ(ends[2].jump, Jump::velocities);
}

TEST(StepEnds, TimesThatTheUserGivesAreAmongThem)
{
  const auto ends_with_events = [](const std::string &events) {
    return step_ends(read_scene_from_text(
      pushed_mass("sqrt((t - 0.43)^2) + if(t < 0.6, 0, 2)",
                  "End time = 1 | Time step = 0.1 | Events = " + events),
      "test.prm"));
  };
  const std::vector<StepEnd> ends = ends_with_events("430 ms, 0.9");
  ASSERT_EQ(ends.size(), 3u);
  EXPECT_DOUBLE_EQ(ends[0].time, 0.43);
  EXPECT_EQ(ends[0].jump, Jump::accelerations);
  EXPECT_NEAR(ends[1].time, 0.6, 1e-12);
  EXPECT_DOUBLE_EQ(ends[2].time, 0.9);
  EXPECT_EQ(ends_with_events("0.43 0.6").size(), 2u);
  for (const std::string outside : {"-0.1", "0.5, 1.01"})
    EXPECT_NE(input_error_of([&] {
                ends_with_events(outside);
              }).find("Time/Events"),
              std::string::npos);
}

TEST(StepEnds, UserEventsAreAsAccurateAsDetectedKinks)
{
  const auto motion = [](const std::string &force, const std::string &events) {
    SceneRun run(pushed_mass(force, "End time = 1 | Time step = 0.1" + events));
    run.run();
    return run.motion(0, 0);
  };
  EXPECT_NEAR(motion("sqrt((t - 0.537)^2)", " | Events = 0.537"),
              motion("abs(t - 0.537)", ""),
              1e-13);
}

TEST(StepEnds, DivideStepsNowhereElse)
{
  SceneRun run(
    pushed_mass("max(0, t - 0.23)", "End time = 1 | Time step = 0.1"));
  for (unsigned int step = 1; step <= 10; ++step)
    {
      const StepReport report = run.advance();
      EXPECT_EQ(report.substeps, step == 3 ? 2u : 1u);
      EXPECT_NEAR(report.dt, step == 3 ? 0.03 : 0.1, 1e-14);
      EXPECT_DOUBLE_EQ(run.state.time, step == 10 ? 1. : step * 0.1);
    }
}

TEST(StepEnds, AKinkOnTheGridDividesNothing)
{
  SceneRun run(
    pushed_mass("min(t / 0.3, 1)", "End time = 1 | Time step = 0.1"));
  for (unsigned int step = 1; step <= 10; ++step)
    EXPECT_EQ(run.advance().substeps, 1u);
}

TEST(StepEnds, AForceThatIsSwitchedOnLeavesTheOrderTwo)
{
  for (const char *scheme : {"newmark", "hht", "generalized-alpha"})
    {
      SCOPED_TRACE(scheme);
      const double coarse = error_after_jump(scheme, 40),
                   fine   = error_after_jump(scheme, 160);
      EXPECT_LT(coarse, 0.02);
      // A jump inside a step, or rates from before it, would leave order one.
      EXPECT_NEAR(std::log2(coarse / fine) / 2, 2., 0.2);
    }
}

TEST(StepEnds, WorkOfAForceThatIsSwitchedOnIsExact)
{
  // Newmark 1/4, 1/2 keeps the balance of a linear scene to round-off.
  SceneRun run(
    pushed_mass("if(t < 0.537, 0, 3)", "End time = 2 | Time step = 0.1"));
  run.run();
  EXPECT_GT(run.state.energies.external(), 1.);
  EXPECT_NEAR(run.balance(), 0., 1e-12);
}

TEST(StepEnds, AForceSwitchedOnJustAfterTheStartActsFromTheStart)
{
  SceneRun after(
    pushed_mass("if(t > 0, 3, 0)", "End time = 1 | Time step = 0.01"));
  SceneRun always(pushed_mass("3", "End time = 1 | Time step = 0.01"));
  after.run();
  always.run();
  EXPECT_DOUBLE_EQ(after.motion(0, 0), always.motion(0, 0));
  EXPECT_DOUBLE_EQ(after.balance(), always.balance());
}

TEST(StepEnds, APulseShorterThanAStepHasItsImpulse)
{
  // A triangle of 2 ms and 500 N is 0.5 N s: the mass of 1 kg moves on with
  // 0.5 m/s, up to the effect of the spring.
  SceneRun run(pushed_mass("500 * max(0, 1 - abs(t - 0.5137) / 0.001)",
                           "End time = 0.52 | Time step = 0.01"));
  run.run();
  EXPECT_NEAR(run.velocity(0, 0), 0.5, 1e-4);
}

namespace
{
  /** Velocity of the mass at t = 0.5 s in a run that ends at @p end_time. */
  double velocity_at_half(const std::string &force,
                          const std::string &scheme,
                          const std::string &end_time)
  {
    SceneRun run(pushed_mass(force,
                             "Scheme = " + scheme + " | Time step = 0.1 | " +
                               "End time = " + end_time));
    for (unsigned int i = 0; i < 5; ++i)
      run.advance();
    return run.velocity(0, 0);
  }
} // namespace

TEST(StepEnds, TheLastStepTakesALoadBeforeItsJumpAtTheEnd)
{
  const std::string table = testing::TempDir() + "jump_at_end.txt";
  std::ofstream(table) << "0 3\n0.5 3\n0.5 0\n2 0\n";
  for (const std::string force : {"if(t < 0.5, 3, 0)", "table: "})
    for (const char *scheme :
         {"newmark", "generalized-alpha", "energy-momentum", "esdirk"})
      {
        SCOPED_TRACE(force + scheme);
        const std::string text = force == "table: " ? force + table : force;
        const double      last = velocity_at_half(text, scheme, "0.5");
        EXPECT_EQ(last, velocity_at_half(text, scheme, "1"));
        // 3 N on a mass of 1 kg and a spring of 4 N/m.
        EXPECT_NEAR(last, 1.5 * std::sin(2 * 0.5), 0.02);
      }
}

TEST(StepEnds, TheLastStaticStepTakesValuesBeforeTheirJumpAtTheEnd)
{
  for (const std::string &load :
       {std::string("Loads/pull"), std::string("Supports/tip")})
    {
      const bool is_load = load == "Loads/pull";
      SceneRun   run(
        SceneText()
          .frame("0 0; 1 0", "0 1")
          .circle("s", 0.01, {1e9, 1000})
          .add("Supports/foot", "Joints = 0")
          .add(load,
               is_load ? "Joints = 1 | Force x = if(t < 1, 4, 0)"
                         : "Joints = 1 | Type = prescribed | "
                           "Displacement x = if(t < 1, 1e-4, 0)")
          .add("Effects", "Large rotation = off")
          .add("Time", "Scheme = static | End time = 1 | Time step = 0.5"));
      run.run();
      constexpr double pi = 3.14159265358979;
      EXPECT_NEAR(run.motion(1, 0),
                  is_load ? 4 / (1e9 * pi * 1e-4) : 1e-4,
                  1e-12);
    }
}
