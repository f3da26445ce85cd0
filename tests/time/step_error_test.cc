#include <auxfem/output/recorder.h>

#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <verification/one_mass_scene.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A free mass on a spring, u = sin(omega t), of three periods: step errors add
// up to a phase error. An arm rotated at a fixed joint: only rotations count.

namespace
{
  const double omega = 10, end = 3 * 2 * dealii::numbers::PI / omega;

  SceneText oscillator(const std::string &scheme)
  {
    return one_mass_scene("Law = spring | Spring stiffness = 100",
                          "End time = " + text(end) +
                            " | Time step = " + text(end / 6),
                          mass_and_velocity(1, omega))
      .set("Time/Scheme", scheme)
      .probe("mass", "0");
  }

  struct Outcome
  {
    double    error = 0; ///< largest
    RunResult result;
  };

  /** Rotated by an end moment about @p axis that has a kink. */
  SceneText turned_arm(const unsigned int dimension,
                       const std::string &axis,
                       const std::string &scheme)
  {
    SceneText scene;
    scene.dimension(dimension).set("Lattice/Cell", "frame");
    scene.set("Lattice/Joints", dimension == 2 ? "0 0; 1 0" : "0 0 0; 1 0 0");
    scene.set("Lattice/Struts", "0 1");
    scene.circle("rod", 0.02, {1e9, 1000, 0.3});
    scene.set("Sections/rod/Stiffness-proportional damping", "1 ms");
    scene.support("clamp", "0", "clamp").support("pin", "1", "pin");
    scene.set("Loads/moment/Joints", "1");
    scene.set("Loads/moment/Moment " + axis, "20 * min(t / 0.05, 1)");
    return scene.mesh(2).time(0.1, 0.0125, scheme).probe("arm", "1");
  }

  /** Rotations at steps. */
  std::vector<double> rotations(const SceneText                &scene,
                                const std::string              &column,
                                const std::vector<std::string> &overrides)
  {
    const Scene    read = read_scene_from_text(scene, "test.prm", overrides);
    MemoryRecorder recorder(read, MPI_COMM_WORLD);
    LatticeRun(read, MPI_COMM_WORLD).run(recorder);
    return recorder.column("arm." + column);
  }

  constexpr unsigned int parts = 128;

  /** Rotations of turned_arm() with steps of 1/128, to ten digits. */
  std::vector<double> fine_rotations(const unsigned int dimension,
                                     const std::string &axis,
                                     const std::string &column)
  {
    return rotations(
      turned_arm(dimension, axis, "esdirk").set("Newton/Tolerance", "1e-11"),
      column,
      {"Time/Time step=" + text(0.0125 / parts)});
  }

  /** Largest difference to @p fine, over the largest rotation. */
  double error_of_rotations(const std::vector<double> &found,
                            const std::vector<double> &fine)
  {
    EXPECT_EQ(parts * (found.size() - 1) + 1, fine.size());
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
      {
        const double exact = fine.at(parts * i);
        error              = std::max(error, std::abs(found[i] - exact));
        largest            = std::max(largest, std::abs(exact));
      }
    EXPECT_GT(largest, 0.01);
    return error / largest;
  }

  Outcome run(const std::string              &scene,
              const std::vector<std::string> &overrides)
  {
    const Scene    read = read_scene_from_text(scene, "test.prm", overrides);
    MemoryRecorder recorder(read, MPI_COMM_WORLD);
    Outcome        outcome;
    outcome.result   = LatticeRun(read, MPI_COMM_WORLD).run(recorder);
    const auto times = recorder.column("time"), u = recorder.column("mass.ux");
    for (std::size_t i = 0; i < times.size(); ++i)
      outcome.error =
        std::max(outcome.error, std::abs(u[i] - std::sin(omega * times[i])));
    return outcome;
  }

  /** Numbers of parts in @p n steps of the scene. */
  std::vector<double> parts_of_steps(SceneRun &run, const unsigned int n)
  {
    std::vector<double> parts;
    for (unsigned int i = 0; i < n; ++i)
      parts.push_back(run.advance().substeps);
    return parts;
  }

  /** Expects an oscillator to meet the tolerance. */
  void expect_met(const SceneText &scene, const double tolerance)
  {
    const Outcome outcome = run(scene.str(),
                                {"Time/Relative tolerance=" + text(tolerance),
                                 "Time/Smallest time step=2e-6"});
    // Without damping no error decays, the worst case. Steps become longer
    // where the error hardly grows.
    EXPECT_LT(outcome.error, 2.2 * tolerance) << scene.str() << tolerance;
    // Half the step has a quarter of the error; the controller has a safety
    // margin.
    EXPECT_GT(outcome.error, tolerance / 25) << scene.str() << tolerance;
    EXPECT_EQ(verdict_of(outcome.result.findings), Verdict::sound);
  }
} // namespace

TEST(StepError, TolerancesAreMetByAnUndampedOscillator)
{
  for (const char *const scheme : {"newmark", "hht", "generalized-alpha"})
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
      expect_met(oscillator(scheme), tolerance);
}

