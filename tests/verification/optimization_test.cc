#include <auxfem/optimization/optimization.h>
#include <auxfem/parameters/text.h>

#include <verification/cell_reference.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <support/pi.h>

// Best designs of one mass and of the rigid cell, whose optima are known, a fit
// that recovers known values, and derivatives.

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** The optimization in summary.json of the scene @p text. */
  Json optimum_of(const std::string &text, const std::string &name)
  {
    const std::string folder = "optimization-" + name;
    std::filesystem::remove_all(folder);
    const Scene scene =
      read_scene_from_text(text, "design.prm", {"Output/Directory=" + folder});
    testing::internal::CaptureStdout();
    run_optimization(scene, MPI_COMM_SELF, {});
    testing::internal::GetCapturedStdout();
    std::ifstream stream(folder + "/summary.json");
    return Json::parse(stream).at("optimization");
  }

  double variable(const Json &found, const std::string &path)
  {
    return found.at("best").at("variables").at(path);
  }

  double result(const Json &found, const std::string &name)
  {
    return found.at("best").at("results").at(name);
  }

  const std::string link_stiffness = "Connectors/link/Spring stiffness",
                    link_damping   = "Connectors/link/Damping coefficient";

  /** A mass of 1 kg at 1 m/s on a spring and a damper. */
  SceneText falling_mass(const std::string &k, const std::string &c)
  {
    return one_mass_scene("Law = kelvin-voigt | Spring stiffness = " + k +
                            " | Damping coefficient = " + c,
                          "Scheme = newmark | End time = 4 | Time step = 4e-3",
                          mass_and_velocity(1, -1)
                            .set("Quantities/force", "maximum of link.force")
                            .set("Quantities/stroke",
                                 "maximum of link.extension")
                            .set("Optimization/Objective", "minimize force")
                            .set("Optimization/Tolerance", "1e-6")
                            .set("Optimization/Sensitivities", "false"));
  }

  const std::string cell_stiffness = "Connectors/connector/Spring stiffness",
                    cell_damping   = "Connectors/connector/Damping coefficient";

  /** The cell with bounds 5 to 40 kN/m and 10 to 200 N s/m. */
  std::string designed_cell(const CellCase &c, const std::string &optimization)
  {
    return cell_text(c) +
      "subsection Quantities\n set peak = maximum of f2\n"
      " set travel = minimum of Y1\n set last = f2 at end\nend\n"
      "subsection Design variables\n set " +
      cell_stiffness + " = 5e3:4e4\n set " + cell_damping +
      " = 10:200\nend\nsubsection Optimization\n" + optimization + "end\n";
  }

  const std::string least_peak =
    " set Objective = minimize peak\n set Tolerance = 1e-6\n"
    " set Sensitivities = false\n";
} // namespace

// D. M. W. Peters, SIAM Review 39 (1997): with the stroke given, zeta is the
// root of cos(4 z sqrt(1 - z^2)) = -1 + 8 z^2 - 8 z^4.
TEST(OptimalDesigns, OneMassOnASpringAndADamper)
{
  ComparisonTable table(
    "Least force on a mass of 1 kg at 1 m/s on a spring and a damper");
  const Json damped =
    optimum_of(falling_mass("1", "1").set("Design variables/" + link_damping,
                                          "0.1:2"),
               "damper");
  table.row("spring given: force", result(damped, "force"), 0.81012475, 1e-5);
  table.row("spring given: damping",
            variable(damped, link_damping),
            2 * 0.26493208,
            1e-3);
  const Json both =
    optimum_of(falling_mass("1", "0.2")
                 .set("Design variables/" + link_stiffness, "0.1:2")
                 .set("Design variables/" + link_damping, "0.05:2")
                 .set("Optimization/Constraints", "stroke <= 1"),
               "stroke");
  table.row("stroke given: force", result(both, "force"), 0.52059862, 1e-5);
  table.row("stroke given: stiffness",
            variable(both, link_stiffness),
            0.36057021,
            2e-3);
  table.row("stroke given: damping",
            variable(both, link_damping),
            0.48515107,
            2e-3);
}

