#include <auxfem/rigid/effects/rigid_part_group.h>

#include <support/run_program.h>
#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_frame.h>
#include <verification/space_text.h>

#include <algorithm>
#include <array>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Mechanisms of rigid parts and hinges in space against closed forms.

namespace
{
  constexpr double door_gravity = 9.81;

  SceneText revolute(const std::string &joints, const SpaceVector &axis)
  {
    return SceneText().add("Joints/hinge",
                           "Joints = " + joints +
                             " | Type = revolute | Axis = " + text(axis));
  }

  const SceneText weight =
    SceneText().set("Gravity/Acceleration z", -door_gravity);

  /** The hinge's axis, 30 degrees off the vertical. */
  const SpaceVector axis = vector(0.5, 0, std::sqrt(0.75));

  /**
   * A door of 1 m x 1 m, 4 kg along its edges, on a revolute hinge at its
   * corner, released a quarter of a turn from where it would rest.
   */
  SceneText door(const double dt, const double end)
  {
    return SceneText()
      .dimension(3)
      .frame("0 0 0; " + text(axis) + "; " + text(axis + vector(0, 1, 0)) +
               "; 0 1 0",
             "0 1; 1 2; 2 3; 3 0")
      .rigid_part("door", "all", 4)
      .support("pivot", "0", "pin")
      .add(revolute("0", axis))
      .add(weight)
      .time(end, dt);
  }

  /** Time (s) until the door first hangs lowest. */
  double time_to_swing(const double dt, const double end)
  {
    SceneRun run(door(dt, end));
    double   before = 0, crossing = 0, across = 0;
    run.run([&] {
      const SpaceVector turn =
        run.equations.reporting().rigid_parts->rotation(0, run.state);
      const double now = std::abs(turn * axis);
      across = std::max(across, dealii::cross_product_3d(turn, axis).norm());
      if (before < pi / 2 && now >= pi / 2)
        crossing =
          run.state.time - dt + dt * (pi / 2 - before) / (now - before);
      before = now;
    });
    EXPECT_LT(across, 1e-13);
    return crossing;
  }
} // namespace

TEST(SpaceMechanisms, PeriodOfADoorOnASkewHinge)
{
  // About the axis: three edges of 1 kg, the outer one at 1 m, two from 0 to 1
  // m. Their centre is at 1/2 m; the axis leaves sin 30 deg of the weight.
  const double inertia = 1 + 2. / 3, arm = 0.5, mass = 4;
  const double small_period =
                 2 * pi * std::sqrt(inertia / (mass * door_gravity / 2 * arm)),
               ratio        = 1.1803405990;
  const double          end = small_period * ratio / 4 + 0.03;
  std::array<double, 3> found;
  for (unsigned int i = 0; i < 3; ++i)
    found[i] = 4 * time_to_swing(8e-3 / (1 << i), end) / small_period;
  ComparisonTable table("Period of a door on an axis 30 degrees off the "
                        "vertical, released from 90 degrees, over that of "
                        "small swings");
  // (w dt)^2 / 12 of up to 3.5 rad/s.
  table.relative("steps of 2 ms", found[2], ratio, 5e-6);
  table.relative("extrapolated from steps of 4 and 2 ms",
                 found[2] + (found[2] - found[1]) / 3,
                 ratio,
                 2e-8);
  table.row("order of convergence",
            std::log2((found[0] - found[1]) / (found[1] - found[2])),
            2,
            0.02);
}

namespace
{
  /** A bar of 1 m and 1 kg, hinged at the origin, thrown across. */
  SceneText spherical_pendulum(const double dt, const double end)
  {
    // From 60 degrees, at 2 rad/s about the vertical.
    const double sine = std::sin(pi / 3), cosine = std::cos(pi / 3);
    return SceneText()
      .dimension(3)
      .frame("0 0 0; " + text(vector(sine, 0, -cosine)), "0 1")
      .rigid_part("bar", "all", 1)
      .support("pivot", "0", "pin")
      .add(weight)
      .add(initial_motion(vector(0, sine, 0), vector(0, 0, 2)))
      .time(end, dt);
  }

