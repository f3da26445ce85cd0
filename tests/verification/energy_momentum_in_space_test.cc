#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_frame.h>
#include <verification/space_momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Whole runs with Scheme = energy-momentum in space, at large rotations.

namespace
{
  const std::string space_throw =
    "Joints = 2 | Velocity x = 0.5 | Velocity y = -2 | Velocity z = 2";

  /** Two struts at an angle that bend and twist by more than a radian. */
  SceneText
  bent_frame(const unsigned int order, const double dt, const double end)
  {
    return SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2", "0 1; 1 2")
      .add("Sections/rod", rod_of_frame)
      .mesh(order)
      .set("Newton/Tolerance", 1e-12)
      .time(end, dt, "energy-momentum");
  }

  /** Largest differences from the start in a run. */
  struct SpaceDrift
  {
    double energy = 0, linear = 0, angular = 0; ///< of their sizes
    double turn = 0; ///< rad, of a joint against another
  };

  SpaceDrift space_drift_of(const SceneText &scene, const std::string &scheme)
  {
    SceneRun           run(scene, {"Time/Scheme=" + scheme});
    SpaceMomentumMeter meter(run);
    const SpaceMomenta start = meter();
    SpaceDrift         drift;
    run.run([&] {
      const SpaceMomenta now    = meter();
      const auto update_largest = [](double &largest, const double value) {
        largest = std::max(largest, value);
      };
      update_largest(drift.energy,
                     std::abs(run.balance()) / run.initial_balance);
      update_largest(drift.linear,
                     (now.linear - start.linear).norm() / start.linear.norm());
      update_largest(drift.angular,
                     (now.angular - start.angular).norm() /
                       start.angular.norm());
      update_largest(drift.turn,
                     rotation_vector(run.state.rotations[0] *
                                     conjugate(run.state.rotations[1]))
                       .norm());
    });
    return drift;
  }

  void compare_ledger(const std::string &title, SceneRun &run)
  {
    double error = 0, largest = 0, lost = 0;
    run.run([&] {
      error   = std::max(error, std::abs(run.balance()));
      largest = std::max(largest, run.state.largest_energy);
      // Never given back, step by step.
      EXPECT_GE(run.state.energies.dissipated(), lost);
      lost = run.state.energies.dissipated();
    });
    ComparisonTable table(title);
    table.row("largest error of the energy balance, of the largest energy",
              error / largest,
              0,
              1e-10);
  }

  // A frame with all that the scheme has to balance.
  SceneText loaded_frame()
  {
    return SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2; 0.4 1 -0.3; 0.2 1.9 0.4; "
             "1.2 2 0.1",
             "0 1; 1 2; 2 3; 3 4; 2 5")
      .add("Sections/rod", rod_of_frame)
      .mesh(2)
      .set("Newton/Tolerance", 1e-12);
  }
} // namespace

TEST(EnergyMomentumInSpace, AThrownFrameKeepsEnergyAndMomenta)
{
  ComparisonTable table("Thrown frame in space, energy-momentum, 200 steps");
  for (unsigned int order = 1; order <= 4; ++order)
    {
      const SceneText scene =
        bent_frame(order, 0.02, 4).add("Initial velocities/throw", space_throw);
      const SpaceDrift  kept = space_drift_of(scene, "energy-momentum");
      const std::string of   = ", order " + std::to_string(order);
      // Each step is solved to 1e-12 of its forces.
      table.row("largest change of energy" + of, kept.energy, 0, 1e-9);
      table.row("of momentum" + of, kept.linear, 0, 1e-11);
      table.row("of moment of momentum" + of, kept.angular, 0, 1e-10);
      EXPECT_GT(kept.turn, 0.8);
    }
  const SpaceDrift newmark = space_drift_of(
    bent_frame(2, 0.02, 4).add("Initial velocities/throw", space_throw),
    "newmark");
  EXPECT_GT(newmark.energy, 1e-3);
  EXPECT_GT(newmark.angular, 1e-4);
}