TEST(StepError, TolerancesAreMetByLongStepsOfAnUndampedOscillator)
{
  // The first step is half an oscillation.
  for (const char *const order : {"3", "4"})
    for (const double tolerance : {1e-1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-5})
      expect_met(oscillator("esdirk").set("Time/Order of esdirk", order),
                 tolerance);
}

TEST(StepError, StepsOfAFreeOscillationAreEqual)
{
  SceneRun run(oscillator("newmark")
                 .set("Time/Relative tolerance", "1e-5")
                 .set("Time/Smallest time step", "1e-6")
                 .str());

  const std::vector<double> n_steps = parts_of_steps(run, 6);
  for (const double n : n_steps)
    {
      EXPECT_GT(n, 0.5 * n_steps[1]);
      EXPECT_LT(n, 1.1 * n_steps[1]);
    }
}

TEST(StepError, EstimateMatchesTheError)
{
  for (const char *const scheme : {"newmark", "hht", "generalized-alpha"})
    {
      const Outcome outcome =
        run(oscillator(scheme), {"Time/Relative tolerance=1e-3"});
      ASSERT_TRUE(outcome.result.time_error.has_value());
      const double estimate = *outcome.result.time_error;
      EXPECT_GT(estimate, 0.4 * outcome.error) << scheme;
      EXPECT_LT(estimate, 2.5 * outcome.error) << scheme;
      EXPECT_LT(estimate, 1e-3) << scheme;
    }
}

TEST(StepError, WithoutAToleranceThereIsNoEstimate)
{
  EXPECT_FALSE(run(oscillator("newmark"), {}).result.time_error.has_value());
}

TEST(StepError, ToleranceThatCannotBeMetMakesResultsDoubtful)
{
  const Outcome outcome =
    run(oscillator("newmark"),
        {"Time/Relative tolerance=1e-4", "Time/Smallest time step=0.05"});
  EXPECT_TRUE(outcome.result.completed());
  ASSERT_EQ(outcome.result.findings.size(), 1u);
  EXPECT_EQ(outcome.result.findings[0].verdict, Verdict::doubtful);
  EXPECT_TRUE(contains(outcome.result.findings[0].text, "Relative tolerance"));
  EXPECT_GT(outcome.error, 1e-3);
}

TEST(StepError, WarnsOfDisplacementsBelowTheAbsoluteTolerance)
{
  const Outcome outcome =
    run(oscillator("newmark"),
        {"Time/Relative tolerance=1e-3", "Time/Absolute tolerance=1 m"});
  ASSERT_EQ(outcome.result.findings.size(), 1u);
  EXPECT_TRUE(contains(outcome.result.findings[0].text,
                       "Set Time/Absolute tolerance to 0.000"));
}

TEST(StepError, SchemesWithoutAnEstimateAreRefused)
{
  const auto refusal = [](const std::vector<std::string> &overrides) {
    std::vector<std::string> all = {"Time/Relative tolerance=1e-3"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return input_error_of(
      [&]() { read_scene_from_text(oscillator("newmark"), "test.prm", all); });
  };
  EXPECT_EQ(refusal({}), "");
  for (const std::vector<std::string> &scheme :
       {std::vector<std::string>{"Time/Scheme=energy-momentum"},
        {"Time/Scheme=newmark",
         "Time/Newmark gamma=0.6",
         "Time/Newmark beta=0.31"}})
    expect_parts(refusal(scheme), {"Time/Relative tolerance", "no estimate"});
}

TEST(StepError, TolerancesAreMetByRotationsInThePlane)
{
  const std::vector<double> fine = fine_rotations(2, "z", "phi");
  for (const char *const scheme : {"newmark", "esdirk"})
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5})
      {
        // Displacements have no tolerance that matters.
        const std::vector<std::string> overrides = {
          "Time/Relative tolerance=" + text(tolerance),
          "Time/Absolute tolerance=1 m",
          "Time/Smallest time step=1e-7"};
        const auto error = [&](const std::string &rotation_tolerance) {
          std::vector<std::string> all = overrides;
          all.push_back("Time/Absolute tolerance of rotations=" +
                        rotation_tolerance);
          return error_of_rotations(rotations(turned_arm(2, "z", scheme),
                                              "phi",
                                              all),
                                    fine);
        };
        const double met = error(text(tolerance / 100));
        EXPECT_LT(met, tolerance) << scheme;
        EXPECT_GT(met, tolerance / 500) << scheme << ' ' << tolerance;
        // With a loose tolerance of rotations steps are not divided.
        EXPECT_GT(error("1"), 1.5 * met) << scheme << ' ' << tolerance;
      }
}

TEST(StepError, TolerancesAreMetByTorsionInSpaceWithoutDisplacements)
{
  const std::vector<double> fine = fine_rotations(3, "x", "phi_x");
  for (const char *const scheme : {"newmark", "esdirk"})
    for (const double tolerance : {1e-3, 1e-4, 1e-5})
      {
        const double error =
          error_of_rotations(rotations(turned_arm(3, "x", scheme),
                                       "phi_x",
                                       {"Time/Relative tolerance=" +
                                          text(tolerance),
                                        "Time/Smallest time step=1e-7"}),
                             fine);
        EXPECT_LT(error, tolerance) << scheme;
        EXPECT_GT(error, tolerance / 1000) << scheme << ' ' << tolerance;
      }
}
