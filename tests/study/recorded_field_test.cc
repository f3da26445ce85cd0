#include <auxfem/study/measured_run.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <study/swinging_beam.h>

#include <cmath>
#include <numeric>

#include <nlohmann/json.hpp>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double end = 0.1;

  /** Energies of struts are those of the whole scene. Every rank needs a strut.
   */
  SceneText beams(const unsigned int dimension, const std::string &scheme)
  {
    SceneText scene = swinging_beam(end, 10);
    scene.frame(dimension == 2 ? "0 0; 0.6 0; 1 0.2; 1 0.5"
                               : "0 0 0; 0.6 0 0; 1 0.2 0; 1 0.5 0.3",
                "0 1; 1 2; 2 3");
    scene.dimension(dimension).set("Loads/push/Joints", "3");
    if (dimension == 3)
      scene.set("Loads/push/Force z", "300 * t^2");
    scene.set("Effects/Rotary inertia", "off").mesh(3, 1);
    return scene.set("Time/Scheme", scheme);
  }

  MeasuredRun run_of(const SceneText &scene)
  {
    return measure_run(read_scene_from_text(scene, "test.prm"),
                       MPI_COMM_WORLD,
                       {{"strain", "kinetic"}, {end / 2, end}},
                       [](double) {});
  }

  double energy(const std::vector<double> &roots)
  {
    return std::inner_product(roots.begin(), roots.end(), roots.begin(), 0.);
  }

  double energy(const RecordedField &field, const bool with_velocities)
  {
    return energy(
      energy_roots(field, integration_points(field), with_velocities));
  }

  /** Compares energies at the middle and the end with history.csv. */
  void expect_energies_of_history(const MeasuredRun &run)
  {
    ASSERT_TRUE(run.completed()) << run.exit_state;
    ASSERT_EQ(run.fields.size(), 2u);
    std::size_t row = 5;
    for (const auto &[time, field] : run.fields)
      {
        const double strain  = run.columns.at("strain").at(row),
                     kinetic = run.columns.count("kinetic") > 0
          ? run.columns.at("kinetic").at(row)
          : 0;
        EXPECT_GT(strain, 0);
        EXPECT_NEAR(energy(field, false) / strain, 1, 1e-12) << time;
        EXPECT_NEAR(energy(field, true) / (strain + kinetic), 1, 1e-12) << time;
        row += 5;
      }
  }
} // namespace

TEST(RecordedField, HasTheEnergiesOfThePlanarRun)
{
  expect_energies_of_history(run_of(beams(2, "newmark")));
}

TEST(RecordedField, HasTheEnergiesOfTheRunInSpace)
{
  expect_energies_of_history(run_of(beams(3, "generalized-alpha")));
}

TEST(RecordedField, HasTheEnergiesAtSmallDisplacements)
{
  for (const unsigned int dimension : {2, 3})
    expect_energies_of_history(
      run_of(beams(dimension, "newmark").set("Effects/Large rotation", "off")));
}

TEST(RecordedField, HasNoKineticEnergyInStatics)
{
  const MeasuredRun run = run_of(beams(2, "static"));
  expect_energies_of_history(run);
}

TEST(RecordedField, IsReadAsItWasWritten)
{
  const MeasuredRun run  = run_of(beams(3, "newmark")),
                    read = measured_run_of(Json::parse(json_of(run).dump()));
  ASSERT_EQ(read.fields.size(), run.fields.size());
  for (const auto &[time, field] : run.fields)
    {
      const auto points = integration_points(field);
      EXPECT_EQ(energy_roots(field, points, true),
                energy_roots(read.fields.at(time), points, true));
    }
}

// The halves of an element have the polynomials of the whole element.
TEST(RecordedField, IsTheSameAtPointsOfAFinerOne)
{
  const MeasuredRun run   = run_of(beams(2, "newmark"));
  const MeasuredRun fine  = run_of(beams(2, "newmark").mesh(3, 2));
  const auto        roots = energy_roots(run.fields.at(end),
                                  integration_points(fine.fields.at(end)),
                                  true);
  EXPECT_NEAR(energy(roots) / energy(run.fields.at(end), true), 1, 1e-12);
}

TEST(RecordedField, IsRecordedOnlyIfSelected)
{
  const MeasuredRun run =
    measure_run(read_scene_from_text(beams(2, "newmark"), "test.prm"),
                MPI_COMM_WORLD,
                {{"strain"}, {}},
                [](double) {});
  EXPECT_TRUE(run.fields.empty());
  EXPECT_TRUE(run.has({{"strain"}, {}}));
  EXPECT_FALSE(run.has({{"strain"}, {end}}));
  EXPECT_FALSE(run.has({{"kinetic"}, {}}));
}
