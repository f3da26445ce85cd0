#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Pendulums of stiff rods, 1 m long and 1 kg, without rotary inertia of their
// sections, against rigid ones. The stiffness lets gravity bend a rod by
// rho A g L^4 / (8 EI) = 1.5e-7 m.

namespace
{
  SceneText rods(const std::string &joints,
                 const std::string &struts,
                 const double       dt,
                 const double       end)
  {
    return SceneText()
      .frame(joints, struts)
      .rectangle("rod", 0.1, 0.1, {1e12, 100})
      .support("pivot", "0", "pin")
      .set("Gravity/Acceleration y", -9.81)
      .set("Effects/Rotary inertia", "off")
      .mesh(2)
      .time(end, dt);
  }

  /** Time (s) until a rod released at @p angle (rad) first hangs down. */
  double quarter_period(const double angle, const double dt, const double end)
  {
    SceneRun run(
      rods("0 0; " + text(std::sin(angle)) + " " + text(-std::cos(angle)),
           "0 1",
           dt,
           end));
    double before = angle, crossing = 0;
    run.run([&] {
      const double now = angle + run.motion(0, rotation_z);
      // The angle is nearly linear where it crosses zero: its second
      // derivative vanishes there.
      if (before > 0 && now <= 0)
        crossing = run.state.time - dt + dt * before / (before - now);
      before = now;
    });
    return crossing;
  }
} // namespace

TEST(Pendulum, PeriodIsTheEllipticIntegral)
{
  // T = 4 sqrt(l / g) K(sin(angle / 2)), l = 2/3 m for a rod.
  const std::vector<std::pair<double, double>> expected = {{30, 1.0174087976},
                                                           {90, 1.1803405990},
                                                           {150, 1.7622037295},
                                                           {179, 3.9010651604}};
  const double    small_period = 2 * pi * std::sqrt(2. / 3 / 9.81);
  ComparisonTable table("Period of a rigid pendulum over that of small swings, "
                        "extrapolated from steps of 2 and 1 ms");
  for (const auto &[degrees, ratio] : expected)
    {
      const double angle  = degrees * pi / 180;
      const double end    = small_period * ratio / 4 + 0.05;
      const double coarse = 4 * quarter_period(angle, 2e-3, end) / small_period;
      const double fine   = 4 * quarter_period(angle, 1e-3, end) / small_period;
      // Second order: (w dt)^2 / 12 is 1.2e-6 in small swings and more in
      // large ones. The extrapolation leaves the fourth order and the vibration
      // of the rod under its weight, suddenly applied.
      EXPECT_LT(std::abs(fine - ratio), 1e-5);
      table.relative(label("angle (deg)", degrees),
                     fine + (fine - coarse) / 3,
                     ratio,
                     3e-7);
    }
}

TEST(Pendulum, TwoRodsFollowTheRigidDoublePendulum)
{
  // Both released horizontally; angles from the downward vertical. Numerical
  // integration of the rigid equations to 1e-9.
  struct Moment
  {
    double                time;
    std::array<double, 2> angle, rate;
  };
  const std::vector<Moment> expected = {
    {0.25, {{1.195645790, 1.656050042}}, {{-2.75919418, 0.08291851}}},
    {0.5, {{0.448142626, 1.041962887}}, {{-2.41430831, -5.94910494}}},
    {1, {{-1.207716238, -0.814391023}}, {{-3.40651753, -0.51604547}}},
    {1.5, {{-1.150325680, -2.099126132}}, {{2.55540829, -1.96637281}}},
    {2, {{-0.082758307, 0.407362075}}, {{-0.96114544, 11.89895505}}}};

  const double dt = 2.5e-4;
  SceneRun     run(rods("0 0; 1 0; 2 0", "0 1; 1 2", dt, 2).hinge("knee", "1"));
  ComparisonTable table("Double pendulum of two rods (rad, rad/s)");
  auto            moment = expected.begin();
  run.run([&] {
    if (moment == expected.end() || run.state.time < moment->time - dt / 2)
      return;
    const unsigned int joints[2] = {0, 2};
    for (unsigned int rod = 0; rod < 2; ++rod)
      {
        const std::string name = "rod " + std::to_string(rod + 1);
        const double      rate = run.velocity(joints[rod], rotation_z);
        // (w dt)^2 / 12 = 8e-7 of the angle run through at up to 12 rad/s,
        // grown in the unstable motion; rates contain the vibration of the rods
        // under their weight, suddenly applied (1e-4 measured).
        table.row(label(name + " angle, t", run.state.time),
                  pi / 2 + run.motion(joints[rod], rotation_z),
                  moment->angle[rod],
                  2e-5);
        table.row(label(name + " rate, t", run.state.time),
                  rate,
                  moment->rate[rod],
                  3e-4);
      }
    ++moment;
  });
  EXPECT_EQ(moment, expected.end());
}
