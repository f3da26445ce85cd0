#include <gtest/gtest.h>
#include <support/sampled_motion.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>
#include <support/pi.h>
#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Supports that move: kinks of their motion, tables, starts.

namespace
{
  /** Schemes that keep what they are given, and one that damps. */
  std::vector<Scheme> schemes()
  {
    return {newmark(),
            hht("-0.05"),
            generalized_alpha("0.8"),
            {"energy-momentum", "Scheme = energy-momentum"}};
  }

  /** The pivot of a standing bar (1 m, 1 kg), moved sideways. */
  SceneText moved_bar(const std::string &displacement, const std::string &time)
  {
    return SceneText()
      .frame("0 0; 0 1", "0 1")
      .rigid_part("bar", "all", 1)
      .add("Supports/pivot",
           "Joints = 0 | Type = prescribed | Displacement x = " + displacement +
             " | Displacement y = 0")
      .add("Time", time);
  }

  double angle(const SceneRun &run)
  {
    return std::atan2(run.motion(0, 0) - run.motion(1, 0),
                      1 + run.motion(1, 1));
  }

  double spin(const SceneRun &run)
  {
    const double dx = run.motion(1, 0) - run.motion(0, 0),
                 dy = 1 + run.motion(1, 1),
                 vx = run.velocity(1, 0) - run.velocity(0, 0),
                 vy = run.velocity(1, 1);
    return dx * vy - dy * vx;
  }

  /**
   * The same bar as a rigid body. With the angle phi from upright and the
   * pivot's velocity v, moment of momentum about the pivot's position (of a
   * centre that moves with v - phi' cos(phi) / 2 along x) gives
   *
   *     phi'' = 3/2 v' cos(phi),
   *
   * and where v jumps, phi' jumps by 3/2 of that times cos(phi).
   */
  struct Bar
  {
    double angle = 0, spin = 0;

    void strike(const double jump_of_velocity)
    {
      spin += 1.5 * jump_of_velocity * std::cos(angle);
    }

    /** From time @p t on for the time @p dt, by the rule of Runge and Kutta. */
    template <class Acceleration>
    void move(const double t, const double dt, const Acceleration &acceleration)
    {
      const unsigned int n = 20000;
      const double       h = dt / n;
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto rate = [&](const double part, const double angle) {
            return 1.5 * acceleration(t + (i + part) * h) * std::cos(angle);
          };
          const double k1 = rate(0, angle),
                       k2 = rate(0.5, angle + h / 2 * spin),
                       k3 = rate(0.5, angle + h / 2 * spin + h * h / 4 * k1),
                       k4 = rate(1, angle + h * spin + h * h / 2 * k2);
          angle += h * spin + h * h / 6 * (k1 + k2 + k3);
          spin += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
    }
  };

  /** From rest to 2 m/s in 0.2 s, and stopped dead at @p stop (s). */
  std::string drive_and_stop(const double stop)
  {
    const std::string at = text(stop);
    return "if(t < 0.2, 5 * t^2, if(t < " + at + ", 2 * t - 0.2, 2 * " + at +
      " - 0.2))";
  }

  double spin_after_stop(const double stop)
  {
    Bar bar;
    bar.move(0, 0.2, [](double) { return 10.; });
    bar.move(0.2, stop - 0.2, [](double) { return 0.; });
    bar.strike(-2);
    return bar.spin;
  }
} // namespace

TEST(PrescribedMotion, AStopIsTheImpulseOfTheRigidBody)
{
  EXPECT_NEAR(spin_after_stop(0.4), 1.0937, 5e-5);
  for (const Scheme &scheme : schemes())
    for (const double step : {1e-3, 0.3e-3})
      // On the grid of the steps or anywhere between.
      for (const double stop : {0.4, 0.40013, 0.40047, 0.40092})
        {
          SCOPED_TRACE(scheme.name + ", " + text(step) + ", " + text(stop));
          SceneRun run(
            moved_bar(drive_and_stop(stop), scheme.steps(step, 0.45)));
          run.run();
          // The tolerance is the error of second order before the stop.
          EXPECT_NEAR(spin(run), spin_after_stop(stop), 2e-4);
        }
}

