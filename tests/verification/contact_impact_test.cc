#include <auxfem/contact/effects/contact.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <support/pi.h>
#include <verification/label.h>
#include <verification/momenta.h>
#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Impacts on rigid plates, and of such plates: forces, durations, velocities,
// energy and momentum.

namespace
{
  /** Force of the struts on a plate (N). */
  dealii::Tensor<1, 3> force_on(const SceneRun &run, const unsigned int plate)
  {
    return run.equations.reporting()
      .plates
      ->reports(run.equations.plate_results(run.results), run.state)[plate]
      .force;
  }

  /** A rod, L = 1 m, c = 100 m/s, rho c A = 40 kg/s, with 0.5 m/s towards a
   * wall that it is 1 % of a step from. */
  SceneText flying_rod(const unsigned int refinements)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("rod", 0.02, 0.02, {1e7, 1000})
      .mesh(2, refinements)
      .add("Initial velocities/flight", "Joints = all | Velocity x = 0.5")
      .add("Plates/wall",
           "Shape = plane | Normal = -1 0 | Position = 1.010001 0")
      .set("Newton/Tolerance", 1e-10);
  }

  struct RodOnWall
  {
    double impulse = 0, plateau = 0, speed = 0, energy_error = 0;
    double begin = -1, end = 0; ///< of contact (s)
  };

  /** Through the impact, 2 L / c = 20 ms. */
  RodOnWall hit_wall(const Scheme &scheme, const unsigned int refinements)
  {
    const double dt = 0.02 / (8 << refinements), end = 0.025;
    SceneRun run(flying_rod(refinements).add("Time", scheme.steps(dt, end)));
    const double before = MomentumMeter(run)().x;
    RodOnWall    result;
    unsigned int n = 0;
    run.run([&] {
      const double force = force_on(run, 0)[0];
      if (force > 1)
        {
          if (result.begin < 0)
            result.begin = run.state.time;
          result.end = run.state.time;
        }
      if (run.state.time > 0.004 && run.state.time < 0.016)
        {
          result.plateau += force;
          ++n;
        }
      result.energy_error =
        std::max(result.energy_error, std::abs(run.balance()));
    });
    result.plateau /= n;
    const double after = MomentumMeter(run)().x;
    result.impulse     = before - after;
    result.speed       = -after / 0.4;
    return result;
  }
} // namespace

TEST(ContactImpact, RodReboundsFromAWallByItsWave)
{
  // Goldsmith, Impact, 1960: the wall receives rho c A V until the wave that
  // the other end reflects is back, after 2 L / c, and the rod flies off as it
  // came.
  const double    V = 0.5, duration = 0.02, force = 20;
  ComparisonTable table("Elastic rod against a rigid wall, V = 0.5 m/s, "
                        "c = 100 m/s, 64 elements of order 2");
  for (const Scheme &scheme :
       {newmark(),
        hht("-0.05"),
        generalized_alpha("0.8"),
        Scheme{"energy-momentum", "Scheme = energy-momentum"},
        Scheme{"esdirk", "Scheme = esdirk"}})
    {
      const RodOnWall rod = hit_wall(scheme, 6);
      // The face gives way: its stiffness EA / (2 h) against rho c A makes a
      // time of 2 h / c, 1 % of the duration; the front of the wave is spread
      // over some elements.
      table.relative(scheme.name + ": mean force from 20 to 80 %",
                     rod.plateau,
                     force,
                     2e-3);
      table.relative(scheme.name + ": duration",
                     rod.end - rod.begin,
                     duration,
                     0.03);
      table.relative(scheme.name + ": impulse", rod.impulse, 2 * 0.4 * V, 3e-3);
      table.relative(scheme.name + ": velocity of the rebound",
                     rod.speed,
                     V,
                     3e-3);
    }
}

namespace
{
  /** Two struts at an angle without supports, which turn and fall with their
   * corner on a disc that flies towards them. */
  SceneText angle_and_disc()
  {
    return SceneText()
      .frame("0 0; 1 0.2; 0.3 1", "0 1; 0 2")
      .rectangle("bar", 0.04, 0.05, {2e6, 500})
      .mesh(3, 1)
      .add("Initial velocities/flight",
           "Joints = all | Velocity x = 0.2 | Velocity y = -1")
      .add("Plates/disc",
           "Shape = sphere | Radius = 0.3 | Position = 0.1 -0.35 | "
           "Displacement x = free | Displacement y = free | Mass = 0.8 | "
           "Initial velocity y = 2")
      .set("Newton/Tolerance", 1e-12)
      .add("Time",
           "Scheme = energy-momentum | Time step = 2e-4 | End time = 0.1");
  }
} // namespace

