#include <auxfem/analysis/infinite_lattice/effective_properties.h>
#include <auxfem/analysis/infinite_lattice/effective_response.h>
#include <auxfem/analysis/infinite_lattice/harmonic_moduli.h>
#include <auxfem/output/recorder.h>
#include <auxfem/time/schemes/static.h>

#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <vector>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText period_of(const std::string &cell, const std::string &sizes)
  {
    return SceneText()
      .set("Analysis", "effective properties")
      .set("Lattice/Cell", cell)
      .add("Lattice", sizes)
      .rectangle("wall", 1, 0.05, {1, "", 0.3})
      .set("Effects/Shear flexibility", "on");
  }

  struct RigidCell
  {
    std::string cell, sizes, rigid_struts;
    double      C11, C12, C66, C66_without_shear, C11_without_shear,
      C12_without_shear;
  };
} // namespace

TEST(InfiniteLattice, RigidRingsAndSquares)
{
  const std::vector<RigidCell> cells = {
    {"tetrachiral",
     "Ligament length = 1 | Ring radius = 0.2",
     "rings",
     0.022003032,
     -0.021117525,
     0.0035017382,
     0.0035021552,
     0.022006499,
     -0.021114191},
    {"anti-tetrachiral",
     "Ring distance = 1 | Ring radius = 0.2",
     "rings",
     0.025129534,
     -0.024870466,
     6.2016273e-05,
     6.25e-05,
     0.025129534,
     -0.024870466},
    {"hexachiral",
     "Ligament length = 1 | Ring radius = 0.2",
     "rings",
     0.022471214,
     -0.020937471,
     0.021704343,
     0.021704762,
     0.022477523,
     -0.020932001},
    {"rotating squares",
     "Square side = 1 | Turn angle = 20 deg | Hinge length = 0.1",
     "edges + spokes",
     0.050007123,
     -0.049992877,
     0.00048487199,
     0.0005,
     0.050007123,
     -0.049992877}};
  ComparisonTable table("Infinite lattices with rigid rings or squares: "
                        "independent code for periodic frames");
  for (const RigidCell &reference : cells)
    for (const bool has_shear : {true, false})
      {
        SceneText scene =
          period_of(reference.cell, reference.sizes)
            .set("Effects/Shear flexibility", has_shear ? "on" : "off")
            .rigid_part("stiff", reference.rigid_struts, 0)
            .set("Rigid parts/stiff/Elastic struts", "clamped");
        if (reference.cell == "rotating squares")
          scene.rectangle("hinge", 1, 0.01, {1, "", 0.3})
            .set("Sections/hinge/Struts", "hinges");
        const auto properties =
          effective_properties(read_scene_from_text(scene.str(), "rigid.prm"),
                               MPI_COMM_WORLD);
        const auto       &C = properties.elastic.stiffness();
        const std::string at =
          reference.cell + (has_shear ? ", shear: " : ": ");
        const double allowed = 1e-7 * reference.C11;
        table.row(at + "C11",
                  C(0, 0),
                  has_shear ? reference.C11 : reference.C11_without_shear,
                  allowed);
        table.row(at + "C12",
                  C(0, 1),
                  has_shear ? reference.C12 : reference.C12_without_shear,
                  allowed);
        table.row(at + "C66",
                  C(2, 2),
                  has_shear ? reference.C66 : reference.C66_without_shear,
                  allowed);
      }
}

namespace
{
  const std::string star_of_moduli =
    "Strut length = 1 | Opening angle = 60 deg";

  struct ModulusReference
  {
    double               angular_frequency;
    std::complex<double> across, along; ///< E2, E1 (Pa)
  };

  void compare_moduli(const std::string                   &title,
                      const std::string                   &law,
                      const std::string                   &entries,
                      const bool                           has_shear,
                      const std::vector<ModulusReference> &references)
  {
    const Scene scene = read_scene_from_text(
      period_of("star", star_of_moduli)
        .set("Effects/Shear flexibility", has_shear ? "on" : "off")
        .connector("damper", law, "Between = in-cell | " + entries)
        .str(),
      "moduli.prm");
    std::vector<double> frequencies;
    for (const ModulusReference &reference : references)
      frequencies.push_back(reference.angular_frequency / (2 * pi));
    LatticeRun run(with_damping(plan_of_unit_strains(scene)), MPI_COMM_WORLD);
    ASSERT_TRUE(has_damping(run.model.plan.simulated));
    const auto      moduli = harmonic_moduli(run, frequencies);
    ComparisonTable table(title + (has_shear ? ", shear" : "") +
                          ": closed form and complex stiffness method");
    for (std::size_t i = 0; i < references.size(); ++i)
      {
        const auto compliance = moduli[i].compliance();
        ASSERT_TRUE(compliance.has_value());
        const std::string at =
          "at " + formatted("%g", references[i].angular_frequency) + " rad/s: ";
        const auto compare = [&](const std::string          &name,
                                 const std::complex<double> &found,
                                 const std::complex<double> &expected) {
          table.row(at + name + " storage",
                    found.real(),
                    expected.real(),
                    1e-7 * std::abs(expected));
          table.row(at + name + " loss",
                    found.imag(),
                    expected.imag(),
                    1e-7 * std::abs(expected));
        };
        compare("E1", 1. / (*compliance)(0, 0), references[i].along);
        compare("E2", 1. / (*compliance)(1, 1), references[i].across);
      }
  }

