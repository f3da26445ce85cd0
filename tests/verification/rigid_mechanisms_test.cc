#include <auxfem/model/rigid_bodies.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <array>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Motions of rigid parts against closed forms: a compound pendulum, a free
// flight, a massless bar.

namespace
{
  constexpr double standard_gravity = 9.81;

  /** A bar of 1 m and 1 kg, hinged at the origin, released along x. */
  SceneText pendulum(const double dt, const double end)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rigid_part("bar", "all", 1)
      .support("pivot", "0", "pin")
      .set("Gravity/Acceleration y", -standard_gravity)
      .time(end, dt);
  }

  /** Time (s) until the bar first hangs down. */
  double time_to_hang(const double dt, const double end)
  {
    SceneRun run(pendulum(dt, end));
    double   before = pi / 2, crossing = 0;
    run.run([&] {
      const double now = pi / 2 +
        run.equations.reporting().rigid_parts->rotation(0, run.state)[2];
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
      const auto  &parts = *run.equations.reporting().rigid_parts;
      const double down  = -parts.rotation(0, run.state)[2];
      const auto   force = parts.report(0, run.state).forces[0];
      // Along the bar: m g sin + m w^2 L / 2, w^2 = 3 g sin / L; across it
      // m g cos - m L / 2 of the angular acceleration 3 g cos / (2 L).
      const double along =
                     -std::cos(down) * force[0] + std::sin(down) * force[1],
                   across =
                     std::sin(down) * force[0] + std::cos(down) * force[1];
      error[0] =
        std::max(error[0],
                 std::abs(along - 2.5 * standard_gravity * std::sin(down)));
      error[1] =
        std::max(error[1],
                 std::abs(across - 0.25 * standard_gravity * std::cos(down)));
      EXPECT_NEAR(run.reaction("pivot", 0), force[0], 1e-9);
      EXPECT_NEAR(run.reaction("pivot", 1), force[1], 1e-9);
    });
    return error;
  }

  /** Momentum x, y (N s), moment of momentum about the origin (N m s). */
  std::array<double, 3> momenta(const SceneRun &run)
  {
    const NaturalBody<2> body =
      rigid_bodies(run.lattice, run.model.numbering).in_plane.at(0);
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
  const double small_period = 2 * pi * std::sqrt(2. / 3 / standard_gravity),
               ratio        = 1.1803405990;
  const double          end = small_period * ratio / 4 + 0.02;
  std::array<double, 3> found;
  for (unsigned int i = 0; i < 3; ++i)
    found[i] = 4 * time_to_hang(4e-3 / (1 << i), end) / small_period;
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
  /** Largest relative changes in a free flight. */
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
    // The velocity is that of the joints' mean position.
    SceneRun         run(SceneText()
                   .frame("0 0; 3 0; 3 1", "0 1; 1 2")
                   .rigid_part("L", "all", 4)
                   .add("Initial velocities/throw",
                        "Joints = all | Velocity x = 2 | Velocity y = 7 | "
                                "Angular velocity z = " +
                          text(rate))
                   .time(end, dt),
                 {"Time/Scheme=" + scheme});
    const RigidPart &part = run.lattice.rigid_parts.at(0);
    // Velocities of the centre of mass.
    const double vx = 2 - rate * (part.centre_of_mass[1] - 1. / 3),
                 vy = 7 + rate * (part.centre_of_mass[0] - 2);
    const double energy =
      4 * (vx * vx + vy * vy) / 2 + part.rotary_inertia[2][2] * rate * rate / 2;
    const std::array<double, 3> expected = {
      {4 * vx,
       4 * vy,
       4 * (part.centre_of_mass[0] * vy - part.centre_of_mass[1] * vx) +
         part.rotary_inertia[2][2] * rate}};
    const double momentum = std::hypot(expected[0], expected[1]);

    FlightErrors errors = {0, 0, 0, 0, 0};
    double       turned = 0;
    const auto   note   = [](double &largest, const double error) {
      largest = std::max(largest, std::abs(error));
    };
    run.run([&] {
      const double now =
        run.equations.reporting().rigid_parts->rotation(0, run.state)[2];
      turned = now + 2 * pi * std::round((turned - now) / (2 * pi));
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

TEST(RigidMechanisms, FreeFlightOfTenRevolutionsIsExact)
{
  const FlightErrors errors = free_flight(6.4, "newmark");
  ComparisonTable    table("Rigid L thrown with spin, ten revolutions by the "
                           "trapezoidal rule, relative errors");
  table.row("rotation, of 2 atan(w dt / 2) a step", errors.rotation, 0, 1e-11);
  table.row("distances", errors.length, 0, 1e-13);
  table.row("momentum", errors.momentum, 0, 1e-12);
  table.row("moment of momentum", errors.moment_of_momentum, 0, 1e-11);
  table.row("energy", errors.energy, 0, 1e-11);
}

TEST(RigidMechanisms, FreeFlightOfTenRevolutionsWithDamping)
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

TEST(RigidMechanisms, AMasslessBarFollowsItsDashpot)
{
  // Hinged at the origin, its end at (0.6, 0.8), a dashpot of 20 N s/m along x
  // fixed in space, a force of 8 N/s t down. With the angle q from x, moments
  // about the hinge: 20 sin^2 q q' = -8 t cos q.
  const double dt = 1e-3, end = 0.5;
  SceneRun     run(SceneText()
                 .frame("0 0; 0.6 0.8", "0 1")
                 .rigid_part("bar", "0", 0)
                 .support("pivot", "0", "pin")
                 .connector("dashpot",
                            "dashpot",
                            "Damping coefficient = 20 | "
                                "Between = ground: 1 | Geometry = direction | "
                                "Direction = 1 0")
                 .add("Loads/weight", "Joints = 1 | Force y = -8 * t")
                 .time(end, dt));
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
