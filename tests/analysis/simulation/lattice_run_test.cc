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
  /** Records the calls that it receives. */
  struct CallRecorder : public Recorder
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
                         CallRecorder                   &call_recorder)
  {
    const Scene scene = read_scene_from_text(text, "test.prm", overrides);
    LatticeRun  run(scene, MPI_COMM_SELF);
    try
      {
        run.run(call_recorder);
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

TEST(LatticeRun, CallsItsRecorderInOrder)
{
  const Scene scene =
    read_scene_from_text(cantilever("0.3 * t", ten_steps), "test.prm", {});
  LatticeRun      run(scene, MPI_COMM_SELF);
  CallRecorder    call_recorder;
  const RunResult result = run.run(call_recorder);

  EXPECT_EQ(call_recorder.calls, calls_of(10));
  EXPECT_EQ(call_recorder.n_unknowns, run.model.numbering.layout().n_global());
  ASSERT_EQ(call_recorder.times.size(), 12u);
  for (unsigned int i = 0; i <= 10; ++i)
    EXPECT_EQ(call_recorder.times[i], i * 0.1);
  EXPECT_EQ(call_recorder.times.back(), 1.);
  ASSERT_TRUE(call_recorder.latest && call_recorder.final);
  expect_same(*call_recorder.latest, *call_recorder.final);

  EXPECT_TRUE(result.completed());
  EXPECT_EQ(result.exit_state, "completed");
  EXPECT_EQ(result.time, 1.);
  EXPECT_EQ(result.work.steps, 10u);
  EXPECT_EQ(result.work.iterations, call_recorder.iterations);
  EXPECT_GE(result.work.factorizations, 1u);
  // The recorder receives the same result.
  EXPECT_EQ(call_recorder.result.exit_state, result.exit_state);
  EXPECT_EQ(call_recorder.result.time, result.time);
  EXPECT_EQ(call_recorder.result.work.iterations, result.work.iterations);
  EXPECT_EQ(call_recorder.result.work.factorizations,
            result.work.factorizations);
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
  // A second one for the substitute of a singular mass matrix.
  EXPECT_EQ(work({linear, no_rotary_inertia}).factorizations, 1u);
  EXPECT_EQ(work({linear, equilibrium, no_rotary_inertia}).factorizations, 2u);
}

TEST(LatticeRun, AWholeRunCountsTheStartsWorkToo)
{
  const auto factorizations = [](const std::string &start_from) {
    // Motions too small for a comparison with exact ones.
    const Scene scene =
      read_scene_from_text(cantilever("3e-5 + 1e-4 * t", ten_steps),
                           "test.prm",
                           {"Effects/Large rotation=off",
                            "Time/Start from=" + start_from});
    CallRecorder call_recorder;
    return LatticeRun(scene, MPI_COMM_SELF)
      .run(call_recorder)
      .work.factorizations;
  };
  EXPECT_EQ(factorizations("rest"), 1u) << "all steps share one";
  // The check for mechanisms uses its own, and equilibrium reuses it.
  EXPECT_EQ(factorizations("static equilibrium"), 2u);
}

TEST(LatticeRun, AFailureLeavesTheLastAcceptedSolutionAndTheReason)
{
  CallRecorder      call_recorder;
  const std::string failure =
    failure_of(data_text("overload.prm"), {}, call_recorder);
  EXPECT_TRUE(contains(failure, "did not converge")) << failure;
  EXPECT_EQ(call_recorder.result.exit_state, failure);
  EXPECT_FALSE(call_recorder.result.completed());

  const unsigned int n_steps = call_recorder.result.work.steps;
  EXPECT_GT(n_steps, 5u);
  EXPECT_EQ(call_recorder.calls, calls_of(n_steps));
  // Parts of the failed step were accepted.
  EXPECT_GE(call_recorder.times.back(), call_recorder.times[n_steps]);
  EXPECT_LT(call_recorder.times.back(), call_recorder.times[n_steps] + 0.02);
  EXPECT_EQ(call_recorder.result.time, call_recorder.times.back());
  EXPECT_GE(call_recorder.result.work.iterations, call_recorder.iterations);

  // The last solution equals that of a run that ends there.
  CallRecorder until_there;
  ASSERT_EQ(failure_of(data_text("overload.prm"),
                       {"Time/End time=" +
                        std::to_string(call_recorder.times.back()) + " s"},
                       until_there),
            "");
  ASSERT_TRUE(call_recorder.final && until_there.final);
  for (unsigned int i = 0; i < call_recorder.final->size(); ++i)
    // Residuals of 1e-8 near a limit point.
    EXPECT_NEAR((*call_recorder.final)[i], (*until_there.final)[i], 1e-5);
}

TEST(LatticeRun, AFailedStartHasNoSolutions)
{
  // Beyond the largest moment of the spring there is no equilibrium.
  CallRecorder      call_recorder;
  const std::string failure = failure_of(data_text("overload.prm"),
                                         {"Loads/winch/Moment z=5",
                                          "Time/Scheme=newmark",
                                          "Time/Start from=static equilibrium"},
                                         call_recorder);
  EXPECT_TRUE(contains(failure, "No static equilibrium was found")) << failure;
  EXPECT_EQ(call_recorder.calls, (std::vector<std::string>{"begin", "finish"}));
  EXPECT_EQ(call_recorder.result.exit_state, failure);
  EXPECT_EQ(call_recorder.result.time, 0.);
}

TEST(LatticeRun, AMistakeInTheSceneMakesNoRun)
{
  // A hinged strut without other supports.
  const Scene scene = read_scene_from_text(cantilever("0.3", "Scheme = static"),
                                           "test.prm",
                                           {"Supports/wall/Type=pin"});
  LatticeRun  run(scene, MPI_COMM_SELF);
  CallRecorder      call_recorder;
  const std::string message = input_error_of([&] { run.run(call_recorder); });
  EXPECT_TRUE(contains(message, "not supported")) << message;
  EXPECT_TRUE(call_recorder.calls.empty());
}