TEST(PrescribedMotion, TheSpinAfterAStopIsOfSecondOrder)
{
  for (const Scheme &scheme : schemes())
    {
      SCOPED_TRACE(scheme.name);
      const auto error = [&scheme](const double step) {
        SceneRun run(
          moved_bar(drive_and_stop(0.4013), scheme.steps(step, 0.5)));
        run.run();
        return spin(run) - spin_after_stop(0.4013);
      };
      EXPECT_NEAR(std::log2(error(8e-3) / error(4e-3)), 2., 0.3);
    }
}

TEST(PrescribedMotion, AStruckBarHasTheEnergyOfTheImpulse)
{
  // 2 m/s from rest: phi' = 3 rad/s, the centre moves with 0.5 m/s; the
  // impulse of 0.5 N s does its work on the mean of 0 and 2 m/s.
  for (const Scheme &scheme : schemes())
    {
      SCOPED_TRACE(scheme.name);
      SceneRun run(moved_bar("2 * t", scheme.steps(1e-3, 0.3)));
      EXPECT_NEAR(spin(run), 3, 1e-13);
      EXPECT_NEAR(run.state.energies.kinetic(), 0.5, 1e-14);
      EXPECT_NEAR(run.state.energies.external(), 0.5, 1e-14);
      run.run();
      // It goes on turning evenly; second order of 3 rad/s.
      EXPECT_NEAR(angle(run), 0.9, 1e-6);
      EXPECT_NEAR(run.balance(), 0, 1e-5);
    }
}

TEST(PrescribedMotion, WorkOfAStopIsThatOfItsImpulse)
{
  for (const Scheme &scheme : schemes())
    {
      SCOPED_TRACE(scheme.name);
      SceneRun run(moved_bar("min(2 * t, 0.2)", scheme.steps(1e-3, 0.101)));
      double   kinetic = 0, work = 0;
      run.run([&] {
        if (run.state.step == 100)
          {
            kinetic = run.state.energies.kinetic();
            work    = run.state.energies.external();
          }
      });
      // After the stop nothing moves the support any more.
      EXPECT_NEAR(run.state.energies.external() - work,
                  run.state.energies.kinetic() - kinetic,
                  1e-7);
      Bar bar;
      bar.strike(2);
      bar.angle += 0.1 * bar.spin;
      bar.strike(-2);
      EXPECT_NEAR(spin(run), bar.spin, 1e-5);
      EXPECT_NEAR(run.state.energies.kinetic(), bar.spin * bar.spin / 6, 1e-5);
    }
}

TEST(PrescribedMotion, ALatticeThatAlreadyMovesWithItsSupportIsNotStruck)
{
  SceneRun run(
    moved_bar("2 * t", newmark().steps(1e-3, 0.1))
      .add("Initial velocities/all", "Joints = all | Velocity x = 2"));
  EXPECT_EQ(run.state.energies.external(), 0);
  run.run();
  EXPECT_NEAR(spin(run), 0, 1e-13);
  EXPECT_NEAR(run.state.energies.kinetic(), 2, 1e-12);
}

namespace
{
  /** To and fro by 0.2 m twice a second, from rest. */
  double shake(const double t)
  {
    return 0.1 * (1 - std::cos(4 * pi * t));
  }

  const std::string shake_text = "0.1 * (1 - cos(4 * pi * t))";

  /** Largest error of the angle, every 0.05 s, of a bar that is to be shaken
   * so. */
  double error_of_shaken_bar(const std::string &displacement, const double step)
  {
    SceneRun run(moved_bar(displacement, newmark().steps(step, 0.9)));
    Bar      exact;
    double   error = 0, time = 0;
    run.run([&] {
      if (run.state.time < time + 0.05 - step / 2)
        return;
      exact.move(time, 0.05, [](const double t) {
        return 1.6 * pi * pi * std::cos(4 * pi * t);
      });
      time += 0.05;
      error = std::max(error, std::abs(angle(run) - exact.angle));
    });
    return error;
  }

  /** Reactions along x at every step. */
  std::vector<double> reactions(const std::string &displacement,
                                const double       step)
  {
    SceneRun run(moved_bar(displacement, newmark().steps(step, 0.9)));
    std::vector<double> found = {run.reaction("pivot", 0)};
    run.run([&] { found.push_back(run.reaction("pivot", 0)); });
    return found;
  }
} // namespace

