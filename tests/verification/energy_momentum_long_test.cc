#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_frame.h>
#include <verification/space_momenta.h>
#include <verification/tumbling_cell.h>

#include <verification/momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A hundred thousand steps of free, undamped structures with Scheme =
// energy-momentum.

namespace
{
  /** A rigid plate with elastic struts clamped to it and hinged at others. */
  SceneText tumbling_plate()
  {
    constexpr double dt = 0.05;
    return SceneText()
      .frame("0 0; 2 0.3; 1.6 1.1; 0.2 1.4; 3 2; -1 2",
             "0 1; 1 2; 0 3; 2 4; 3 4; 3 5")
      .given("band", {3, 5, 0.7}, {10, 0.5, 0.25})
      .add("Rigid parts/plate",
           "Struts = 0, 1, 2 | Mass = 3 | Elastic struts = clamped")
      .mass("tip", "5", 0.5)
      .add("Initial velocities/throw",
           "Joints = 4 | Velocity x = 1 | Velocity y = -0.5")
      .set("Newton/Tolerance", 1e-14)
      .time(n_long_steps * dt, dt, "energy-momentum");
  }

  void compare_long_run(const std::string &title,
                        const SceneText   &scene,
                        const bool         has_meter)
  {
    SceneRun                     run(scene.str());
    std::optional<MomentumMeter> meter;
    if (has_meter)
      meter.emplace(run);
    const Momenta start  = meter ? (*meter)() : Momenta();
    double        energy = 0, linear = 0, angular = 0;
    run.run([&] {
      energy = std::max(energy, std::abs(run.balance()) / run.initial_balance);
      if (!meter || run.state.step % 1000 != 0)
        return;
      const Momenta now = (*meter)();
      linear            = std::max(linear,
                        std::hypot(now.x - start.x, now.y - start.y) /
                          std::hypot(start.x, start.y));
      angular =
        std::max(angular,
                 std::abs(now.moment - start.moment) / std::abs(start.moment));
    });
    EXPECT_EQ(run.work().steps, n_long_steps);
    ComparisonTable table(title + ", energy-momentum, 100,000 steps");
    table.row("largest change of energy", energy, 0, 1e-9);
    if (!meter)
      return;
    table.row("of momentum", linear, 0, 1e-9);
    table.row("of moment of momentum", angular, 0, 1e-9);
  }
} // namespace

TEST(EnergyMomentumLong, StarCell)
{
  compare_long_run("Tumbling star cell",
                   tumbling_cell()
                     .set("Newton/Tolerance", 1e-14)
                     .set("Time/Scheme", "energy-momentum"),
                   true);
}

TEST(EnergyMomentumLong, RigidPlateWithStruts)
{
  compare_long_run("Tumbling rigid plate with struts", tumbling_plate(), false);
}

TEST(EnergyMomentumLong, FrameInSpace)
{
  constexpr double   dt = 0.02;
  SceneRun           run(SceneText()
                 .dimension(3)
                 .frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2", "0 1; 1 2")
                 .add("Sections/rod", rod_of_frame)
                 .add("Initial velocities/throw",
                      "Joints = 2 | Velocity x = 0.5 | Velocity y = -2 | "
                                "Velocity z = 2")
                 .mesh(2)
                 .set("Newton/Tolerance", 1e-14)
                 .time(n_long_steps * dt, dt, "energy-momentum")
                 .str());
  SpaceMomentumMeter meter(run);
  const SpaceMomenta start  = meter();
  double             energy = 0, linear = 0, angular = 0;
  run.run([&] {
    energy = std::max(energy, std::abs(run.balance()) / run.initial_balance);
    if (run.state.step % 1000 != 0)
      return;
    const SpaceMomenta now = meter();
    linear                 = std::max(linear,
                      (now.linear - start.linear).norm() / start.linear.norm());
    angular =
      std::max(angular,
               (now.angular - start.angular).norm() / start.angular.norm());
  });
  ComparisonTable table(
    "Tumbling frame in space, energy-momentum, 100,000 steps");
  table.row("largest change of energy", energy, 0, 1e-9);
  table.row("of momentum", linear, 0, 1e-9);
  table.row("of moment of momentum", angular, 0, 1e-9);
}