  /**
   * Position of the bar's end after @p end (s) from its two equations by
   * Runge-Kutta's fourth order: angle q off the downward vertical, q'' = sin
   * cos p'^2 - 3 g sin / (2 L), sin^2 p' constant.
   */
  SpaceVector end_of_pendulum(const double end)
  {
    const double spin = 2 * std::pow(std::sin(pi / 3), 2);
    using State       = std::array<double, 3>; // q, q', p
    const auto rate   = [spin](const State &s) -> State {
      const double sine = std::sin(s[0]), turning = spin / (sine * sine);
      return {
        {s[1],
         sine * std::cos(s[0]) * turning * turning - 1.5 * door_gravity * sine,
         turning}};
    };
    const auto moved = [](const State &s, const State &k, const double h) {
      return State{{s[0] + h * k[0], s[1] + h * k[1], s[2] + h * k[2]}};
    };
    const unsigned int n = 20000;
    const double       h = end / n;
    State              s = {{pi / 3, 0, 0}};
    for (unsigned int i = 0; i < n; ++i)
      {
        const State k1 = rate(s), k2 = rate(moved(s, k1, h / 2)),
                    k3 = rate(moved(s, k2, h / 2)), k4 = rate(moved(s, k3, h));
        for (unsigned int c = 0; c < 3; ++c)
          s[c] += h / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
      }
    return vector(std::sin(s[0]) * std::cos(s[2]),
                  std::sin(s[0]) * std::sin(s[2]),
                  -std::cos(s[0]));
  }
} // namespace

TEST(SpaceMechanisms, ABarIsASphericalPendulum)
{
  const double          end      = 2;
  const SpaceVector     expected = end_of_pendulum(end);
  ComparisonTable       table("Rigid bar as a spherical pendulum after 2 s");
  std::array<double, 2> errors;
  for (unsigned int i = 0; i < 2; ++i)
    {
      const double dt = 4e-3 / (1 << i);
      SceneRun     run(spherical_pendulum(dt, end));
      double       moment = 0, length = 0;
      run.run([&] {
        SpaceVector r, v;
        for (unsigned int c = 0; c < 3; ++c)
          {
            r[c] = run.lattice.joints[1][c] + run.motion(1, c);
            v[c] = run.velocity(1, c);
          }
        // r x v is three times the moment of momentum about the vertical.
        moment = std::max(moment,
                          std::abs(r[0] * v[1] - r[1] * v[0] -
                                   2 * std::pow(std::sin(pi / 3), 2)));
        length = std::max(length, std::abs(r.norm() - 1));
      });
      SpaceVector error = run.lattice.joints[1] - expected;
      for (unsigned int c = 0; c < 3; ++c)
        error[c] += run.motion(1, c);
      errors[i] = error.norm();
      table.row(label("error of the end (m), dt", dt),
                errors[i],
                0,
                18 * dt * dt);
      table.row(label("length (m), dt", dt), length, 0, 5e-14);
      table.row(label("moment of momentum, dt", dt), moment, 0, 6 * dt * dt);
      // Energy that the motion has gained, accounted for by the scheme or not.
      table.row(label("energy gained (J), dt", dt),
                run.balance() - run.state.energies.numerical(),
                0,
                5 * dt * dt);
    }
  table.row("order of convergence", std::log2(errors[0] / errors[1]), 2, 0.05);
}

namespace
{
  /**
   * A crank of 0.3 m that turns about z at the origin, a coupler with two
   * spherical hinges, and a rocker of 0.8 m on a revolute hinge.
   */
  struct Linkage
  {
    const SpaceVector pivot = vector(0.9, 0.3, 0.2),
                      hinge = vector(0.2, 1, 0.4) / std::sqrt(1.2),
                      crank = vector(0.3, 0, 0),
                      // Across the hinge.
      rocker = 0.8 / std::sqrt(1.16) * vector(0, -0.4, 1);

    SpaceVector end_of_crank(const double angle) const
    {
      return rotated(exponential(vector(0, 0, angle)), crank);
    }
    SpaceVector end_of_rocker(const double angle) const
    {
      return pivot + rotated(exponential(angle * hinge), rocker);
    }
    double coupler(const double crank_angle, const double rocker_angle) const
    {
      return (end_of_rocker(rocker_angle) - end_of_crank(crank_angle)).norm();
    }

