#ifndef auxfem_tests_analysis_resumed_run_h
#define auxfem_tests_analysis_resumed_run_h

#include <auxfem/output/memory_recorder.h>
#include <auxfem/simulation.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Ends a run; no error. */
    struct Halt
    {};

    /** Lets a run go on from a checkpoint, once, and throws Halt at its first
     * one from a time on. */
    class InterruptedRecorder : public MemoryRecorder
    {
    public:
      /**
       * @param former checkpoint that the run goes on from; nullptr: none
       * @param halt_time s; nothing: the run goes on to its end
       */
      InterruptedRecorder(const Scene                &scene,
                          const MPI_Comm              communicator,
                          const Records *const        former,
                          const std::optional<double> halt_time)
        : MemoryRecorder(scene, communicator)
        , former(former)
        , halt_time(halt_time)
      {}

      const Records *goes_on_from() const override
      {
        return former;
      }

      void resume(const Solution &solution, const Records &records) override
      {
        MemoryRecorder::resume(solution, records);
        former = nullptr;
      }

      void step(const Solution &solution, const StepReport &report) override
      {
        MemoryRecorder::step(solution, report);
        time = solution.state.time;
      }

      bool wants_checkpoint() override
      {
        return halt_time && time >= *halt_time;
      }

      void take(Records records) override
      {
        checkpoint = std::move(records);
        throw Halt();
      }

      std::optional<Records> checkpoint;

    private:
      const Records              *former;
      const std::optional<double> halt_time; ///< s
      double                      time = 0;  ///< s
    };

    /** A result with all rows from the first step on. */
    struct RecordedRun
    {
      RunResult                        result;
      std::vector<std::vector<double>> rows;
    };

    inline RecordedRun whole_run(const Scene   &scene,
                                 const MPI_Comm communicator)
    {
      MemoryRecorder recorder(scene, communicator);
      RunResult      result = run(scene, communicator, recorder);
      return {std::move(result), recorder.rows()};
    }

    /** The same halted after each of some parts of its time, and resumed. */
    inline RecordedRun resumed_run(const Scene               &scene,
                                   const MPI_Comm             communicator,
                                   const std::vector<double> &parts)
    {
      std::optional<Records>           checkpoint;
      std::vector<std::vector<double>> rows;
      const auto go_on = [&](const std::optional<double> halt_time) {
        InterruptedRecorder recorder(scene,
                                     communicator,
                                     checkpoint ? &*checkpoint : nullptr,
                                     halt_time);
        RunResult           result;
        try
          {
            result = run(scene, communicator, recorder);
          }
        catch (const Halt &)
          {}
        // It may have had to be done again from the start.
        if (!recorder.rows().empty() && recorder.rows().front().front() == 0)
          rows.clear();
        rows.insert(rows.end(), recorder.rows().begin(), recorder.rows().end());
        if (halt_time)
          checkpoint = recorder.checkpoint.value();
        return result;
      };
      for (const double part : parts)
        go_on(part * scene.time.end_time);
      RunResult result = go_on({});
      return {std::move(result), std::move(rows)};
    }

    inline void expect_same(const RecordedRun &a, const RecordedRun &b)
    {
      EXPECT_EQ(a.rows, b.rows);
      EXPECT_EQ(a.result.exit_state, b.result.exit_state);
      EXPECT_EQ(a.result.work.steps, b.result.work.steps);
      EXPECT_EQ(a.result.work.iterations, b.result.work.iterations);
      EXPECT_EQ(a.result.work.factorizations, b.result.work.factorizations);
      EXPECT_EQ(a.result.work.linear_solutions, b.result.work.linear_solutions);
      EXPECT_EQ(a.result.time_error, b.result.time_error);
      EXPECT_EQ(a.result.small_displacement_error,
                b.result.small_displacement_error);
      ASSERT_EQ(a.result.findings.size(), b.result.findings.size());
      for (std::size_t i = 0; i < a.result.findings.size(); ++i)
        {
          EXPECT_EQ(a.result.findings[i].text, b.result.findings[i].text);
          EXPECT_EQ(a.result.findings[i].time, b.result.findings[i].time);
          EXPECT_EQ(a.result.findings[i].location,
                    b.result.findings[i].location);
        }
    }

    /**
     * That a run of @p text, on this rank or those of @p communicator, and one
     * that was halted early, halfway and late are the same, to the last digit.
     * Returns the former.
     */
    inline RecordedRun
    expect_same_when_resumed(const std::string              &text,
                             const std::vector<std::string> &overrides = {},
                             const MPI_Comm communicator = MPI_COMM_SELF)
    {
      const Scene scene = read_scene_from_text(text, "test.prm", overrides);
      RecordedRun whole = whole_run(scene, communicator);
      expect_same(whole, resumed_run(scene, communicator, {0.1, 0.5, 0.8}));
      return whole;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
