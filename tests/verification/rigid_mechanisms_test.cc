#include <auxfem/system/rigid_bodies.h>

#include <support/scene_run.h>
#include <verification/comparison_table.h>
#include <verification/frame_text.h>

#include <algorithm>
#include <array>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Mechanisms of rigid parts against closed forms: a compound pendulum, a free
// flight, the slider-crank and the four-bar linkage.

namespace
{
  constexpr double pi      = 3.14159265358979323846;
  constexpr double gravity = 9.81;

  std::string frame(const std::string &joints, const std::string &struts)
  {
    return "subsection Lattice\n set Cell = frame\n set Joints = " + joints +
      "\n set Struts = " + struts + "\nend\n";
  }

  /** A rigid part of struts, with its mass in kg. */
  std::string
  part(const std::string &name, const std::string &struts, const double mass)
  {
    return "subsection Rigid parts\n subsection " + name +
      "\n  set Struts = " + struts + "\n  set Mass = " + text(mass) +
      "\n end\nend\n";
  }

  std::string pin(const std::string &joints)
  {
    return "subsection Supports\n subsection pivot\n  set Joints = " + joints +
      "\n  set Type = pin\n end\nend\n";
  }

  std::string time(const double dt, const double end)
  {
    return "subsection Time\n set Time step = " + text(dt) +
      "\n set End time = " + text(end) + "\nend\n";
  }

  /** A bar of 1 m and 1 kg, hinged at the origin, released along x. */
  std::string pendulum(const double dt, const double end)
  {
    return frame("0 0; 1 0", "0 1") + part("bar", "all", 1) + pin("0") +
      "subsection Gravity\n set Acceleration y = " + text(-gravity) +
      "\nend\n" + time(dt, end);
  }

  /** Time (s) until the bar first hangs down. */
  double quarter_period(const double dt, const double end)
  {
    SceneRun run(pendulum(dt, end));
    double   before = pi / 2, crossing = 0;
    run.run([&] {
      const double now =
        pi / 2 + run.system.rigid_parts()->rotation(0, run.state);
      // The angle is nearly linear where it crosses zero.
      if (before > 0 && now <= 0)
        crossing = run.state.time - dt + dt * before / (before - now);
      before = now;
    });
    return crossing;
  }

  /**
   * Largest differences over a run of the hinge's force, along and across the
   * bar, from what energy and moment of momentum give at the present angle.
   */
  std::array<double, 2> hinge_force_error(const double dt, const double end)
  {
    SceneRun              run(pendulum(dt, end));
    std::array<double, 2> error = {{0, 0}};
    run.run([&] {
      const auto  &parts = *run.system.rigid_parts();
      const double down  = -parts.rotation(0, run.state);
      const auto   force = parts.report(0, run.state).forces[0];
      // Along the bar: m g sin + m w^2 L / 2, w^2 = 3 g sin / L; across it
      // m g cos - m L / 2 of the angular acceleration 3 g cos / (2 L).
      const double along =
                     -std::cos(down) * force[0] + std::sin(down) * force[1],
                   across =
                     std::sin(down) * force[0] + std::cos(down) * force[1];
      error[0] =
        std::max(error[0], std::abs(along - 2.5 * gravity * std::sin(down)));
      error[1] =
        std::max(error[1], std::abs(across - 0.25 * gravity * std::cos(down)));
      EXPECT_NEAR(run.reaction("pivot", 0), force[0], 1e-9);
      EXPECT_NEAR(run.reaction("pivot", 1), force[1], 1e-9);
    });
    return error;
  }

  /** Momentum x, y (N s), moment of momentum about the origin (N m s). */
  std::array<double, 3> momenta(const SceneRun &run)
  {
    const RigidBody body =
      rigid_bodies(run.lattice, run.system.numbering()).at(0);
    const RigidPart      &part = run.lattice.rigid_parts.at(0);
    std::array<double, 4> p    = {};
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        p[i] += body.mass[4 * i + j] * (*run.state.velocity)[body.base[j]];
    double moment = 0;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const dealii::Point<3> &r = run.lattice.joints[part.joints[k]];
        const double            x = r[0] + run.motion(part.joints[k], 0),
                     y            = r[1] + run.motion(part.joints[k], 1);
        moment += x * p[2 * k + 1] - y * p[2 * k];
      }
    return {{p[0] + p[2], p[1] + p[3], moment}};
  }
} // namespace