    /** The rocker's angle next to @p guess, by Newton's method. */
    double rocker_angle(const double crank_angle, double guess) const
    {
      const double length = coupler(0, 0), h = 1e-6;
      for (unsigned int i = 0; i < 20; ++i)
        guess -= (coupler(crank_angle, guess) - length) * 2 * h /
          (coupler(crank_angle, guess + h) - coupler(crank_angle, guess - h));
      return guess;
    }

    SceneText scene() const
    {
      return SceneText()
        .dimension(3)
        .frame("0 0 0; " + text(crank) + "; " + text(pivot + rocker) + "; " +
                 text(pivot),
               "0 1; 1 2; 2 3")
        .rigid_part("crank", "0", 1)
        .set("Rigid parts/crank/Elastic struts", "clamped")
        .rigid_part("coupler", "1", 2)
        .rigid_part("rocker", "2", 3)
        .set("Rigid parts/rocker/Elastic struts", "clamped")
        .support("pivot", "3", "pin")
        .add("Supports/motor",
             "Joints = 0 | Type = prescribed | Displacement x = 0 | "
             "Displacement y = 0 | Displacement z = 0 | Rotation x = 0 | "
             "Rotation y = 0 | Rotation z = 4 * (1 - cos(t))")
        .add(revolute("3", hinge))
        .add(weight)
        .time(3, 0.01);
    }
  };
} // namespace

TEST(SpaceMechanisms, ASpatialFourBarLinkageFollowsItsClosedForm)
{
  const Linkage linkage;
  SceneRun      run(linkage.scene());
  double        rocker = 0, error = 0, travel = 0;
  run.run([&] {
    rocker = linkage.rocker_angle(4 * (1 - std::cos(run.state.time)), rocker);
    travel = std::max(travel, std::abs(rocker));
    // Parts are in the order of their names.
    const SpaceVector turn =
      run.equations.reporting().rigid_parts->rotation(2, run.state);
    error = std::max(error, (turn - rocker * linkage.hinge).norm());
  });
  ComparisonTable table("Crank, coupler and rocker in space, the crank turns "
                        "by 8 rad");
  // The constraints hold to round-off at every step.
  table.row("angle of the rocker (rad)", error, 0, 1e-11);
  EXPECT_GT(travel, 0.2);
  // Second order: w dt = 0.04.
  EXPECT_LT(std::abs(run.balance()), 0.05);
}

TEST(SpaceMechanisms, TheCellOfRigidPartsMovesInSpaceAsInThePlane)
{
  const std::string file = prm_text("rigid-cell.prm");
  // A step by itself knows no checkpoints, at which factorizations are dropped.
  SceneRun plane(file, {"Output/Checkpoints=0"});
  // Its parts are bodies with a rotation now, its bars have ends that may leave
  // the plane; nothing pushes them out.
  SceneRun space("set Dimension = 3\n" + file,
                 {"Supports/guides/Displacement z=0",
                  "Connectors/damper/Direction=0 -1 0"});
  double   difference = 0, out_of_plane = 0, rotation = 0;
  plane.run([&] {
    space.advance();
    for (unsigned int joint = 0; joint < plane.lattice.joints.size(); ++joint)
      {
        for (unsigned int c = 0; c < 2; ++c)
          difference =
            std::max(difference,
                     std::abs(plane.motion(joint, c) - space.motion(joint, c)));
        out_of_plane = std::max(out_of_plane, std::abs(space.motion(joint, 2)));
      }
    for (unsigned int i = 0;
         i < space.equations.reporting().rigid_parts->n_reported();
         ++i)
      {
        const SpaceVector turn =
          space.equations.reporting().rigid_parts->rotation(i, space.state);
        rotation = std::max(rotation, std::hypot(turn[0], turn[1]));
      }
  });
  ComparisonTable table("Cell of rigid parts, case 1, in space against the "
                        "plane");
  table.row("positions (m)", difference, 0, 1e-11);
  table.row("out of the plane (m)", out_of_plane, 0, 1e-11);
  table.row("rotation across the plane (rad)", rotation, 0, 1e-11);
}
