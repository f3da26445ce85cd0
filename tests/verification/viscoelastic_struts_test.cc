#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/frequency_response.h>
#include <auxfem/analysis/small_motions/natural_modes.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/linear_ode.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Struts that relax by a Prony series, against closed forms.

namespace
{
  constexpr double polymer_modulus = 1e6, bar_height = 0.02,
                   relaxing_part = 0.6, relaxing_time = 1;

  /** A material that keeps 1 - @p parts of its modulus. */
  SceneText polymer_material(const double      parts,
                             const double      time,
                             const std::string more = "")
  {
    return SceneText()
      .add("Materials/polymer",
           "Law = viscoelastic | Young's modulus = " + text(polymer_modulus) +
             " | Poisson's ratio = 0 | Relaxing parts = " + text(parts) +
             " | Relaxation times = " + text(time))
      .add("Materials/polymer", more);
  }

  /** A cantilever of length 1 along x of square section. */
  SceneText polymer_cantilever(const unsigned int dimension)
  {
    return polymer_material(relaxing_part,
                            relaxing_time,
                            "State at start = instantaneous")
      .dimension(dimension)
      .frame(dimension == 2 ? "0 0; 1 0" : "0 0 0; 1 0 0", "0 1")
      .add("Sections/bar",
           "Material = polymer | Shape = rectangle | Width = " +
             text(bar_height) + " | Height = " + text(bar_height))
      .support("clamp", "0", "clamp")
      .set("Time/Start from", "static equilibrium");
  }

  /** Growth of the deformation of a structure under constant loads at t = 2. */
  const double growth_by_creep =
    2.5 - 1.5 * std::exp(-2 * (1 - relaxing_part) / relaxing_time);

  constexpr double bar_bending =
    polymer_modulus * bar_height * bar_height * bar_height * bar_height / 12;

  /** Result of a run of 2 s: growth of a motion from its start to its end. */
  struct CreepResult
  {
    double growth, imbalance, lost, numerical;
  };

  CreepResult creep_result(SceneText          scene,
                           const double       dt,
                           const unsigned int joint,
                           const unsigned int component)
  {
    SceneRun     run(scene.time(2, dt, "static"));
    const double start = run.motion(joint, component);
    run.run();
    const Energies &energies = run.state.energies;
    return {run.motion(joint, component) / start,
            run.balance() / run.state.largest_energy,
            energies.sum(EnergyKind::dissipated),
            energies.sum(EnergyKind::numerical)};
  }

  void expect_growth(ComparisonTable   &table,
                     const std::string &name,
                     const SceneText   &scene,
                     const unsigned int joint,
                     const unsigned int component)
  {
    const CreepResult coarse = creep_result(scene, 0.125, joint, component),
                      fine   = creep_result(scene, 0.0625, joint, component);
    table.relative(name + ": growth", fine.growth, growth_by_creep, 4e-5);
    table.row(name + ": order in the step",
              std::log2((coarse.growth - growth_by_creep) /
                        (fine.growth - growth_by_creep)),
              2,
              0.1);
    table.row(name + ": energy balance", fine.imbalance, 0, 1e-9);
    EXPECT_GT(fine.lost, 0);
    // The growth of the loss by the rule of the step is of second order.
    EXPECT_LT(std::abs(fine.numerical), 1e-3 * fine.lost);
  }
} // namespace