TEST(RigidMechanisms, PeriodOfTheCompoundPendulum)
{
  // T = 4 sqrt(l / g) K(sin 45 deg), l = 2 L / 3.
  const double small_period = 2 * pi * std::sqrt(2. / 3 / gravity),
               ratio        = 1.1803405990;
  const double          end = small_period * ratio / 4 + 0.02;
  std::array<double, 3> found;
  for (unsigned int i = 0; i < 3; ++i)
    found[i] = 4 * quarter_period(4e-3 / (1 << i), end) / small_period;
  ComparisonTable table("Period of a rigid bar released horizontally over that "
                        "of small swings");
  // The finest step: (w dt)^2 / 12 of up to 6.5 rad/s.
  table.relative("steps of 1 ms", found[2], ratio, 5e-6);
  table.relative("extrapolated from steps of 2 and 1 ms",
                 found[2] + (found[2] - found[1]) / 3,
                 ratio,
                 2e-8);
  table.row("order of convergence",
            std::log2((found[0] - found[1]) / (found[1] - found[2])),
            2,
            0.02);
}

TEST(RigidMechanisms, HingeForceOfTheCompoundPendulum)
{
  // Half a period: from one side to the other.
  const double end    = 0.9;
  const auto   coarse = hinge_force_error(2e-3, end),
             fine     = hinge_force_error(1e-3, end);
  ComparisonTable table("Hinge force of a rigid bar released horizontally: "
                        "m g (1 + 3/2) sin, m g / 4 cos");
  table.row(label("largest error (N) along the bar, dt", 1e-3),
            fine[0],
            0,
            1e-3);
  table.row("order of convergence along the bar",
            std::log2(coarse[0] / fine[0]),
            2,
            0.1);
  // At a given angle the force across the bar follows from its moment of
  // momentum alone, without the rate: only round-off, 1e-15 m / dt^2 = 1e-9
  // m/s2, which the motion increases.
  table.row(label("largest error (N) across the bar, dt", 1e-3),
            fine[1],
            0,
            1e-6);
}

namespace
{
  /** What a free flight changes at most, in parts of what there is. */
  struct FlightErrors
  {
    double rotation, length, momentum, moment_of_momentum, energy;
  };

  /**
   * An L of legs of 3 m and 1 m and 4 kg, thrown with a spin of 10 rad/s, at
   * steps of 4 ms for @p end (s).
   */
  FlightErrors free_flight(const double end, const std::string &scheme)
  {
    const double dt = 4e-3, rate = 10;
    // The velocity is that of the joints' mean place.
    SceneRun run(frame("0 0; 3 0; 3 1", "0 1; 1 2") + part("L", "all", 4) +
                   "subsection Initial velocities\n subsection throw\n"
                   "  set Joints = all\n  set Velocity x = 2\n"
                   "  set Velocity y = 7\n  set Angular velocity = " +
                   text(rate) + "\n end\nend\n" + time(dt, end),
                 {"Time/Scheme=" + scheme});
    const RigidPart &part = run.lattice.rigid_parts.at(0);
    // Velocities of the centre of mass.
    const double vx = 2 - rate * (part.centre_of_mass[1] - 1. / 3),
                 vy = 7 + rate * (part.centre_of_mass[0] - 2);
    const double energy =
      4 * (vx * vx + vy * vy) / 2 + part.rotary_inertia * rate * rate / 2;
    const std::array<double, 3> expected = {
      {4 * vx,
       4 * vy,
       4 * (part.centre_of_mass[0] * vy - part.centre_of_mass[1] * vx) +
         part.rotary_inertia * rate}};
    const double momentum = std::hypot(expected[0], expected[1]);

    FlightErrors errors = {0, 0, 0, 0, 0};
    double       turned = 0;
    const auto   note   = [](double &largest, const double error) {
      largest = std::max(largest, std::abs(error));
    };
    run.run([&] {
      const double now = run.system.rigid_parts()->rotation(0, run.state);
      turned           = now + 2 * pi * std::round((turned - now) / (2 * pi));
      // The trapezoidal rule turns a free body evenly.
      const double steps = run.state.step;
      note(errors.rotation,
           turned / (2 * steps * std::atan(rate * dt / 2)) - 1);
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < a; ++b)
          {
            const auto &ra = run.lattice.joints[a], &rb = run.lattice.joints[b];
            const double x =
                           ra[0] + run.motion(a, 0) - rb[0] - run.motion(b, 0),
                         y =
                           ra[1] + run.motion(a, 1) - rb[1] - run.motion(b, 1);
            note(errors.length, (std::hypot(x, y) - ra.distance(rb)) / 3);
          }
      const auto found = momenta(run);
      note(errors.momentum, (found[0] - expected[0]) / momentum);
      note(errors.momentum, (found[1] - expected[1]) / momentum);
      note(errors.moment_of_momentum, found[2] / expected[2] - 1);
      note(errors.energy, run.state.energies.total() / energy - 1);
    });
    EXPECT_GT(turned, 0.99 * rate * end);
    return errors;
  }
} // namespace