  using Complex = std::complex<double>;
} // namespace

TEST(InfiniteLattice, StorageAndLossModuli)
{
  const std::string kelvin_voigt = "Spring stiffness = 1e-4 | "
                                   "Damping coefficient = 2e-3",
                    maxwell      = "Spring stiffness = 1e-4 | "
                                   "Damping coefficient = 2e-3";
  const std::string title        = "Star lattice with a damper in each cell: ";
  compare_moduli(title + "Kelvin-Voigt",
                 "kelvin-voigt",
                 kelvin_voigt,
                 true,
                 {{0.005,
                   Complex(2.0156380e-4, 9.8394006e-6),
                   Complex(1.2092570e-4, 1.0799555e-6)},
                  {0.05,
                   Complex(2.0195029e-4, 9.8392472e-5),
                   Complex(1.2463005e-4, 9.3080129e-6)},
                  {0.5,
                   Complex(2.4053882e-4, 9.8239362e-4),
                   Complex(1.4618637e-4, 6.2844641e-6)}});
  compare_moduli(title + "Maxwell",
                 "maxwell",
                 maxwell,
                 true,
                 {{0.005,
                   Complex(1.0375973e-4, 9.8189763e-6),
                   Complex(1.0326756e-4, 2.9487814e-6)},
                  {0.05,
                   Complex(1.5236328e-4, 4.9392599e-5),
                   Complex(1.1611994e-4, 7.9722963e-6)},
                  {0.5,
                   Complex(2.0058949e-4, 9.7427462e-6),
                   Complex(1.2081783e-4, 1.0778603e-6)}});
  compare_moduli(title + "Maxwell",
                 "maxwell",
                 maxwell,
                 false,
                 {{0.05,
                   Complex(1.5302399e-4, 4.9389973e-5),
                   Complex(1.1669296e-4, 7.9286870e-6)}});
}

namespace
{
  using Histories = std::map<std::string, std::vector<double>>;

  /** Histories of the response of a period, by column. */
  Histories histories_of(const SceneText &text)
  {
    const Scene    scene = read_scene_from_text(text, "period.prm");
    MemoryRecorder rows(scene, MPI_COMM_WORLD);
    run_effective_response(scene, MPI_COMM_WORLD, rows, std::nullopt);
    Histories histories;
    for (const Column &column : rows.columns())
      histories[column.name] = rows.column(column.name);
    return histories;
  }
} // namespace

// A step of strain across, lateral stress free: E2(t) = Ei + (E0 - Ei)
// e^(-t/tr).
TEST(InfiniteLattice, RelaxationAfterAStepOfStrain)
{
  const double strain = 1e-7;
  SceneText    star =
    period_of("star", star_of_moduli)
      .set("Analysis", "effective response")
      .connector("damper",
                 "maxwell",
                 "Between = in-cell | Spring stiffness = 1e-4 | "
                 "Damping coefficient = 2e-3")
      .add("Mean deformation",
           // As good as at once.
           "Strain xy = 0 | Strain yy = min(t / 1e-6, 1) * " + text(strain))
      .set("Time/Scheme", "static")
      .set("Time/End time", "20")
      .set("Time/Time step", "0.2");
  const Histories            rows   = histories_of(star);
  const std::vector<double> &times  = rows.at("time"),
                            &stress = rows.at("stress_yy");
  const double at_once = 2.0155990e-4, at_rest = 1.0277392e-4, tr = 20.079671;
  ComparisonTable table(
    "Star lattice with a Maxwell element in each cell after "
    "a step of strain: closed form");
  for (const double time : {2., 10., 20.})
    {
      const auto i =
        std::min_element(times.begin(),
                         times.end(),
                         [time](const double one, const double other) {
                           return std::abs(one - time) < std::abs(other - time);
                         }) -
        times.begin();
      table.relative("E2 at " + formatted("%g", time) + " s",
                     stress[i] / strain,
                     at_rest + (at_once - at_rest) * std::exp(-time / tr),
                     2e-5);
    }
}

