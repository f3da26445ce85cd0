#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A mass M = 2 kg hits the free end of a clamped rod, L = 1 m, of wave speed
   * c = 1 m/s and mass m = 1 kg (EA = 1 N), with V = 1e-3 m/s.
   */
  SceneText rod(const unsigned int refinements, const double dt)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .given("rod", {1, 1, 1}, {1, 1})
      .support("wall", "0", "clamp")
      .mass("hammer", "1", 2)
      .add("Initial velocities/hammer", "Joints = 1 | Velocity x = -1e-3")
      .mesh(2, refinements)
      .set("Effects/Large rotation", "off")
      .time(1.75, dt, "newmark");
  }

  struct RodImpact
  {
    double speed, way;       ///< of the hammer at t = 1.75 L / c
    double wall_impulse = 0; ///< until then
  };

  RodImpact hit(const unsigned int refinements)
  {
    const double dt = 1. / (1 << (refinements + 2));
    SceneRun     run(rod(refinements, dt));
    RodImpact    result;
    double       before = run.reaction("wall", 0);
    run.run([&] {
      const double now = run.reaction("wall", 0);
      result.wall_impulse += dt / 2 * (before + now);
      before = now;
    });
    result.speed = -run.velocity(1, 0);
    result.way   = -run.motion(1, 0);
    return result;
  }
} // namespace

TEST(Impact, RodSlowsTheHammerByItsWave)
{
  // Until the wave is back, t < 2 L / c, the rod answers with (EA / c) v: the
  // hammer's speed is V exp(-m c t / (M L)), its way V M L / (m c) times
  // (1 - exp(...)); the wave doubles at the wall, so that the wall receives
  // twice what the rod received a time L / c ago.
  const double    V = 1e-3, t = 1.75;
  const RodImpact coarse = hit(6), fine = hit(7);
  const double    way = 2 * V * (1 - std::exp(-t / 2));
  ComparisonTable table("Mass on the end of a clamped rod, 1.75 L / c after it "
                        "hits; 128 elements of order 2");
  // The mesh gives the mass (h/6) m / M = 6.5e-4 of itself in addition, and
  // the jump at the front of the wave makes speeds and forces ripple.
  table.row("speed", fine.speed, V * std::exp(-t / 2), 1e-3 * V);
  table.row("way", fine.way, way, 1e-3 * V);
  table.row("impulse at the wall",
            fine.wall_impulse,
            2 * 2 * V * (1 - std::exp(-(t - 1) / 2)),
            1e-3 * V);
  // The former is first order in h.
  EXPECT_NEAR((coarse.way - way) / (fine.way - way), 2, 0.1);
}

namespace
{
  /** Rebound of a mass of 1 kg from a connector of K = 1 N/m at 1 m/s. */
  struct Rebound
  {
    double restitution_at_zero_force = 0, time_at_zero_force = 0;
    double restitution_at_zero_way = 0;
  };

  Rebound hit_connector(const std::string &law)
  {
    const double dt = 1e-3;
    SceneRun     run(one_mass_scene(law,
                                "Time step = " + text(dt) + " | End time = 4",
                                mass_and_velocity(1, -1)));
    Rebound      result;
    double       way = 0, force = 0, speed = -1;
    run.run([&] {
      const double way_now = run.motion(0, 0), speed_now = run.velocity(0, 0);
      const double force_now = run.connector(0, 0).force;
      // Linear in the step in which the sign changes.
      const auto at_zero = [&](const double a, const double b) {
        return speed + (speed_now - speed) * a / (a - b);
      };
      if (result.restitution_at_zero_force == 0 && force * force_now < 0)
        {
          result.restitution_at_zero_force = at_zero(force, force_now);
          result.time_at_zero_force =
            run.state.time - dt + dt * force / (force - force_now);
        }
      if (result.restitution_at_zero_way == 0 && way * way_now < 0)
        result.restitution_at_zero_way = at_zero(way, way_now);
      way   = way_now;
      force = force_now;
      speed = speed_now;
    });
    return result;
  }

  std::string kelvin_voigt(const double ratio)
  {
    return "Law = kelvin-voigt | Spring stiffness = 1 | "
           "Damping coefficient = " +
      text(2 * ratio);
  }
} // namespace

TEST(Impact, MassReboundsFromConnectorsAsInClosedForm)
{
  // Steps of 1e-3 / w0: (w0 dt)^2 / 12 = 8e-8 of the scheme, and as much of
  // the linear interpolation between steps.
  const double    allowed = 3e-7;
  ComparisonTable table("Mass rebounding from a connector, closed forms");
  // Restitution exp(-2 z acos z / sqrt(1 - z^2)) where the force is zero.
  for (const auto &[z, restitution] :
       std::vector<std::pair<double, double>>{{0.05, 0.8587581018},
                                              {0.1, 0.7440793977},
                                              {0.2, 0.5717400276},
                                              {0.5, 0.2984360592}})
    {
      const Rebound rebound = hit_connector(kelvin_voigt(z));
      const double  root    = std::sqrt(1 - z * z);
      table.row(label("Kelvin-Voigt, restitution at zero force, z", z),
                rebound.restitution_at_zero_force,
                restitution,
                allowed);
      table.row(label("Kelvin-Voigt, duration, z", z),
                rebound.time_at_zero_force,
                2 * std::acos(z) / root,
                5 * allowed);
      table.row(label("Kelvin-Voigt, restitution at zero displacement, z", z),
                rebound.restitution_at_zero_way,
                std::exp(-pi * z / root),
                allowed);
    }
  // Maxwell, tau = 1 / (2 z w0): exp(-pi z / sqrt(1 - z^2)) at zero force.
  const Rebound rebound =
    hit_connector("Law = maxwell | Spring stiffness = 1 | "
                  "Damping coefficient = 5");
  table.row("Maxwell, restitution at zero force, z = 0.1",
            rebound.restitution_at_zero_force,
            0.7292476143,
            allowed);
}