TEST(EnergyMomentumInSpace, WithLossesAndLoadsTheLedgerCloses)
{
  SceneRun run(
    loaded_frame()
      .time(4, 0.02, "energy-momentum")
      .add("Joints/spring",
           "Joints = 1 | Struts = 1 | Type = rotational spring | Stiffness = 2")
      .add("Joints/axle",
           "Joints = 3 | Struts = 3 | Type = revolute | Axis = 1 2 -1")
      .add("Joints/ball", "Joints = 2 | Struts = 4 | Type = hinge")
      .add("Masses/wheel",
           "Joints = 4 | Mass = 0.2 | Rotary inertia = 0.02, 0.03, 0.01")
      .connector("damper",
                 "kelvin-voigt",
                 "Between = 0 2; 1 3 | Spring stiffness = 3 | "
                 "Damping coefficient = 0.4")
      .support("wall", "0", "clamp")
      .add("Loads/push",
           "Joints = 4 | Force z = if(t < 1, 0.2, 0) | "
           "Moment x = 0.05 * sin(3 * t) | Moment y = 0.02")
      .add("Loads/wind",
           "Joints = 2 | Direction = follows the joint | Force x = 0.1 | "
           "Moment y = 0.05 * sin(2 * t) | Moment z = 0.03")
      .set("Gravity/Acceleration y", -0.3),
    {"Sections/rod/Stiffness-proportional damping=0.01",
     "Sections/rod/Mass-proportional damping=0.1"});
  compare_ledger("Damped, loaded frame in space, energy-momentum", run);
  EXPECT_GT(run.state.energies.dissipated(), 0.05 * run.state.largest_energy);
}

TEST(EnergyMomentumInSpace, RigidPartsKeepTheEnergy)
{
  SceneRun run(loaded_frame()
                 .time(4, 0.02, "energy-momentum")
                 .add("Rigid parts/stick",
                      "Struts = 1, 2 | Mass = 0.5 | Elastic struts = clamped")
                 .add("Initial velocities/throw",
                      "Joints = 5 | Velocity x = 0.5 | Velocity y = -2 | "
                      "Velocity z = 2"));
  compare_ledger("Free frame with a rigid part in space, energy-momentum", run);
}

// Supports that move and turn; forces of inertia on them included.
TEST(EnergyMomentumInSpace, WorkOfMovingSupportsIsTheEnergyTheyBring)
{
  SceneRun run(loaded_frame()
                 .time(3, 0.02, "energy-momentum")
                 .prescribe("shaker",
                            "0",
                            {"0.05 * sin(2 * t)^2", "0", "0.1 * t^2"},
                            {"0.3 * t^2", "0.2 * sin(t)^2", "-0.1 * t^2"}));
  compare_ledger("Frame on a support that turns in space, energy-momentum",
                 run);
  EXPECT_GT(run.state.energies.total(), 0.1 * run.state.largest_energy);
}

TEST(EnergyMomentumInSpace, SecondOrder)
{
  double     turned    = 0;
  const auto positions = [&](const double dt) {
    SceneRun run(loaded_frame()
                   .time(1, dt, "energy-momentum")
                   .support("wall", "0", "clamp")
                   .add("Loads/push",
                        "Joints = 4 | Direction = follows the joint | "
                        "Force x = 0.3 * sin(pi * t)^4 | "
                        "Force z = -0.5 * sin(pi * t)^4 | "
                        "Moment y = 0.12 * sin(pi * t)^4"),
                 {"Sections/rod/Stiffness-proportional damping=0.01"});
    run.run();
    for (const Quaternion &rotation : run.state.rotations)
      turned = std::max(turned, rotation_vector(rotation).norm());
    std::vector<double> result;
    for (unsigned int joint = 1; joint < 6; ++joint)
      for (unsigned int c = 0; c < 6; ++c)
        {
          result.push_back(run.motion(joint, c));
          result.push_back(run.velocity(joint, c));
        }
    return result;
  };
  const auto coarse = positions(0.005), middle = positions(0.0025),
             fine = positions(0.00125);
  double first = 0, second = 0;
  for (unsigned int i = 0; i < fine.size(); ++i)
    {
      first += std::pow(coarse[i] - middle[i], 2);
      second += std::pow(middle[i] - fine[i], 2);
    }
  EXPECT_GT(turned, 0.3);
  ComparisonTable table("Order of energy-momentum in space");
  table.row("order of motion and velocity",
            std::log2(std::sqrt(first / second)),
            2,
            0.05);
}