TEST(RigidMechanisms, FreeFlightIsExactForARevolution)
{
  const FlightErrors errors = free_flight(0.64, "newmark");
  ComparisonTable    table("Rigid L thrown with spin, one revolution by the "
                           "trapezoidal rule, relative errors");
  // Without numerical damping round-off in multipliers grows as exp of the
  // angle turned, 600 here.
  table.row("rotation, of 2 atan(w dt / 2) a step", errors.rotation, 0, 1e-11);
  table.row("distances", errors.length, 0, 1e-13);
  table.row("momentum", errors.momentum, 0, 1e-12);
  table.row("moment of momentum", errors.moment_of_momentum, 0, 1e-10);
  table.row("energy", errors.energy, 0, 1e-10);
}

TEST(RigidMechanisms, FreeFlightOfTenRevolutions)
{
  const FlightErrors errors = free_flight(6.4, "generalized-alpha");
  ComparisonTable    table("Rigid L thrown with spin, ten revolutions with "
                           "numerical damping, relative errors");
  // Errors of second order, (w dt)^2 = 1.6e-3, most of them in the first steps.
  table.row("rotation, of 2 atan(w dt / 2) a step", errors.rotation, 0, 2e-5);
  table.row("distances", errors.length, 0, 1e-13);
  table.row("momentum", errors.momentum, 0, 1e-12);
  table.row("moment of momentum", errors.moment_of_momentum, 0, 2e-5);
  table.row("energy", errors.energy, 0, 3e-5);
}

namespace
{
  /** A course of angles from rest, at rate 1 (rad/s) from @p first (rad) on. */
  struct Drive
  {
    /** The ramp covers this angle (rad) in twice the time (s). */
    static constexpr double ramp = pi / 18;

    explicit Drive(const double first) : start(first - ramp)
    {}

    /** start + the integral of 3 s^2 - 2 s^3, s = t / (2 ramp). */
    std::string expression() const
    {
      const std::string T = text(2 * ramp);
      return "(" + text(start) + " + if(t < " + T + ", " + T + " * ((t/" + T +
        ")^3 - (t/" + T + ")^4 / 2), t - " + text(ramp) + "))";
    }

    const double start;
  };

  std::string place(const double x, const double y)
  {
    return text(x) + " " + text(y);
  }

  /** Prescribes x of joint 1, at @p radius from the crank's pivot. */
  std::string crank_drive(const Drive &drive, const double radius)
  {
    return "subsection Supports\n subsection drive\n  set Joints = 1\n"
           "  set Type = prescribed\n  set Displacement x = " +
      text(radius) + " * (cos(" + drive.expression() + ") - " +
      text(std::cos(drive.start)) + ")\n end\nend\n";
  }

  // Numerical damping settles the multipliers: their rows have no dynamics of
  // their own, and Newmark's rule would let the start of the drive ring on.
  std::string damped_time(const double dt, const double end)
  {
    return time(dt, end) +
      "subsection Time\n set Scheme = generalized-alpha\n"
      " set Spectral radius = 0.5\nend\n";
  }

  struct SliderState
  {
    double x, rate, acceleration;
  };