TEST(PrescribedMotion, ATableMovesAsTheFunctionItSamples)
{
  const SampledMotion table(shake, 1e-3, 1);
  const std::string   motion = "smooth table: " + table.name();
  const double        coarse = error_of_shaken_bar(motion, 10e-3),
               fine          = error_of_shaken_bar(motion, 5e-3);
  EXPECT_LT(coarse, 5e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

TEST(PrescribedMotion, ATableHasTheReactionsOfTheFunctionItSamples)
{
  // Rows that fall on steps, between them, and are farther apart.
  for (const double spacing : {1e-3, 0.7e-3, 10e-3})
    {
      SCOPED_TRACE(text(spacing));
      const SampledMotion table(shake, spacing, 1);
      const auto found    = reactions("smooth table: " + table.name(), 1e-3),
                 expected = reactions(shake_text, 1e-3);
      double error = 0, peak = 0;
      for (unsigned int i = 0; i < found.size(); ++i)
        {
          error = std::max(error, std::abs(found[i] - expected[i]));
          peak  = std::max(peak, std::abs(expected[i]));
        }
      // Second derivatives of the spline are off by the square of the spacing
      // times the fourth derivative of the motion, a twelfth of that between
      // rows and eleven twelfths at the ends.
      const double phase = 4 * pi * spacing;
      EXPECT_LT(error, phase * phase * peak);
    }
}

TEST(PrescribedMotion, EveryRowOfALinearTableStrikes)
{
  const double        spacing = 0.05;
  const SampledMotion table(shake, spacing, 0.45);
  for (const Scheme &scheme : schemes())
    {
      SCOPED_TRACE(scheme.name);
      Bar    bar;
      double velocity = 0;
      for (unsigned int i = 0; i < 9; ++i)
        {
          const double next =
            (shake((i + 1) * spacing) - shake(i * spacing)) / spacing;
          bar.strike(next - velocity);
          bar.angle += spacing * bar.spin;
          velocity = next;
        }
      bar.strike(-velocity);
      // Steps of the scene that are shorter and longer than the table's.
      for (const double step : {0.3e-3, 0.1})
        {
          SceneRun run(
            moved_bar("table: " + table.name(), scheme.steps(step, 0.5)));
          run.run();
          // Second order of the even turns between strikes, in the positions
          // that these find; the longer step is divided into 0.05 s.
          EXPECT_NEAR(spin(run), bar.spin, step < 1e-3 ? 1e-7 : 1e-3);
        }
    }
}

namespace
{
  /** A cantilever of steel whose clamp moves up. */
  SceneText moved_cantilever(const std::string &displacement,
                             const std::string &time)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("steel", "20 mm", "10 mm", {"210 GPa", 7800})
      .add("Supports/clamp",
           "Joints = 0 | Type = prescribed | Displacement x = 0 | "
           "Displacement y = " +
             displacement + " | Rotation z = 0")
      .add("Time", time);
  }
} // namespace

TEST(PrescribedMotion, AMotionMayBeginLate)
{
  // A jump of the acceleration, of its rate, of the velocity, at the end of a
  // step and inside of one.
  using Text                                                   = std::string;
  const std::vector<std::function<Text(const Text &)>> courses = {
    [](const Text &s) { return "0.002 * (1 - cos(100 * " + s + "))"; },
    [](const Text &s) { return "50 * " + s + "^3"; },
    [](const Text &s) { return "0.3 * " + s; }};
  for (const Scheme &scheme : schemes())
    for (const auto &course : courses)
      for (const std::string begin : {"0.01", "0.01003"})
        {
          SCOPED_TRACE(scheme.name + ", " + course("s") + ", " + begin);
          const std::string late  = course("max(0, t - " + begin + ")"),
                            early = course("t");
          SceneRun run(moved_cantilever(late, scheme.steps(1e-4, 0.03)));
          run.run();
          const double passed = 0.03 - std::stod(begin);
          SceneRun     from_start(
            moved_cantilever(early, scheme.steps(passed / 200, passed)));
          from_start.run();
          const double tip = from_start.motion(1, 1);
          EXPECT_GT(std::abs(tip), 1e-4);
          // Steps differ by part of one.
          EXPECT_NEAR(run.motion(1, 1), tip, 1e-3 * std::abs(tip));
          EXPECT_NEAR(run.balance(), 0, 0.02 * run.state.energies.external());
        }
}

TEST(PrescribedMotion, ASupportThatStartsWithASpeedStrikesAnElasticLattice)
{
  for (const Scheme &scheme : schemes())
    {
      SCOPED_TRACE(scheme.name);
      SceneRun     run(moved_cantilever("0.5 * t", scheme.steps(1e-5, 2e-3)));
      const double work = run.state.energies.external();
      EXPECT_GT(work, 0);
      EXPECT_NEAR(run.state.energies.kinetic(), work, 1e-13 * work);
      run.run();
      EXPECT_NEAR(run.balance(), 0, 0.03 * run.state.energies.external());
    }
}

namespace
{
  /** A rod (EA = 1 N, 1 kg/m, so waves run 1 m/s) of 64 elements, moved along
   * its axis. */
  SceneText moved_rod(const std::string &displacement, const std::string &time)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .given("rod", {1, 1, 1}, {1, 1})
      .add("Supports/end",
           "Joints = 0 | Type = prescribed | Displacement x = " + displacement +
             " | Displacement y = 0 | Rotation z = 0")
      .mesh(1, 6)
      .set("Effects/Large rotation", "off")
      .add("Time", time);
  }
} // namespace

