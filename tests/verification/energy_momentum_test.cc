#include <support/scene_text.h>
#include <verification/result_table.h>

#include <verification/momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Whole runs with Scheme = energy-momentum. A star cell of nylon strips, thrown
// by its upper half so that it tumbles and swings; joints turn by a
// third of a radian against each other.

namespace
{
  SceneText star_cell(const std::string &scheme,
                      const double       dt,
                      const double       end,
                      const SceneText   &further = {})
  {
    return SceneText()
      .add("Lattice",
           "Cell = star | Strut length = 20 mm | Opening angle = 60 deg")
      .rectangle("strip", "20 mm", "0.5 mm", {"2 GPa", 1140, 0.4})
      .set("Newton/Tolerance", 1e-11)
      .mesh(2)
      .time(end, dt, scheme)
      .add(further);
  }

  const SceneText dampers =
    SceneText()
      .connector("damper",
                 "kelvin-voigt",
                 "Spring stiffness = 100 | "
                 "Damping coefficient = 0.5")
      .connector("relaxing",
                 "maxwell",
                 "Between = in-cell x | "
                 "Spring stiffness = 500 | Damping coefficient = 0.2");

  const SceneText thrown =
    SceneText().add("Initial velocities/throw",
                    "Joints = top | Velocity x = 18 | Velocity y = -30");

  /** Largest differences from the start in a run. */
  struct Drift
  {
    double        energy, momentum, moment; ///< of their sizes at the start
    double        turn;                     ///< rad, of a joint against another
    unsigned long retries;                  ///< rejected steps
  };

  Drift drift_of(const std::string &scheme)
  {
    SceneRun      run(star_cell(scheme, 20e-6, 6e-3, thrown));
    MomentumMeter meter(run);
    const Momenta start = meter();
    const double  size  = std::hypot(start.x, start.y);
    Drift         drift{0, 0, 0, 0, 0};
    run.run([&] {
      const Momenta now = meter();
      drift.energy =
        std::max(drift.energy, std::abs(run.balance()) / run.initial_balance);
      drift.momentum =
        std::max(drift.momentum,
                 std::hypot(now.x - start.x, now.y - start.y) / size);
      drift.moment =
        std::max(drift.moment,
                 std::abs(now.moment - start.moment) / std::abs(start.moment));
      drift.turn = std::max(drift.turn,
                            std::abs(run.motion(0, rotation_z) -
                                     run.motion(2, rotation_z)));
    });
    drift.retries = run.work().retries;
    return drift;
  }
} // namespace

TEST(EnergyMomentumRuns, AThrownCellKeepsEnergyAndMomenta)
{
  const Drift kept = drift_of("energy-momentum"), newmark = drift_of("newmark");
  ComparisonTable table("Thrown star cell, energy-momentum, 300 steps");
  // Each step is solved to 1e-11 of its forces.
  table.row("largest change of energy", kept.energy, 0, 1e-9);
  table.row("of momentum", kept.momentum, 0, 1e-10);
  table.row("of moment of momentum", kept.moment, 0, 1e-9);
  std::cout << "largest turn of joints against each other " << kept.turn
            << " rad; Newmark: energy " << newmark.energy
            << ", moment of momentum " << newmark.moment << '\n';
  EXPECT_EQ(kept.retries, 0u);
  EXPECT_GT(kept.turn, 0.2);
  EXPECT_GT(newmark.energy, 1e5 * kept.energy);
  EXPECT_GT(newmark.moment, 1e5 * kept.moment);
}

TEST(EnergyMomentumRuns, WithLossesAndLoadsTheLedgerCloses)
{
  SceneRun run(
    star_cell(
      "energy-momentum",
      50e-6,
      10e-3,
      SceneText(dampers)
        .add("Joints/springs",
             "Joints = tips | Type = rotational spring | Stiffness = 0.2")
        .support("foundation", "bottom", "clamp")
        .add("Loads/push",
             "Joints = top | Force y = if(t < 4e-3, -6, 0) | "
             "Moment z = 5e-3 * sin(1000 * t)")
        .add("Loads/wind",
             "Joints = left | Direction = follows the joint | Force x = 1 | "
             "Moment z = 2e-3")
        .set("Gravity/Acceleration y", -9.81)),
    {"Sections/strip/Stiffness-proportional damping=20e-6",
     "Sections/strip/Mass-proportional damping=10"});
  double largest = 0, error = 0, lost = 0;
  run.run([&] {
    largest = std::max(largest, run.state.largest_energy);
    error   = std::max(error, std::abs(run.balance()));
    // Never given back, step by step.
    EXPECT_GE(run.state.energies.dissipated(), lost);
    lost = run.state.energies.dissipated();
  });
  ComparisonTable table("Damped, loaded star cell, energy-momentum");
  EXPECT_GT(lost, 0.1 * largest);
  table.row("largest error of the energy balance, of the largest energy",
            error / largest,
            0,
            1e-10);
}