  /**
   * Slider-crank, crank 0.15 m with a lever of 0.1 m on it, rod 0.3 m with a
   * coupler point off its line, at 30, 60, 90, 120 degrees, with n steps for
   * 10 degrees.
   */
  std::vector<SliderState> slider_crank(const unsigned int n)
  {
    const Drive  drive(pi / 9); // 10 degrees for what the ramp's end leaves
    const double p = drive.start, r = 0.15, l = 0.3;
    const double ax = r * std::cos(p), ay = r * std::sin(p),
                 bx = ax + std::sqrt(l * l - ay * ay);
    const double dt = pi / 18 / n;
    SceneRun run(frame("0 0; " + place(ax, ay) + "; " + place(bx, 0) + "; " +
                         place(-0.1 * std::sin(p), 0.1 * std::cos(p)) + "; " +
                         place((ax + bx) / 2, ay / 2 + 0.08),
                       "0 1; 0 3; 1 2; 1 4") +
                 part("crank", "0, 1", 0.5) + part("rod", "2, 3", 0.7) +
                 pin("0") + crank_drive(drive, r) +
                 "subsection Supports\n subsection guide\n  set Joints = 2\n"
                 "  set Type = roller x\n end\nend\n" +
                 "subsection Masses\n subsection slider\n  set Joints = 2\n"
                 "  set Mass = 0.3\n end\nend\n" +
                 damped_time(dt, 12 * n * dt));
    std::vector<SliderState> found;
    run.run([&] {
      const unsigned long step = run.state.step;
      if (step % (3 * n) != 0)
        return;
      const int unknown = run.system.numbering().joint_unknown(2, 0);
      found.push_back({bx + run.motion(2, 0),
                       run.velocity(2, 0),
                       (*run.state.acceleration)[unknown]});
      // The lever stays at a right angle to the crank.
      const double angle = pi / 6 * found.size();
      EXPECT_NEAR(run.motion(3, 0),
                  0.1 * (std::sin(p) - std::sin(angle)),
                  1e-9);
      EXPECT_NEAR(run.motion(3, 1),
                  0.1 * (std::cos(angle) - std::cos(p)),
                  1e-9);
    });
    return found;
  }
} // namespace

TEST(RigidMechanisms, SliderCrank)
{
  const std::vector<SliderState> expected = {
    {0.4203775615, -0.1085410197, -0.1725066274},
    {0.3454163457, -0.1659326452, -0.0381977754},
    {0.2598076211, -0.15, 0.0866025404},
    {0.1954163457, -0.0938749760, 0.1118022246}};
  const auto coarse = slider_crank(20), fine = slider_crank(40);
  ASSERT_EQ(coarse.size(), 4u);
  ASSERT_EQ(fine.size(), 4u);
  ComparisonTable table("Slider-crank driven at 1 rad/s: slider");
  for (unsigned int i = 0; i < 4; ++i)
    {
      const std::string at    = label(", deg", 30 * (i + 1));
      const auto       &exact = expected[i];
      // Positions follow from the conditions alone: ten digits are given.
      table.row("x" + at, fine[i].x, exact.x, 1e-9);
      // dt^2 = 2e-5 of the second and third derivatives.
      table.row("x'" + at, fine[i].rate, exact.rate, 1e-5);
      table.row("x''" + at, fine[i].acceleration, exact.acceleration, 1e-5);
      table.row("order of x'" + at,
                std::log2((coarse[i].rate - exact.rate) /
                          (fine[i].rate - exact.rate)),
                2,
                0.2);
    }
}

TEST(RigidMechanisms, AMasslessBarFollowsItsDashpot)
{
  // Hinged at the origin, its end at (0.6, 0.8), a dashpot of 20 N s/m along x
  // fixed in space, a force of 8 N/s t down. With the angle q from x, moments
  // about the hinge: 20 sin^2 q q' = -8 t cos q.
  const double dt = 1e-3, end = 0.5;
  SceneRun run(frame("0 0; 0.6 0.8", "0 1") + part("bar", "0", 0) + pin("0") +
               R"(
subsection Connectors
 subsection dashpot
  set Law = dashpot
  set Damping coefficient = 20
  set Between = ground: 1
  set Geometry = direction
  set Direction = 1 0
 end
end
subsection Loads
 subsection weight
  set Joints = 1
  set Force y = -8 * t
 end
end
)" + time(dt, end));
  run.run();
  // Fourth-order Runge-Kutta with 5e-4 s: 1e-13.
  double     q    = std::atan2(0.8, 0.6);
  const auto rate = [](const double t, const double angle) {
    return -8 * t * std::cos(angle) / (20 * std::sin(angle) * std::sin(angle));
  };
  const double h = 5e-4;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double t = i * h, k1 = rate(t, q),
                   k2 = rate(t + h / 2, q + h / 2 * k1),
                   k3 = rate(t + h / 2, q + h / 2 * k2),
                   k4 = rate(t + h, q + h * k3);
      q += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  ComparisonTable table(
    "Massless rigid bar on a dashpot, 8 N/s t down for 0.5 s");
  // dt^2 = 1e-6 of second derivatives below one.
  table.row("angle (rad)",
            std::atan2(0.8 + run.motion(1, 1), 0.6 + run.motion(1, 0)),
            q,
            1e-6);
}