namespace
{
  /** Re-entrant hexagons whose vertices touch after a tenth of strain: one cell
   * of two joints and three struts. */
  SceneText touching_cells(const unsigned int n)
  {
    const std::string cells = std::to_string(n);
    return SceneText()
      .set("Analysis", "effective response")
      .add("Lattice",
           "Cell = pattern | Joints = 0 0; 0 1.2 | Struts = 0 1 | "
           "Neighbour struts = inclined: 1 0 at 1 0; inclined: 1 0 at 0 1 | "
           "Vector x = 0.86602540378443865 0.7 | "
           "Vector y = -0.86602540378443865 0.7")
      .set("Lattice/Cells x", cells)
      .set("Lattice/Cells y", cells)
      .rectangle("wall", 1, 0.05, {1, "", 0.3})
      .add("Mean deformation",
           "Strain xy = 0 | Strain yy = -0.2 * t | Stability waves = 1")
      .set("Time/Scheme", "static")
      .set("Time/End time", "1")
      .set("Time/Time step", "0.02")
      .mesh(4);
  }
} // namespace

// The struts of four cells touch each other where those of one touch copies in
// neighbouring periods.
TEST(InfiniteLattice, ContactBetweenPeriodsIsThatWithin)
{
  const Histories one               = histories_of(touching_cells(1)),
                  four              = histories_of(touching_cells(2));
  const std::vector<double> &stress = one.at("stress_yy"),
                            &other  = four.at("stress_yy"),
                            &strain = one.at("strain_xx");
  ASSERT_EQ(stress.size(), other.size());
  const double    largest = std::abs(stress.back());
  ComparisonTable table("Re-entrant lattice pressed until struts touch: one "
                        "cell against four");
  for (const std::size_t i : {std::size_t(25), stress.size() - 1})
    {
      table.row("stress", stress[i], other[i], 1e-8 * largest);
      table.row("lateral strain", strain[i], four.at("strain_xx")[i], 1e-8);
    }
  EXPECT_GT(largest, 50 * std::abs(stress[25])) << "no contact";
}

TEST(InfiniteLattice, WavesAreNotCheckedWherePeriodsTouch)
{
  const Scene scene = read_scene_from_text(touching_cells(1), "touch.prm");
  LatticeRun  run(plan_of_response(scene), MPI_COMM_WORLD);
  Recorder    nobody;
  run.prepare();
  EXPECT_FALSE(PeriodTangent(run.equations, run.solution.state)
                 .has_contact_between_periods());
  for (unsigned int i = 0; i < 40; ++i)
    run.advance(nobody);
  EXPECT_TRUE(PeriodTangent(run.equations, run.solution.state)
                .has_contact_between_periods());
}

// Numbers of mechanisms of pinned cells; macroscopic ones are no mechanisms of
// the period.
TEST(InfiniteLattice, MechanismsOfPinnedCells)
{
  struct Cell
  {
    std::string  name;
    unsigned int dimension, n_mechanisms;
  };
  const std::vector<Cell> cells = {{"square", 2, 0},
                                   {"triangular", 2, 0},
                                   {"double arrowhead", 2, 0},
                                   // Two primitive cells, with one each.
                                   {"kagome", 2, 2},
                                   {"pattern", 2, 1},
                                   {"star", 2, 6},
                                   {"octet", 3, 0},
                                   {"body-centred cubic", 3, 0},
                                   {"face-centred cubic", 3, 3},
                                   {"diamond", 3, 6},
                                   {"Kelvin", 3, 10},
                                   {"space star", 3, 18}};
  ComparisonTable table("Mechanisms of the period of pinned cells, besides "
                        "translations: rank of independent codes");
  for (const Cell &cell : cells)
    {
      SceneText scene = SceneText()
                          .dimension(cell.dimension)
                          .set("Analysis", "effective properties")
                          .set("Lattice/Cell", cell.name)
                          .hinge("pins", "all");
      if (cell.name == "pattern") // the primitive cell of the kagome lattice
        scene.add("Lattice",
                  "Joints = 0 0; 1 0; 0.5 0.86602540378443865 | "
                  "Struts = 0 1; 1 2; 2 0 | "
                  "Neighbour struts = across: 1 0 at 1 0; across: 2 0 at 0 1; "
                  "across: 1 2 at 1 -1 | Vector x = 2 0 | "
                  "Vector y = 1 1.7320508075688772");
      if (cell.dimension == 2)
        scene.rectangle("wall", 1, 0.0005, {1, "", 0.3});
      else
        scene.circle("wall", 0.0005, {1, "", 0.3});
      const Scene         read = read_scene_from_text(scene, "pinned.prm");
      LatticeRun          run(plan_of_unit_strains(read), MPI_COMM_WORLD);
      const PeriodTangent tangent(run.equations, run.solution.state);
      table.row(cell.name, tangent.n_mechanisms(), cell.n_mechanisms, 0);
    }
  const std::string error = input_error_of([] {
    effective_properties(
      read_scene_from_text(SceneText()
                             .set("Analysis", "effective properties")
                             .set("Lattice/Cell", "kagome")
                             .rectangle("wall", 1, 0.0005, {1, "", 0.3})
                             .hinge("pins", "all"),
                           "kagome.prm"),
      MPI_COMM_WORLD);
  });
  EXPECT_NE(error.find("2 mechanisms,"), std::string::npos) << error;
}