TEST(ViscoelasticStruts, CreepUnderConstantLoads)
{
  ComparisonTable table(
    "Creep in two relaxation times, relaxing part 0.6: 2.5 - 1.5 exp(-0.8)");
  expect_growth(table,
                "cantilever, small displacements",
                polymer_cantilever(2)
                  .add("Loads/tip", "Joints = 1 | Force y = 1e-5")
                  .set("Effects/Large rotation", "off")
                  .mesh(3),
                1,
                1);
  const std::string moment = text(0.5 * bar_bending);
  expect_growth(table,
                "roll-up in the plane",
                polymer_cantilever(2)
                  .add("Loads/tip", "Joints = 1 | Moment z = " + moment)
                  .set("Effects/Large rotation", "on")
                  .mesh(3, 2),
                1,
                rotation_z);
  expect_growth(table,
                "roll-up in space",
                polymer_cantilever(3)
                  .add("Loads/tip", "Joints = 1 | Moment y = " + moment)
                  .set("Effects/Large rotation", "on")
                  .mesh(3, 2),
                1,
                4);
  expect_growth(table,
                "torsion",
                polymer_cantilever(3)
                  .add("Loads/tip",
                       "Joints = 1 | Moment x = " + text(0.2 * bar_bending))
                  .set("Effects/Large rotation", "on")
                  .mesh(3),
                1,
                3);
  // All moduli relax alike, so that every frame creeps by the same factor.
  expect_growth(table,
                "ring under point loads",
                polymer_cantilever(2)
                  .frame("0 0; 1 1; 0 2; -1 1",
                         "0 1 0.29289321881345; 1 2 0.29289321881345; "
                         "2 3 0.29289321881345; 3 0 0.29289321881345")
                  .add("Loads/tip", "Joints = 2 | Force y = -1e-4")
                  .set("Effects/Large rotation", "off")
                  .mesh(4, 1),
                2,
                1);
}

TEST(ViscoelasticStruts, RelaxUnderAHeldStrain)
{
  SceneText scene =
    polymer_cantilever(2)
      .add("Supports/pull",
           "Joints = 1 | Type = prescribed | Displacement x = 1e-3")
      .set("Effects/Large rotation", "off")
      .time(2, 0.5, "static");
  SceneRun     run(scene);
  const double start = run.reaction("pull", 0);
  run.run();
  ComparisonTable("Force after two relaxation times in four steps")
    .row("force over that at the start",
         run.reaction("pull", 0) / start,
         1 - relaxing_part + relaxing_part * std::exp(-2 / relaxing_time),
         1e-12);
}

TEST(ViscoelasticStruts, CreepWithAnElasticVolume)
{
  // The compliance of G relaxing by 0.6 with the bulk modulus constant,
  // in pure bending: 1/E = 1/9K + 1/3G.
  const double nu          = 0.3;
  const double shear_share = 2 * (1 + nu) / 3, bulk_share = 1 - shear_share;
  SceneText    scene = polymer_cantilever(2)
                      .add("Materials/polymer",
                           "Poisson's ratio = 0.3 | Volume change = elastic")
                      .add("Loads/tip", "Joints = 1 | Moment z = 1e-5")
                      .set("Effects/Large rotation", "off")
                      .mesh(3);
  const double exact  = bulk_share + shear_share * growth_by_creep,
               coarse = creep_result(scene, 0.125, 1, rotation_z).growth,
               fine   = creep_result(scene, 0.0625, 1, rotation_z).growth;
  ComparisonTable table("Creep in bending with an elastic bulk modulus");
  table.relative("growth", fine, exact, 4e-5);
  table.row("order in the step",
            std::log2((coarse - exact) / (fine - exact)),
            2,
            0.1);
}

namespace
{
  /** A mass of 1 kg on a strut of 1 N/m, pushed along it. */
  SceneText mass_on_relaxing_strut(const double parts, const double time)
  {
    return polymer_material(parts, time)
      .frame("0 0; 1 0", "0 1")
      .add("Materials/polymer", "Young's modulus = 1 | Density = 0")
      .add("Sections/bar",
           "Material = polymer | Shape = rectangle | Width = 1 | Height = 1")
      .support("clamp", "0", "clamp")
      .add("Supports/guide",
           "Joints = 1 | Type = prescribed | Displacement y = 0 | "
           "Rotation z = 0")
      .mass("body", "1", 1)
      .add("Initial velocities/push", "Joints = 1 | Velocity x = 1e-3")
      .set("Effects/Large rotation", "off")
      .set("Newton/Tolerance", 1e-13)
      .mesh(1);
  }

  struct StrutMotionError
  {
    double motion, imbalance, lost;
  };

