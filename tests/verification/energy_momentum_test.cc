#include <verification/frame_text.h>
#include <verification/result_table.h>

#include <verification/momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Whole runs with Scheme = energy-momentum. A star cell of nylon strips, thrown
// by its upper half so that it tumbles and swings; joints turn by a
// third of a radian against each other.

namespace
{
  std::string star_cell(const std::string &scheme,
                        const double       dt,
                        const double       end,
                        const std::string &further = "")
  {
    return R"(
subsection Lattice
  set Cell          = star
  set Strut length  = 20 mm
  set Opening angle = 60 deg
end
subsection Sections
  subsection strip
    set Shape           = rectangle
    set Width           = 20 mm
    set Height          = 0.5 mm
    set Young's modulus = 2 GPa
    set Poisson's ratio = 0.4
    set Density         = 1140
  end
end
subsection Newton
  set Tolerance = 1e-11
end
subsection Discretization
  set Order = 2
end
subsection Time
  set Scheme    = )" +
      scheme + "\n  set Time step = " + text(dt) +
      "\n  set End time = " + text(end) + "\nend\n" + further;
  }

  const std::string dampers = R"(
subsection Connectors
  subsection damper
    set Law                 = kelvin-voigt
    set Spring stiffness    = 100
    set Damping coefficient = 0.5
  end
  subsection relaxing
    set Law                 = maxwell
    set Between             = in-cell x
    set Spring stiffness    = 500
    set Damping coefficient = 0.2
  end
end
)";

  const std::string thrown = R"(
subsection Initial velocities
  subsection throw
    set Joints     = top
    set Velocity x = 18
    set Velocity y = -30
  end
end
)";

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
  SceneRun run(star_cell("energy-momentum", 50e-6, 10e-3, dampers + R"(
subsection Joints
  subsection springs
    set Joints    = tips
    set Type      = rotational spring
    set Stiffness = 0.2
  end
end
subsection Supports
  subsection foundation
    set Joints = bottom
    set Type   = clamp
  end
end
subsection Loads
  subsection push
    set Joints   = top
    set Force y  = if(t < 4e-3, -6, 0)
    set Moment z = 5e-3 * sin(1000 * t)
  end
  subsection wind
    set Joints    = left
    set Direction = follows the joint
    set Force x   = 1
    set Moment z  = 2e-3
  end
end
subsection Gravity
  set Acceleration y = -9.81
end
)"),
               {"Sections/strip/Stiffness-proportional damping=20e-6",
                "Sections/strip/Mass-proportional damping=10"});
  double   largest = 0, error = 0, lost = 0;
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
  const auto positions = [&](const double dt) {
    SceneRun run(star_cell("energy-momentum", dt, 2e-3, dampers + R"(
subsection Loads
  subsection push
    set Joints    = top
    set Direction = follows the joint
    set Force x   = 10 * sin(1500 * t)^4
    set Force y   = -20 * sin(1500 * t)^4
    set Moment z  = 5e-2 * sin(1500 * t)^4
  end
end
)"),
                 {"Sections/strip/Stiffness-proportional damping=20e-6"});
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
  const auto coarse = positions(20e-6), middle = positions(10e-6),
             fine = positions(5e-6);
  double first = 0, second = 0;
  for (unsigned int i = 0; i < fine.size(); ++i)
    {
      first += std::pow(coarse[i] - middle[i], 2);
      second += std::pow(middle[i] - fine[i], 2);
    }
  EXPECT_GT(turned, 0.2);
  ComparisonTable table("Order of energy-momentum, star cell pushed smoothly");
  table.row("order of motion and velocity",
            std::log2(std::sqrt(first / second)),
            2,
            0.02);
}

// A rigid plate with elastic struts clamped to it and hinged at others: its
// constraints hold at the end of each step, their forces do no work.
TEST(EnergyMomentumRuns, RigidPartsKeepTheEnergy)
{
  SceneRun run(R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 2 0.3; 1.6 1.1; 0.2 1.4; 3 2; -1 2
  set Struts = 0 1; 1 2; 0 3; 2 4; 3 4; 3 5
end
subsection Sections
  subsection band
    set Shape = given
    set Area = 3
    set Shear area = 5
    set Second moment of area = 0.7
    set Young's modulus = 10
    set Poisson's ratio = 0.25
    set Density = 0.5
  end
end
subsection Rigid parts
  subsection plate
    set Struts = 0, 1, 2
    set Mass = 3
    set Elastic struts = clamped
  end
end
subsection Masses
  subsection tip
    set Joints = 5
    set Mass = 0.5
  end
end
subsection Loads
  subsection push
    set Joints = 4
    set Force x = if(t < 1, 6, 0)
    set Force y = if(t < 1, -3, 0)
  end
end
subsection Newton
  set Tolerance = 1e-11
end
subsection Time
  set Scheme = energy-momentum
  set Time step = 0.05
  set End time = 15
end
)");
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
  SceneRun run(R"(
set Dimension = 3
subsection Effects
  set Large rotation = off
end
subsection Lattice
  set Cell   = frame
  set Joints = 0 0 0; 1 0 0.3; 1.5 0.9 0.2
  set Struts = 0 1; 1 2
end
subsection Sections
  subsection rod
    set Shape = circle
    set Radius = 0.1
    set Young's modulus = 1000
    set Density = 2
    set Stiffness-proportional damping = 0.01
    set Mass-proportional damping = 0.02
  end
end
subsection Supports
  subsection wall
    set Joints = 0
    set Type = clamp
  end
end
subsection Loads
  subsection push
    set Joints = 2
    set Force z = if(t < 1, 0.02, 0)
    set Moment x = 0.01 * sin(3 * t)
  end
end
subsection Newton
  set Tolerance = 1e-12
end
subsection Time
  set Scheme = energy-momentum
  set Time step = 0.05
  set End time = 10
end
)");
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