TEST(PrescribedMotion, AStruckRodCarriesTheWaveOfDAlembert)
{
  // The front leaves the speed v and the strain v / c behind it: half of the
  // work rho A c v^2 t becomes motion. At the end of the run it is at the free
  // end.
  const double v = 0.01;
  SceneRun     run(moved_rod("0.01 * t", newmark().steps(0.004, 1)));
  run.run();
  const Energies &energies = run.state.energies;
  // The front is spread over some of the elements.
  EXPECT_NEAR(energies.external(), v * v, 0.01 * v * v);
  EXPECT_NEAR(energies.kinetic(), v * v / 2, 0.02 * v * v);
  EXPECT_NEAR(energies.strain(), v * v / 2, 0.02 * v * v);
  // Newmark 1/4, 1/2 keeps the balance of a linear scene to round-off, the
  // strike included.
  EXPECT_NEAR(run.balance(), 0, 1e-13 * v * v);
}

TEST(PrescribedMotion, ARodThatIsStoppedHasTheBalanceOfItsImpulses)
{
  const double v = 0.01;
  SceneRun run(moved_rod("0.01 * min(t, 0.7013)", newmark().steps(0.004, 1.5)));
  run.run();
  EXPECT_NEAR(run.balance(), 0, 1e-13 * v * v);
}

TEST(PrescribedMotion, ARotationInSpaceStrikesToo)
{
  // A clamp that starts to turn a slender strut about an oblique axis: what the
  // impulse does is the energy that the strut has.
  const SceneText text =
    SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0 0", "0 1")
      .circle("steel", "10 mm", {"210 GPa", 7800})
      .add("Supports/clamp",
           "Joints = 0 | Type = prescribed | Displacement x = 0 | "
           "Displacement y = 0 | Displacement z = 0.2 * t | "
           "Rotation x = 0.3 * t | Rotation y = -t | "
           "Rotation z = if(t < 1e-3, 2 * t, 2e-3)")
      .add("Time", newmark().steps(1e-5, 2e-3));
  SceneRun     run(text);
  const double work = run.state.energies.external();
  EXPECT_GT(work, 0);
  EXPECT_NEAR(run.state.energies.kinetic(), work, 1e-12 * work);
  run.run();
  EXPECT_NEAR(run.balance(), 0, 1e-3 * run.state.energies.external());
}

TEST(PrescribedMotion, AJumpIsRefusedUnlessTheStartIsAnEquilibriumWithIt)
{
  const std::string time = newmark().steps(0.01, 0.1),
                    from_equilibrium =
                      time + " | Start from = static equilibrium";
  const auto refusal = [](const std::string &displacement,
                          const std::string &time) {
    return input_error_of(
      [&] { SceneRun run(moved_cantilever(displacement, time)); });
  };
  expect_parts(refusal("-0.05", time),
               {"Supports/clamp/Displacement y",
                "-0.05",
                "t = 0",
                "Start from = static equilibrium"});
  expect_parts(refusal("if(t > 0, 0.05, 0)", from_equilibrium),
               {"Supports/clamp/Displacement y", "t = 0"});
  expect_parts(refusal("if(t < 0.03, 0, 0.05)", from_equilibrium),
               {"Supports/clamp/Displacement y",
                "jumps at t = 0.03 s",
                "0.05",
                "Scheme = static"});

  SceneRun run(moved_cantilever("-0.05", from_equilibrium));
  run.run();
  EXPECT_NEAR(run.motion(1, 1), -0.05, 1e-12);
  EXPECT_NEAR(run.state.energies.total(), 0, 1e-15);
}