// References: other optimizers on an adaptive integrator of the same equations.
// With a rising load the peak is the value at the end.
TEST(OptimalDesigns, TheRigidCellHasTheLeastForceOnItsFoundation)
{
  ComparisonTable table("Rigid cell: least peak of f2 (N) over K and C");
  const auto      row = [&table](const std::string &name,
                            const Json        &found,
                            const double       K,
                            const double       C,
                            const double       peak) {
    table.relative(name + ", K (N/m)",
                   variable(found, cell_stiffness),
                   K,
                   5e-4);
    table.relative(name + ", C (N s/m)",
                   variable(found, cell_damping),
                   C,
                   5e-4);
    table.relative(name + ", peak (N)", result(found, "peak"), peak, 1e-6);
  };
  row("case 1",
      optimum_of(designed_cell(table_case(1), least_peak), "case-1"),
      5000,
      10,
      1963.3059);
  row("case 1 within 0.1 m",
      optimum_of(designed_cell(table_case(1),
                               least_peak +
                                 " set Constraints = travel >= -0.1\n"),
                 "stroke-1"),
      7806.6016,
      200,
      2319.6979);
  row("case 4",
      optimum_of(designed_cell(table_case(4), least_peak + " set Starts = 4\n"),
                 "case-4"),
      10326.81,
      10,
      2317.9207);
}

TEST(OptimalDesigns, AFitRecoversTheConnector)
{
  CellCase known  = table_case(1);
  known.stiffness = 17300;
  known.damping   = 86;
  known.n_steps   = 100;
  const auto rows =
    CellReference(known, [](const double t) { return 2e7 * t * t * t; }).rows();
  {
    std::ofstream file("measured-force.csv");
    file.precision(12);
    file << "time,force\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
      file << known.end / known.n_steps * i << ',' << rows[i].f2 << '\n';
  }
  CellCase start  = known;
  start.stiffness = 1e4;
  start.damping   = 100;
  std::string text =
    designed_cell(start,
                  " set Objective = minimize misfit\n set Tolerance = 1e-7\n"
                  " set Sensitivities = false\n");
  const std::string last = " set last = f2 at end\n";
  text.replace(text.find(last),
               last.size(),
               last +
                 " set misfit = mean square deviation of f2 from table: "
                 "measured-force.csv\n");
  const Json      found = optimum_of(text, "fit");
  ComparisonTable table("Rigid cell: connector fitted to a computed force");
  table.relative("K (N/m)", variable(found, cell_stiffness), 17300, 1e-4);
  table.relative("C (N s/m)", variable(found, cell_damping), 86, 1e-4);
}

// References: complex steps in the equations.
TEST(OptimalDesigns, SensitivitiesAreDerivativesWithTheirErrors)
{
  ComparisonTable table(
    "Rigid cell: derivatives of f2 at 50 ms by K and C, differences");
  const auto row =
    [&table](const unsigned int n, const double by_K, const double by_C) {
      const Json found =
        optimum_of(designed_cell(table_case(n),
                                 " set Objective = minimize last\n"
                                 " set Evaluations = 1\n"),
                   "derivatives-" + std::to_string(n));
      const Json &sensitivities = found.at("sensitivities");
      for (const auto &[path, value] : {std::make_pair(cell_stiffness, by_K),
                                        std::make_pair(cell_damping, by_C)})
        {
          const Json  &one   = sensitivities.at(path).at("last");
          const double error = one.at("error");
          EXPECT_LT(error, 2e-3 * std::abs(value));
          EXPECT_GT(error, 0);
          table.relative("case " + std::to_string(n) + ", " +
                           (path == cell_damping ? "by C" : "by K"),
                         one.at("derivative"),
                         value,
                         1e-6);
        }
    };
  row(1, 5.5114954e-3, 0.15368724);
  row(4, 1.9753444e-3, -0.74308743);
}

// The band gap of stars widens with the walls, which the density limits to 0.05
// of their length; reference: exact dynamic stiffness at this height.
TEST(OptimalDesigns, TheWidestBandGapOfAStarAtADensity)
{
  const std::string gap = "bands.9.lowest_hertz - bands.8.highest_hertz";
  SceneText         scene;
  scene.set("Analysis", "dispersion")
    .add("Lattice", "Cell = star | Strut length = 1 | Opening angle = 60 deg")
    .rectangle("wall", 1, 0.03, {1, 1, 0.3})
    .set("Effects/Shear flexibility", "on")
    .set("Dispersion/Bands", 9)
    .set("Dispersion/Points", 4)
    .set("Dispersion/Zone points", 0)
    .set("Design variables/Sections/wall/Height", "0.02:0.1")
    .set("Optimization/Objective", "maximize " + gap)
    .set("Optimization/Constraints",
         "relative_density <= 0.6 / (1 + sqrt(3))^2")
    .set("Optimization/Tolerance", "1e-6")
    .set("Optimization/Sensitivities", "false");
  const Json      found = optimum_of(scene.mesh(5), "band-gap");
  ComparisonTable table("Widest band gap of the star lattice at a density");
  const double    first = 0.142455469 / (2 * pi);
  table.relative("height (m)",
                 variable(found, "Sections/wall/Height"),
                 0.05,
                 1e-5);
  table.relative("gap (Hz)",
                 result(found, gap),
                 (1.2879886 - 0.54454226) * first,
                 2e-4);
}