TEST(EnergyMomentumRuns, SecondOrder)
{
  double     turned    = 0;
  const auto positions = [&](const double dt, const std::string &damping) {
    SceneRun run(star_cell("energy-momentum",
                           dt,
                           2e-3,
                           SceneText(dampers).add(
                             "Loads/push",
                             "Joints = top | Direction = follows the joint | "
                             "Force x = 10 * sin(1500 * t)^4 | "
                             "Force y = -20 * sin(1500 * t)^4 | "
                             "Moment z = 5e-2 * sin(1500 * t)^4")),
                 // Struts that touch strike, which is not smooth.
                 {"Sections/strip/Stiffness-proportional damping=20e-6",
                  "Time/Damping of energy-momentum=" + damping,
                  "Effects/Contact=off"});
    run.run();
    turned = std::abs(run.motion(0, rotation_z));
    std::vector<double> result;
    for (unsigned int joint = 0; joint < 4; ++joint)
      for (const unsigned int c : {0u, 1u})
        {
          result.push_back(run.motion(joint, c));
          result.push_back(run.velocity(joint, c) * 1e-4);
        }
    return result;
  };
  ComparisonTable table("Order of energy-momentum, star cell pushed smoothly");
  for (const std::string damping : {"none", "0.125"})
    {
      const auto coarse = positions(20e-6, damping),
                 middle = positions(10e-6, damping),
                 fine   = positions(5e-6, damping);
      double first = 0, second = 0;
      for (unsigned int i = 0; i < fine.size(); ++i)
        {
          first += std::pow(coarse[i] - middle[i], 2);
          second += std::pow(middle[i] - fine[i], 2);
        }
      EXPECT_GT(turned, 0.2);
      table.row("order of motion and velocity, damping " + damping,
                std::log2(std::sqrt(first / second)),
                2,
                0.02);
    }
}

// A rigid plate with elastic struts clamped to it and hinged at others: its
// constraints hold at the end of each step, their forces do no work.
TEST(EnergyMomentumRuns, RigidPartsKeepTheEnergy)
{
  SceneRun run(SceneText()
                 .frame("0 0; 2 0.3; 1.6 1.1; 0.2 1.4; 3 2; -1 2",
                        "0 1; 1 2; 0 3; 2 4; 3 4; 3 5")
                 .given("band", {3, 5, 0.7}, {10, 0.5, 0.25})
                 .add("Rigid parts/plate",
                      "Struts = 0, 1, 2 | Mass = 3 | Elastic struts = clamped")
                 .mass("tip", "5", 0.5)
                 .add("Loads/push",
                      "Joints = 4 | Force x = if(t < 1, 6, 0) | "
                      "Force y = if(t < 1, -3, 0)")
                 .set("Newton/Tolerance", 1e-11)
                 .time(15, 0.05, "energy-momentum"));
  double   error = 0, largest = 0, turned = 0;
  run.run([&] {
    error   = std::max(error, std::abs(run.balance()));
    largest = std::max(largest, run.state.largest_energy);
    turned  = std::max(turned, std::abs(run.motion(4, rotation_z)));
  });
  ComparisonTable table("Free frame on a rigid plate, energy-momentum");
  EXPECT_GT(turned, 1);
  table.row("largest error of the energy balance, of the largest energy",
            error / largest,
            0,
            1e-9);
}

TEST(EnergyMomentumRuns, InSpaceSmallRotationsCloseTheLedger)
{
  SceneRun run(SceneText()
                 .dimension(3)
                 .set("Effects/Large rotation", "off")
                 .frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2", "0 1; 1 2")
                 .circle("rod", 0.1, {1000, 2})
                 .add("Sections/rod",
                      "Stiffness-proportional damping = 0.01 | "
                      "Mass-proportional damping = 0.02")
                 .support("wall", "0", "clamp")
                 .add("Loads/push",
                      "Joints = 2 | Force z = if(t < 1, 0.02, 0) | "
                      "Moment x = 0.01 * sin(3 * t)")
                 .set("Newton/Tolerance", 1e-12)
                 .time(10, 0.05, "energy-momentum"));
  double   error = 0, largest = 0;
  run.run([&] {
    error   = std::max(error, std::abs(run.balance()));
    largest = std::max(largest, run.state.largest_energy);
  });
  EXPECT_GT(run.state.energies.dissipated(), 0.1 * largest);
  ComparisonTable table(
    "Damped frame in space, small rotations, energy-momentum");
  table.row("largest error of the energy balance, of the largest energy",
            error / largest,
            0,
            1e-10);
}