  StrutMotionError strut_motion_error(const std::string &scheme,
                                      const double       time,
                                      const double       dt)
  {
    SceneRun run(mass_on_relaxing_strut(0.5, time).time(5, dt, scheme));
    run.run();
    const double exact = OneMass{1, 0.5, 0, {{0.5, time}}}.at(5, 0, 1e-3)(0);
    return {std::abs(run.motion(1, 0) - exact) / 1e-3,
            std::abs(run.balance()) / run.state.largest_energy,
            run.state.energies.sum(EnergyKind::dissipated)};
  }
} // namespace

TEST(ViscoelasticStruts, OrderOfTimeSchemesForAnyRelaxationTime)
{
  ComparisonTable table("Order of the motion of a mass on a relaxing strut");
  for (const char *scheme :
       {"newmark", "hht", "generalized-alpha", "energy-momentum"})
    for (const double time : {1e-3, 0.03, 1., 1000.})
      {
        const StrutMotionError coarse = strut_motion_error(scheme, time, 0.05),
                               fine   = strut_motion_error(scheme, time, 0.025);
        table.row(label(std::string(scheme) + ", relaxation time", time),
                  std::log2(coarse.motion / fine.motion),
                  2,
                  0.1);
        // Ends of steps share the numerical loss with the balance.
        EXPECT_LT(fine.imbalance, 1e-12) << scheme << ' ' << time;
        EXPECT_GT(fine.lost, 0);
      }
  for (const double time : {1., 1000.})
    table.row(label("esdirk of order 4, relaxation time", time),
              std::log2(strut_motion_error("esdirk", time, 0.2).motion /
                        strut_motion_error("esdirk", time, 0.1).motion),
              4,
              0.3);
}

// s^3 + s^2 / tau + w0^2 s + w_inf^2 / tau = 0 for the first bending mode.
TEST(ViscoelasticStruts, DampedModeOfAPinnedBeam)
{
  const double parts = 0.5, density = 1000;
  const double inertia = density * bar_height * bar_height;
  const double omega   = pi * pi * std::sqrt(bar_bending / inertia);
  const Scene  scene   = read_scene_from_text(
    polymer_material(parts, 1 / omega, "Density = " + text(density))
      .frame("0 0; 1 0", "0 1")
      .add("Sections/bar",
           "Material = polymer | Shape = given | Area = " +
             text(bar_height * bar_height) + " | Shear area = 1 | " +
             "Second moment of area = " + text(bar_bending / polymer_modulus))
      .support("left", "0", "pin")
      .support("right", "1", "roller x")
      .add("Effects",
           "Strut relaxation = on | Rotary inertia = off | "
              "Shear flexibility = on")
      .set("Analysis", "modes")
      .mesh(6, 1)
      .str(),
    "test.prm");
  LatticeRun run(scene, MPI_COMM_SELF);
  run.prepare();
  NaturalModes found = natural_modes(run.solver(), run.solution.state, 1);
  add_damped_modes(run.solver(), run.solution.state, found);
  const NaturalMode &mode = found.modes.front();
  ASSERT_TRUE(mode.damped);
  ComparisonTable table("First mode of a pinned beam, g = 0.5, tau w0 = 1");
  table.relative("relaxed frequency",
                 mode.angular_frequency() / omega,
                 std::sqrt(1 - parts),
                 2e-5);
  table.row("growth", mode.damped->growth / omega, -0.17610056, 2e-5);
  table.row("damped frequency",
            mode.damped->angular_frequency / omega,
            0.86071662,
            2e-5);
}

