#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <verification/label.h>
#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Coulomb's friction of a strut that lies on a plane.

namespace
{
  constexpr double gravity = 10, mu = 0.3, slip_velocity = 1e-4;

  /** A free strut of 0.4 kg on a plane, with gravity at an angle whose tangent
   * is @p slope. It hardly bends; its face is as soft as that of one with E =
   * 0.1 MPa. */
  SceneText sliding_strut(const double slope)
  {
    const double down = gravity / std::sqrt(1 + slope * slope);
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("strut", 0.02, 0.02, {1e11, 1000})
      .mesh(2)
      .set("Gravity/Acceleration x", slope * down)
      .set("Gravity/Acceleration y", -down)
      .add("Plates/table", "Shape = plane | Normal = 0 1 | Position = 0 -0.01")
      .set("Contact/Stiffness", 1e-6)
      .set("Contact/Friction coefficient", mu)
      .set("Contact/Slip velocity", slip_velocity);
  }
} // namespace

TEST(ContactFriction, SlidingStrutStopsAndLosesItsKineticEnergy)
{
  const double    v = 0.5, end = v / (mu * gravity);
  ComparisonTable table("Strut sliding on a plane, mu = 0.3, stopped by "
                        "Coulomb's friction");
  for (const Scheme &scheme :
       {newmark(), Scheme{"energy-momentum", "Scheme = energy-momentum"}})
    {
      SceneRun run(sliding_strut(0)
                     .add("Initial velocities/push",
                          "Joints = all | Velocity x = " + text(v))
                     .add("Time", scheme.steps(end / 1000, 1.2 * end)));
      // The plane bears the weight and what throws the strut up: it falls by
      // 0.06 mm first, and swings.
      double halfway = 0, thrown = 0;
      run.run([&] {
        if (std::abs(run.state.time - end / 2) < end / 4000)
          {
            halfway = run.velocity(0, 0);
            thrown  = (run.velocity(0, 1) + run.velocity(1, 1)) / 2;
          }
      });
      table.relative(scheme.name + ": velocity at half time",
                     halfway + mu * thrown,
                     v / 2,
                     1e-3);
      // At the end it creeps slower than the slip velocity.
      table.relative(scheme.name + ": way v^2 / (2 mu g)",
                     run.motion(0, 0),
                     v * v / (2 * mu * gravity),
                     3e-3);
      table.relative(scheme.name + ": energy lost",
                     run.state.energies.dissipated(),
                     0.4 * v * v / 2,
                     3e-3);
      EXPECT_LT(std::abs(run.velocity(0, 0)), slip_velocity);
    }
}

TEST(ContactFriction, StrutSlidesOnASlopeSteeperThanFriction)
{
  ComparisonTable table("Strut on a slope, mu = 0.3: velocity after 0.2 s");
  const double    end = 0.2;
  for (const double slope : {0.15, 0.29, 0.31, 0.5})
    {
      // Dashpots across the plane end the swing with which it begins to lie on
      // it.
      SceneRun run(sliding_strut(slope)
                     .connector("rest",
                                "dashpot",
                                "Between = ground: 0, 1 | Geometry = direction "
                                "| Direction = 0 1 | Damping coefficient = 100")
                     .time(end, 1e-4, "newmark"));
      run.run();
      const double along = gravity / std::sqrt(1 + slope * slope),
                   part  = slope / mu;
      if (part > 1)
        // As it begins to lie on the plane this carries less: the dashpots take
        // 200 N s/m times how far it has come down.
        table.relative(label("slides, slope", slope),
                       run.velocity(0, 0) + mu * 200 * run.motion(0, 1) / 0.4,
                       along * (slope - mu) * end,
                       1e-3);
      else
        table.relative(label("creeps, slope", slope),
                       run.velocity(0, 0),
                       slip_velocity * part / std::sqrt(1 - part * part),
                       1e-3);
    }
}