namespace
{
  struct FourBarState
  {
    double coupler, rocker, coupler_ratio, rocker_ratio;
  };

  /**
   * Four-bar linkage, ground 1, crank 0.4, coupler 1.2, rocker 0.8 m, open or
   * crossed, when the driven crank is at 40 degrees.
   */
  FourBarState four_bar(const bool is_open, const unsigned int n)
  {
    const Drive  drive(pi / 6);
    const double p = drive.start, ax = 0.4 * std::cos(p),
                 ay = 0.4 * std::sin(p);
    // The joint of coupler and rocker: on circles about (ax, ay) and (1, 0).
    const double dx = 1 - ax, dy = -ay, distance = std::hypot(dx, dy),
                 along  = (1.44 - 0.64 + distance * distance) / (2 * distance),
                 across = (is_open ? 1 : -1) * std::sqrt(1.44 - along * along);
    const double bx     = ax + (along * dx - across * dy) / distance,
                 by     = ay + (along * dy + across * dx) / distance;
    const double dt     = pi / 18 / n;
    SceneRun run(frame("0 0; " + place(ax, ay) + "; " + place(bx, by) + "; 1 0",
                       "0 1; 1 2; 2 3") +
                 "subsection Rigid parts\n subsection bars\n"
                 "  set Struts = all\n  set Parts = single struts\n"
                 "  set Mass = 1\n end\nend\n" +
                 pin("0, 3") + crank_drive(drive, 0.4) +
                 damped_time(dt, 3 * n * dt));
    run.run();

    const auto angle_and_rate = [&](const unsigned int from,
                                    const unsigned int to) {
      const auto  &r0 = run.lattice.joints[from], &r1 = run.lattice.joints[to];
      const double x  = r1[0] + run.motion(to, 0) - r0[0] - run.motion(from, 0),
                   y  = r1[1] + run.motion(to, 1) - r0[1] - run.motion(from, 1),
                   vx = run.velocity(to, 0) - run.velocity(from, 0),
                   vy = run.velocity(to, 1) - run.velocity(from, 1);
      return std::array<double, 2>{
        {std::atan2(y, x) * 180 / pi, (x * vy - y * vx) / (x * x + y * y)}};
    };
    const auto crank = angle_and_rate(0, 1), coupler = angle_and_rate(1, 2),
               rocker = angle_and_rate(3, 2);
    EXPECT_NEAR(crank[0], 40, 1e-9);
    // dt^2 = 2e-5, four times that with the coarser steps.
    EXPECT_NEAR(crank[1], 1, 1e-4);
    return {coupler[0], rocker[0], coupler[1], rocker[1]};
  }
} // namespace

TEST(RigidMechanisms, FourBarLinkage)
{
  const FourBarState expected[2] = {
    {-60.9779668, -98.00496408, -0.3703508920, -0.8151068783},
    {20.29788279, 57.32488007, -0.1648365766, 0.2799194097}};
  ComparisonTable table("Four-bar linkage, crank at 40 degrees and 1 rad/s");
  for (const bool is_open : {true, false})
    {
      const FourBarState &exact = expected[is_open];
      const FourBarState  fine  = four_bar(is_open, 40),
                         coarse = four_bar(is_open, 20);
      const std::string name    = is_open ? "open: " : "crossed: ";
      // Seven to eight decimals are given.
      table.row(name + "coupler (deg)", fine.coupler, exact.coupler, 6e-8);
      table.row(name + "rocker (deg)", fine.rocker, exact.rocker, 6e-8);
      // Twice dt^2 = 2e-5 of the third derivatives.
      // Twice dt^2 = 2e-5 of the third derivatives.
      table.row(name + "w3 / w2",
                fine.coupler_ratio,
                exact.coupler_ratio,
                4e-5);
      table.row(name + "w4 / w2", fine.rocker_ratio, exact.rocker_ratio, 4e-5);
      table.row(name + "order of w4",
                std::log2((coarse.rocker_ratio - exact.rocker_ratio) /
                          (fine.rocker_ratio - exact.rocker_ratio)),
                2,
                0.2);
    }
}