TEST(ContactImpact, EnergyAndMomentumStayThroughTheImpact)
{
  SceneRun   run(angle_and_disc());
  const auto momentum = [&run] {
    // Matrices belong to what is coupled, which changes.
    return MomentumMeter(run)();
  };
  const Momenta at_start = momentum();
  const double  energy   = run.state.energies.kinetic();
  double        error = 0, energy_error = 0, largest_force = 0, scale = 0;
  double        stored = 0;
  run.run([&] {
    const Momenta now = momentum();
    error             = std::max(
      {error, std::abs(now.x - at_start.x), std::abs(now.y - at_start.y)});
    scale         = std::max(scale, std::hypot(now.x, now.y));
    energy_error  = std::max(energy_error, std::abs(run.balance()));
    stored        = std::max(stored, run.state.energies.stored());
    largest_force = std::max(largest_force, force_on(run, 0).norm());
  });
  // The bodies have met and parted.
  EXPECT_GT(largest_force, 10);
  EXPECT_GT(stored, 1e-3 * energy);
  EXPECT_EQ(force_on(run, 0).norm(), 0);
  ComparisonTable table("Angle of two struts against a flying disc, "
                        "energy-momentum, errors through the impact");
  table.row("energy / kinetic energy", energy_error / energy, 0, 1e-9);
  table.row("momentum / momentum", error / scale, 0, 1e-10);
}

namespace
{
  /** A massless column, k = EA / L = 4000 N/m, whose face is a hundred thousand
   * times as stiff as others, and a weight of 0.5 kg on it that comes down with
   * 1.2 m/s. */
  SceneText drop_weight(const double dt)
  {
    return SceneText()
      .frame("0 0; 0 1", "0 1")
      .rectangle("column", 0.02, 0.02, {1e7, 0})
      .support("ground", "0", "clamp")
      .mesh(1)
      .set("Effects/Large rotation", "off")
      .set("Contact/Stiffness", 1e5)
      .add("Plates/weight",
           "Shape = plane | Normal = 0 -1 | Position = 0 1.01 | Mass = 0.5 | "
           "Displacement y = free | Initial velocity y = -1.2")
      .add("Time",
           "Scheme = energy-momentum | Start from = rest | End time = 0.05")
      .set("Time/Time step", dt);
  }
} // namespace

TEST(ContactImpact, WeightReboundsFromAColumnAsOnASpring)
{
  const double       k = 4000, m = 0.5, V = 1.2, dt = 2e-5;
  SceneRun           run(drop_weight(dt));
  const unsigned int weight  = run.lattice.joint_of_plate(0);
  double             largest = 0, end = 0, lowest = 0;
  run.run([&] {
    const double force = force_on(run, 0)[1];
    if (force > 0)
      end = run.state.time;
    largest = std::max(largest, force);
    lowest  = std::min(lowest, run.motion(weight, 1));
  });
  ComparisonTable table("Weight on a massless column, one-mass model with "
                        "k = EA / L");
  // The face goes in by 0.7 um of 13 mm, the duration is known to a step.
  table.relative("peak force V sqrt(k m)", largest, V * std::sqrt(k * m), 5e-5);
  table.relative("deepest V sqrt(m / k)", -lowest, V * std::sqrt(m / k), 1e-4);
  table.relative("duration pi sqrt(m / k)", end, pi * std::sqrt(m / k), 2e-3);
  table.relative("velocity of the rebound", run.velocity(weight, 1), V, 1e-6);
}

namespace
{
  /** The angle against a wall that is held, turned by @p angle. */
  struct TurnedImpact
  {
    explicit TurnedImpact(const double angle)
      : c(std::cos(angle))
      , s(std::sin(angle))
      , run(scene())
    {
      run.run();
    }

    std::string turned(const double x, const double y) const
    {
      return text(c * x - s * y) + " " + text(s * x + c * y);
    }

    std::string scene() const
    {
      const double vx = 0.2, vy = -1;
      return angle_and_disc()
        .set("Lattice/Joints",
             turned(0, 0) + "; " + turned(1, 0.2) + "; " + turned(0.3, 1))
        .set("Initial velocities/flight/Velocity x", c * vx - s * vy)
        .set("Initial velocities/flight/Velocity y", s * vx + c * vy)
        .set("Plates/disc/Position", turned(0.1, -0.35))
        .set("Plates/disc/Initial velocity x", -s * 2)
        .set("Plates/disc/Initial velocity y", c * 2)
        .add("Plates/wall",
             "Shape = plane | Normal = " + turned(1, 3) +
               " | Position = " + turned(0, -0.1))
        .set("Contact/Friction coefficient", 0.3)
        .set("Contact/Slip velocity", 0.05);
    }

    /** Displacement of a joint in the axes that turn. */
    std::array<double, 2> motion(const unsigned int joint) const
    {
      const double x = run.motion(joint, 0), y = run.motion(joint, 1);
      return {{c * x + s * y, c * y - s * x}};
    }

    const double c, s;
    SceneRun     run;
  };
} // namespace

TEST(ContactImpact, TurnedSceneHasTheTurnedMotion)
{
  const TurnedImpact one(0), other(0.7);
  EXPECT_GT(one.run.state.energies.dissipated(), 1e-3);
  for (unsigned int joint = 0; joint < 5; ++joint)
    for (unsigned int c = 0; c < 2; ++c)
      // Newton's tolerance of 1e-12 of the forces in 500 steps of an impact.
      EXPECT_NEAR(one.motion(joint)[c], other.motion(joint)[c], 1e-9);
}
