#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/parameters/errors.h>

#include <analysis/simulation/expect_same.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/run_program.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Writes down what it is told. */
  struct Diary : public Recorder
  {
    void begin(const Equations &equations) override
    {
      calls.push_back("begin");
      n_unknowns = equations.model().numbering.layout().n_global();
    }

    void start(const Solution &solution) override
    {
      calls.push_back("start");
      times.push_back(solution.state.time);
    }

    void step(const Solution &solution, const StepReport &report) override
    {
      calls.push_back("step");
      times.push_back(solution.state.time);
      iterations += report.iterations;
      latest = solution.state.displacement;
    }

    void finish(const Solution &last, const RunResult &run_result) override
    {
      calls.push_back("finish");
      times.push_back(last.state.time);
      final  = last.state.displacement;
      result = run_result;
    }

    std::vector<std::string> calls;
    std::vector<double>      times;
    unsigned int             n_unknowns = 0;
    unsigned long            iterations = 0;
    /** Displacements of the last step and of finish(). */
    std::optional<Vector> latest, final;
    RunResult             result;
  };

  /** The calls of a run of @p n_steps steps. */
  std::vector<std::string> calls_of(const unsigned int n_steps)
  {
    std::vector<std::string> calls = {"begin", "start"};
    calls.insert(calls.end(), n_steps, "step");
    calls.push_back("finish");
    return calls;
  }

  /** The message of the ComputationError of a run; empty if there is none. */
  std::string failure_of(const std::string              &text,
                         const std::vector<std::string> &overrides,
                         Diary                          &diary)
  {
    const Scene scene = read_scene_from_text(text, "test.prm", overrides);
    LatticeRun  run(scene, MPI_COMM_SELF);
    try
      {
        run.run(diary);
      }
    catch (const ComputationError &error)
      {
        return error.what();
      }
    return "";
  }

  const std::string ten_steps =
    "Scheme = newmark | End time = 1 | Time step = 0.1";
} // namespace

TEST(LatticeRun, TellsItsRecorderInOrder)
{
  const Scene scene =
    read_scene_from_text(cantilever("0.3 * t", ten_steps), "test.prm", {});
  LatticeRun      run(scene, MPI_COMM_SELF);
  Diary           diary;
  const RunResult result = run.run(diary);

  EXPECT_EQ(diary.calls, calls_of(10));
  EXPECT_EQ(diary.n_unknowns, run.model.numbering.layout().n_global());
  ASSERT_EQ(diary.times.size(), 12u);
  for (unsigned int i = 0; i <= 10; ++i)
    EXPECT_EQ(diary.times[i], i * 0.1);
  EXPECT_EQ(diary.times.back(), 1.);
  ASSERT_TRUE(diary.latest && diary.final);
  expect_same(*diary.latest, *diary.final);

  EXPECT_TRUE(result.completed());
  EXPECT_EQ(result.exit_state, "completed");
  EXPECT_EQ(result.time, 1.);
  EXPECT_EQ(result.work.steps, 10u);
  EXPECT_EQ(result.work.iterations, diary.iterations);
  EXPECT_GE(result.work.factorizations, 1u);
  // The recorder is told the same.
  EXPECT_EQ(diary.result.exit_state, result.exit_state);
  EXPECT_EQ(diary.result.time, result.time);
  EXPECT_EQ(diary.result.work.iterations, result.work.iterations);
  EXPECT_EQ(diary.result.work.factorizations, result.work.factorizations);
}

TEST(LatticeRun, WorkOfTheStartCounts)
{
  const auto work = [](const std::vector<std::string> &overrides) {
    const Scene scene =
      read_scene_from_text(cantilever("0.3", ten_steps), "test.prm", overrides);
    LatticeRun run(scene, MPI_COMM_SELF);
    run.start();
    EXPECT_EQ(run.work().steps, 0u);
    return run.work();
  };
  const std::string linear            = "Effects/Large rotation=off",
                    equilibrium       = "Time/Start from=static equilibrium",
                    no_rotary_inertia = "Effects/Rotary inertia=off";
  // Conjugate gradients find the accelerations from the mass matrix.
  EXPECT_EQ(work({linear}).factorizations, 0u);
  EXPECT_EQ(work({linear}).iterations, 0u);
  // One matrix for the equilibrium of a linear scene.
  EXPECT_EQ(work({linear, equilibrium}).factorizations, 1u);
  EXPECT_EQ(work({linear, equilibrium}).iterations, 1u);
  // And one for what stands in for a singular mass matrix.
  EXPECT_EQ(work({linear, no_rotary_inertia}).factorizations, 1u);
  EXPECT_EQ(work({linear, equilibrium, no_rotary_inertia}).factorizations, 2u);
}

