#include <auxfem/output/recorder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/simulation.h>

#include <gtest/gtest.h>
#include <verification/one_mass_scene.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * Mass of 1 kg on a spring of 4 N/m with initial velocity 1 m/s: u = sin(2 t)
   * / 2.
   */
  const std::string thrown_mass =
    one_mass_scene("Law = spring | Spring stiffness = 4",
                   "End time = 1 | Time step = 1 ms",
                   mass_and_velocity(1, 1).set("Output/History interval", 100));
} // namespace

TEST(MemoryRecorder, KeepsARowForEachStepAndWritesNothing)
{
  const Scene     scene = read_scene_from_text(thrown_mass, "test.prm");
  MemoryRecorder  history(scene, MPI_COMM_SELF);
  const RunResult result = run(scene, MPI_COMM_SELF, history);
  EXPECT_TRUE(result.completed());
  EXPECT_EQ(result.work.steps, 1000u);

  const std::vector<double> time    = history.column("time"),
                            kinetic = history.column("kinetic");
  ASSERT_EQ(time.size(), 1001u);
  EXPECT_EQ(time.front(), 0.);
  EXPECT_EQ(time.back(), 1.);
  for (const std::vector<double> &row : history.rows())
    ASSERT_EQ(row.size(), history.columns().size());
  // The period error of the trapezoidal rule, (omega dt)^2 / 12 of the phase.
  for (const unsigned int i : {0u, 250u, 1000u})
    EXPECT_NEAR(kinetic[i], std::pow(std::cos(2 * time[i]), 2) / 2, 1e-6);
}

TEST(MemoryRecorder, RejectsMissingColumns)
{
  const Scene    scene = read_scene_from_text(thrown_mass, "test.prm");
  MemoryRecorder history(scene, MPI_COMM_SELF);
  run(scene, MPI_COMM_SELF, history);
  EXPECT_THROW(history.column("no such"), InputError);
}