// Force over displacement E* A k cot(k L), k = omega sqrt(rho / E*).
TEST(ViscoelasticStruts, FrequencyResponseOfARod)
{
  const double density = 1000, frequency = 8, omega = 2 * pi * frequency;
  const Scene  scene = read_scene_from_text(
    polymer_material(relaxing_part, 0.02, "Density = " + text(density))
      .frame("0 0; 1 0", "0 1")
      .add("Sections/bar",
           "Material = polymer | Shape = rectangle | Width = 1 | Height = 1")
      .support("wall", "0", "clamp")
      .add("Supports/guide",
           "Joints = 1 | Type = prescribed | Displacement y = 0 | "
            "Rotation z = 0")
      .add("Loads/push", "Joints = 1 | Force x = t")
      .set("Analysis", "frequency response")
      .mesh(4, 3)
      .time(1, 0.1, "newmark")
      .str(),
    "test.prm");
  LatticeRun run(scene, MPI_COMM_SELF);
  run.prepare();
  const HarmonicVibration vibration =
    HarmonicResponse(run.solver(), run.solution.state).at(omega);
  const int                  end = run.model.numbering.joint_unknown(1, 0);
  const std::complex<double> found(vibration.displacement.real[end],
                                   vibration.displacement.imaginary[end]);
  using namespace std::complex_literals;
  const std::complex<double> s = 1i * omega,
                             E = polymer_modulus *
    (1 - relaxing_part + relaxing_part * s * 0.02 / (1. + s * 0.02)),
                             k     = omega * std::sqrt(density / E),
                             exact = std::tan(k) / (E * k);
  ComparisonTable("Displacement of a relaxing rod under a harmonic force")
    .row("relative error", std::abs(found - exact) / std::abs(exact), 0, 1e-7);
}

// Struts of one batch with different directions and stiffnesses report the
// forces of elastic ones, if nearly nothing relaxes.
TEST(ViscoelasticStruts, ReportForcesOfTheirOwn)
{
  const auto forces = [](const unsigned int dimension, const bool relaxing) {
    const bool is_plane = dimension == 2;
    SceneRun   run(
      polymer_material(1e-12, 1)
        .dimension(dimension)
        .frame(is_plane ? "0 0; 1 0; 1.5 1; 0.2 0.7"
                        : "0 0 0; 1 0 0.2; 1.5 1 0; 0.2 0.7 0.6",
               "0 1; 1 2; 2 3; 3 0; 0 2; 1 3")
        .set("Lattice/Struts may cross", "true")
        .add("Materials/elastic",
             "Young's modulus = " + text(polymer_modulus) +
               " | Poisson's ratio = 0")
        .add("Sections/thin",
             std::string("Shape = rectangle | Width = 0.02 | Height = 0.02 | "
                           "Material = ") +
               (relaxing ? "polymer" : "elastic"))
        .add("Sections/thick",
             std::string("Shape = rectangle | Width = 0.02 | Height = 0.05 | "
                           "Struts = 1 4 5 | Material = ") +
               (relaxing ? "polymer" : "elastic"))
        .support("clamp", "0", "clamp")
        .add("Loads/pull",
             "Joints = 2 | Force x = 0.2 * t | Force y = -0.1 * t")
        .mesh(3)
        .set("Newton/Tolerance", 1e-12)
        .time(1, 0.5, "static"));
    run.run();
    std::vector<double> values;
    for (unsigned int strut = 0; strut < 6; ++strut)
      for (const StrutGroup &group : run.equations.reporting().struts)
        {
          const DofNumbering::Group &elements = group.forces->elements();
          for (unsigned int e = elements.begin; e < elements.end; ++e)
            if (run.model.numbering.elements()[e].interval.strut == strut)
              for (const StrutPoint &point :
                   group.forces->sample(run.state, e, 3))
                {
                  for (unsigned int c = 0; c < 3; ++c)
                    {
                      values.push_back(point.force[c]);
                      values.push_back(point.moment[c]);
                    }
                  values.push_back(point.energy_density);
                }
        }
    return values;
  };
  for (const unsigned int dimension : {2u, 3u})
    {
      const std::vector<double> elastic = forces(dimension, false),
                                relaxed = forces(dimension, true);
      ASSERT_EQ(relaxed.size(), elastic.size());
      for (std::size_t i = 0; i < elastic.size(); ++i)
        EXPECT_NEAR(relaxed[i], elastic[i], 1e-8) << dimension << "D, " << i;
    }
}