TEST(LatticeRun, AWholeRunCountsTheStartsWorkToo)
{
  const auto factorizations = [](const std::string &start_from) {
    // Too little for its motion to be compared with the exact one.
    const Scene scene =
      read_scene_from_text(cantilever("3e-5 + 1e-4 * t", ten_steps),
                           "test.prm",
                           {"Effects/Large rotation=off",
                            "Time/Start from=" + start_from});
    Diary diary;
    return LatticeRun(scene, MPI_COMM_SELF).run(diary).work.factorizations;
  };
  EXPECT_EQ(factorizations("rest"), 1u) << "all steps share one";
  // The check for mechanisms has another, with which the equilibrium is found.
  EXPECT_EQ(factorizations("static equilibrium"), 2u);
}

TEST(LatticeRun, AFailureLeavesTheLastAcceptedSolutionAndTheReason)
{
  Diary             diary;
  const std::string failure = failure_of(data_text("overload.prm"), {}, diary);
  EXPECT_TRUE(contains(failure, "did not converge")) << failure;
  EXPECT_EQ(diary.result.exit_state, failure);
  EXPECT_FALSE(diary.result.completed());

  const unsigned int n_steps = diary.result.work.steps;
  EXPECT_GT(n_steps, 5u);
  EXPECT_EQ(diary.calls, calls_of(n_steps));
  // Parts of the step that failed were accepted.
  EXPECT_GE(diary.times.back(), diary.times[n_steps]);
  EXPECT_LT(diary.times.back(), diary.times[n_steps] + 0.02);
  EXPECT_EQ(diary.result.time, diary.times.back());
  EXPECT_GE(diary.result.work.iterations, diary.iterations);

  // The last solution is that of a run that ends there.
  Diary until_there;
  ASSERT_EQ(failure_of(data_text("overload.prm"),
                       {"Time/End time=" + std::to_string(diary.times.back()) +
                        " s"},
                       until_there),
            "");
  ASSERT_TRUE(diary.final && until_there.final);
  for (unsigned int i = 0; i < diary.final->size(); ++i)
    // Residuals of 1e-8 near a limit point.
    EXPECT_NEAR((*diary.final)[i], (*until_there.final)[i], 1e-5);
}

TEST(LatticeRun, AStartThatFailsIsBegunAndFinishedWithoutSolutions)
{
  // Beyond the largest moment the spring can hold there is no equilibrium.
  Diary             diary;
  const std::string failure = failure_of(data_text("overload.prm"),
                                         {"Loads/winch/Moment z=5",
                                          "Time/Scheme=newmark",
                                          "Time/Start from=static equilibrium"},
                                         diary);
  EXPECT_TRUE(contains(failure, "No static equilibrium was found")) << failure;
  EXPECT_EQ(diary.calls, (std::vector<std::string>{"begin", "finish"}));
  EXPECT_EQ(diary.result.exit_state, failure);
  EXPECT_EQ(diary.result.time, 0.);
}

TEST(LatticeRun, AMistakeInTheSceneIsNoRun)
{
  // A hinged strut that nothing holds.
  const Scene scene = read_scene_from_text(cantilever("0.3", "Scheme = static"),
                                           "test.prm",
                                           {"Supports/wall/Type=pin"});
  LatticeRun  run(scene, MPI_COMM_SELF);
  Diary       diary;
  const std::string message = input_error_of([&] { run.run(diary); });
  EXPECT_TRUE(contains(message, "not supported")) << message;
  EXPECT_TRUE(diary.calls.empty());
}
