#include <auxfem/output/recorder.h>
#include <auxfem/parameters/errors.h>

#include <analysis/simulation/expect_same.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A shallow toggle of two hinged bars (EA = 3, span 2, rise 0.3) with @p force
   * down on its apex, joint 1. It snaps through at 0.029 N.
   */
  SceneText toggle(const std::string &force, const std::string &time)
  {
    return frame_scene("0 0; 1 0.3; 2 0", "0 1; 1 2")
      .hinge("hinges", "all")
      .support("ends", "0, 2", "pin")
      .add("Loads/apex", "Joints = 1 | Force y = -(" + force + ")")
      .add("Time", time);
  }

  std::string error_of(SceneRun &run)
  {
    try
      {
        run.run();
      }
    catch (const ComputationError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(TimeStepper, TimesAreMultiplesOfTheStep)
{
  SceneRun run(cantilever("0.01 * t",
                          "Scheme = newmark | End time = 1 | Time step = 0.1"));
  EXPECT_EQ(run.scene.time.n_steps(), 10u);
  run.run([&run] {
    // A sum of ten times 0.1 would differ in the last digits.
    EXPECT_EQ(run.state.time, run.state.step * 0.1);
  });
  EXPECT_EQ(run.state.step, 10u);
  EXPECT_EQ(run.state.time, 1.);
}

TEST(TimeStepper, TheLastStepEndsAtTheEndTime)
{
  SceneRun run(
    cantilever("0.01 * t",
               "Scheme = newmark | End time = 1.05 | Time step = 0.1"));
  EXPECT_EQ(run.scene.time.n_steps(), 11u);
  std::vector<double> lengths;
  while (run.state.step < run.scene.time.n_steps())
    lengths.push_back(run.advance().dt);
  EXPECT_EQ(run.state.time, 1.05);
  for (unsigned int i = 0; i < 10; ++i)
    EXPECT_EQ(lengths[i], 0.1);
  EXPECT_NEAR(lengths[10], 0.05, 1e-15);
}

TEST(TimeStepper, RoundOffAddsNoStep)
{
  // 0.3 / 0.1 is a little below 3, 0.7 / 0.1 a little below 7, 0.6 / 0.2
  // below 3.
  for (const auto &[end, step, n] : {std::tuple("0.3", "0.1", 3u),
                                     std::tuple("0.7", "0.1", 7u),
                                     std::tuple("0.6", "0.2", 3u)})
    {
      SceneRun run(cantilever("0",
                              std::string("Scheme = static | End time = ") +
                                end + " | Time step = " + step));
      EXPECT_EQ(run.scene.time.n_steps(), n);
      run.run();
      EXPECT_EQ(run.state.time, std::stod(end));
    }
}

TEST(TimeStepper, ALinearSceneWithAConstantStepIsFactorizedOnce)
{
  // Motions too small for a comparison with exact ones.
  SceneRun run(
    cantilever("3e-5 * t",
               "Scheme = generalized-alpha | End time = 3 | Time step = 0.1"),
    {"Effects/Large rotation=off"});
  run.run();
  EXPECT_EQ(run.work().factorizations, 1u);
  EXPECT_EQ(run.work().iterations, 30u);
}

TEST(TimeStepper, LinearEquilibriaNeedOneSolutionPerStep)
{
  // Many rows have no forces, only the round-off of neighbouring rows.
  SceneRun run(
    SceneText()
      .cells("star", 3, 3)
      .set("Lattice/Strut length", 0.01)
      .rectangle("s", 4e-4, 4e-4, {70e9, 2700, 0.33})
      .connector("damper",
                 "kelvin-voigt",
                 "Spring stiffness = 200 | Damping coefficient = 0.05 | "
                 "Between = in-cell")
      .support("foot", "bottom", "clamp")
      .load("press", "top", {"0", "-1e-3 * min(t / 0.01, 1)", "0"})
      .mesh(2)
      .set("Effects/Large rotation", "off")
      .time(0.02, 1e-4, "static"));
  run.run();
  // The dashpots begin to yield under the load and its kink.
  EXPECT_LE(run.work().iterations, 240u);
  EXPECT_GE(run.work().iterations, 200u);
  EXPECT_LT(std::abs(run.state.energies.balance(0.)),
            1e-13 * run.state.largest_energy);
}

TEST(TimeStepper, AFailedStepIsRepeatedInParts)
{
  const std::string time = "Scheme = static | End time = 1 | Time step = 1";
  SceneRun          coarse(cantilever("2 * t", time),
                  {"Newton/Maximum iterations=4",
                            "Newton/Factorization=every iteration"});
  const StepReport  report = coarse.advance();
  EXPECT_GT(report.retries, 0u);
  EXPECT_GT(report.substeps, 1u);
  EXPECT_LT(report.dt, 1.);
  EXPECT_EQ(coarse.state.step, 1u);
  EXPECT_EQ(coarse.state.time, 1.);

  // The same equilibrium as in a hundred steps.
  SceneRun fine(cantilever("2 * t", time), {"Time/Time step=0.01"});
  fine.run();
  for (const unsigned int c : {0u, 1u, rotation_z})
    // Residuals of 1e-8 of the force, at flexibilities of about one.
    EXPECT_NEAR(coarse.motion(1, c), fine.motion(1, c), 1e-7);
}

TEST(TimeStepper, WorkOfADividedStepIsTheSumOfItsParts)
{
  // Few iterations divide some steps; the balance of a path linear in the load
  // stays exact.
  SceneRun run(
    cantilever("2 * t", "Scheme = static | End time = 1 | Time step = 0.25"),
    {"Newton/Maximum iterations=3", "Newton/Factorization=every iteration"});
  unsigned int substeps = 0;
  while (run.state.step < run.scene.time.n_steps())
    substeps += run.advance().substeps;
  EXPECT_GT(substeps, 4u);
  const Energies &energies = run.state.energies;
  // The work is integrated by the trapezoidal rule over some ten steps.
  EXPECT_NEAR(energies.strain(),
              energies.external(),
              0.01 * energies.external());
}

TEST(TimeStepper, AToggleIsFollowedToItsLimitLoadInEverSmallerSteps)
{
  // Von Mises truss: the largest force occurs at an inclination with cos^3 =
  // cos(at rest). Beyond it equilibrium exists only after the snap-through,
  // which a few iterations do not reach.
  const double cosine = 1 / std::sqrt(1.09), c = std::cbrt(cosine);
  const double limit = 2 * 3 * std::sqrt(1 - c * c) * (1 - cosine / c);
  SceneRun     run(toggle(std::to_string(2 * limit) + " * t",
                      "Scheme = static | End time = 1 | Time step = 0.15 | "
                          "Smallest time step = 1e-4"),
               {"Discretization/Order=1", "Newton/Maximum iterations=6"});
  unsigned int retries = 0;
  while (run.state.step < 3)
    retries += run.advance().retries;
  EXPECT_NEAR(run.state.time, 0.45, 1e-15);
  const std::string error = error_of(run);
  EXPECT_NE(error.find("Smallest time step"), std::string::npos) << error;
  EXPECT_NE(error.find("joint 1"), std::string::npos) << error;
  // It stops at the limit; the smallest step is 2e-4 of it.
  EXPECT_LE(run.state.time, 0.5);
  EXPECT_GE(run.state.time, 0.5 - 1e-3);
  EXPECT_GT(retries, 0u);
  EXPECT_GT(run.motion(1, 1), std::sqrt(1 / (c * c) - 1) - 0.3 - 1e-3);
}

TEST(TimeStepper, AfterAFailureTheStateIsTheLastAcceptedOne)
{
  // After t = 0.16 the force exceeds what five iterations reach. It is smooth,
  // as steps would end at a jump.
  const std::string text =
    cantilever("0.1 * t + 25 * (1 + tanh((t - 0.16) / "
               "1e-3))",
               "Scheme = static | End time = 1 | Time step = 0.1 | "
               "Smallest time step = 0.02");
  SceneRun run(text, {"Newton/Maximum iterations=5"});
  run.advance();
  EXPECT_EQ(run.state.step, 1u);
  const std::string error = error_of(run);
  EXPECT_NE(error.find("did not converge"), std::string::npos) << error;
  EXPECT_NE(error.find("joint 1"), std::string::npos) << error;

  // 0.2 fails, 0.15 succeeds, then 0.2 and 0.175 fail.
  EXPECT_EQ(run.state.step, 1u);
  EXPECT_NEAR(run.state.time, 0.15, 1e-15);
  SceneRun until_there(text,
                       {"Newton/Maximum iterations=5", "Time/End time=0.15"});
  until_there.run();
  for (const unsigned int c : {0u, 1u, rotation_z})
    EXPECT_NEAR(run.motion(1, c), until_there.motion(1, c), 1e-12);
  EXPECT_NEAR(run.state.energies.strain(),
              until_there.state.energies.strain(),
              1e-12);
}

TEST(TimeStepper, AFailedFirstStepLeavesTheStartUntouched)
{
  for (const char *scheme : {"static", "newmark", "generalized-alpha"})
    {
      SceneRun    run(cantilever("if(t > 0, 1e4, 0)",
                              std::string(
                                "End time = 10 | Time step = 10 | "
                                   "Smallest time step = 6 | Scheme = ") +
                                scheme),
                   {"Newton/Maximum iterations=2"});
      const State before = run.state;
      EXPECT_NE(error_of(run), "") << scheme;
      EXPECT_EQ(run.state.time, 0.);
      EXPECT_EQ(run.state.step, 0u);
      expect_same(run.state.displacement, before.displacement);
      expect_same(run.state.residual, before.residual);
      if (before.velocity)
        expect_same(*run.state.velocity, *before.velocity);
      if (before.acceleration)
        expect_same(*run.state.acceleration, *before.acceleration);
      EXPECT_EQ(run.state.history, before.history);
    }
}

TEST(TimeStepper, AStaticStartIsAnEquilibriumAtRest)
{
  SceneRun run(
    cantilever("0.3",
               "Scheme = newmark | End time = 1 | Time step = 0.05 | "
               "Start from = static equilibrium"));
  const double tip = run.motion(1, 1);
  EXPECT_GT(tip, 0.1);
  EXPECT_EQ(run.state.time, 0.);
  EXPECT_EQ(run.state.energies.external(), 0.);
  EXPECT_GT(run.state.energies.strain(), 0.);
  run.run([&] {
    // Residuals of 1e-8 of the force, with flexibilities of about one.
    EXPECT_NEAR(run.motion(1, 1), tip, 1e-7);
    EXPECT_NEAR(run.balance(), 0., 1e-8);
  });
}

TEST(TimeStepper, ASmoothMotionKeepsItsEnergy)
{
  // Average acceleration with small steps, large rotations and a viscous
  // connector: work = energy + losses to second order.
  const auto largest_error = [](const std::string &step) {
    SceneRun run(
      cantilever("0.4 * sin(t)^2",
                 "Scheme = newmark | End time = 4 | Time step = " + step)
        .connector("damper",
                   "maxwell",
                   "Spring stiffness = 0.3 | "
                   "Damping coefficient = 0.2 | Between = ground: 1 | "
                   "Ground offset = 0 1"),
      {"Sections/band/Stiffness-proportional damping=0.1",
       "Sections/band/Mass-proportional damping=0.2"});
    double largest = 0;
    run.run([&] { largest = std::max(largest, std::abs(run.balance())); });
    EXPECT_GT(run.state.energies.dissipated(), 0.01);
    return largest;
  };
  const double coarse = largest_error("0.02"), fine = largest_error("0.01");
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.3);
}

namespace
{
  /**
   * Runs the scene with computed and with predicted residuals of stages, and
   * calls take(estimates, recorder) for each.
   */
  template <class Take>
  void run_with_and_without_estimates(const SceneText &text,
                                      const MPI_Comm   communicator,
                                      const Take      &take)
  {
    for (const bool estimates : {false, true})
      {
        Scene scene = read_scene_from_text(text, "test.prm");
        ASSERT_TRUE(scene.newton.estimates_stages);
        scene.newton.estimates_stages = estimates;
        MemoryRecorder recorder(scene, communicator);
        LatticeRun(scene, communicator).run(recorder);
        take(estimates, recorder);
      }
  }
} // namespace

TEST(TimeStepper, ResidualsOfStagesAreComputedInContact)
{
  // A cantilever permanently pressed on a plate.
  const SceneText text =
    SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("rod", 0.02, 0.02, {1e7, 1000, 0})
      .support("foot", "0", "clamp")
      .load("press", "1", {"0", "-0.002 - 0.001 * sin(20 * t)", "0"})
      .mesh(3)
      .probe("tip", "1")
      .add("Plates/floor",
           "Shape = plane | Normal = 0 1 | Position = 0 -0.0101")
      .time(1, 0.02, "esdirk")
      .set("Time/Start from", "static equilibrium")
      .set("Time/Relative tolerance", 1e-4)
      // About thirty iterations lead from above the plate to its face.
      .set("Newton/Maximum iterations", 60)
      .set("Newton/Tolerance", 1e-4);
  std::array<std::vector<std::vector<double>>, 2> rows;
  run_with_and_without_estimates(text,
                                 MPI_COMM_SELF,
                                 [&rows](const bool            estimates,
                                         const MemoryRecorder &recorder) {
                                   rows[estimates] = recorder.rows();
                                 });
  EXPECT_GT(rows[false].size(), 0u);
  EXPECT_EQ(rows[false], rows[true]);
}

TEST(TimeStepper, PredictedStageResidualsDoNotChangeResults)
{
  const SceneText text =
    cantilever("0.4 * sin(t)^2",
               "Scheme = esdirk | End time = 4 | Time step = 0.2 | "
               "Relative tolerance = 1e-6")
      .connector("damper",
                 "maxwell",
                 "Spring stiffness = 0.3 | Damping coefficient = 0.2 | "
                 "Between = ground: 1 | Ground offset = 0 1")
      .set("Sections/band/Stiffness-proportional damping", 0.1)
      .probe("tip", "1");
  std::array<std::map<std::string, std::vector<double>>, 2> columns;
  run_with_and_without_estimates(
    text,
    MPI_COMM_WORLD,
    [&columns](const bool estimates, const MemoryRecorder &recorder) {
      for (const char *const name :
           {"tip.uy", "damper.force", "dissipated", "external", "strain"})
        columns[estimates][name] = recorder.column(name);
    });
  for (const auto &[name, computed] : columns[false])
    {
      const std::vector<double> &estimated = columns[true].at(name);
      double                     largest   = 0;
      for (const double value : computed)
        largest = std::max(largest, std::abs(value));
      ASSERT_EQ(computed.size(), estimated.size());
      for (std::size_t i = 0; i < computed.size(); ++i)
        EXPECT_NEAR(estimated[i], computed[i], 1e-8 * largest) << name;
    }
}
