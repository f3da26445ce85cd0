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
    /** Ends a run at its first checkpoint from a time on. */
    class HaltingRecorder : public MemoryRecorder
    {
    public:
      HaltingRecorder(const Scene   &scene,
                      const MPI_Comm communicator,
                      const double   time)
        : MemoryRecorder(scene, communicator)
        , halt_time(time)
      {}

      void between(const Solution &solution) override
      {
        if (!checkpoint)
          MemoryRecorder::between(solution);
      }

      void step(const Solution &solution, const StepReport &report) override
      {
        // The run is asked at the begin of a step whether it is to end.
        if (checkpoint)
          return;
        MemoryRecorder::step(solution, report);
        time = solution.state.time;
      }

      bool wants_checkpoint() override
      {
        return !ends_run() && time >= halt_time;
      }

      void take(Records records) override
      {
        checkpoint = std::move(records);
      }

      bool ends_run() const override
      {
        return checkpoint.has_value();
      }

      std::optional<Records> checkpoint;

    private:
      const double halt_time; ///< s
      double       time = 0;  ///< s
    };

    /** Lets a run go on from a checkpoint, once. */
    class ResumingRecorder : public MemoryRecorder
    {
    public:
      ResumingRecorder(const Scene   &scene,
                       const MPI_Comm communicator,
                       const Records &checkpoint)
        : MemoryRecorder(scene, communicator)
        , checkpoint(checkpoint)
      {}

      const Records *goes_on_from() const override
      {
        return has_gone_on ? nullptr : &checkpoint;
      }

      void resume(const Solution &solution, const Records &records) override
      {
        MemoryRecorder::resume(solution, records);
        has_gone_on = true;
      }

    private:
      const Records &checkpoint;
      bool           has_gone_on = false;
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

    /** The same halted after a part of its time, and resumed. */
    inline RecordedRun resumed_run(const Scene   &scene,
                                   const MPI_Comm communicator,
                                   const double   part)
    {
      HaltingRecorder first(scene, communicator, part * scene.time.end_time);
      run(scene, communicator, first);
      ResumingRecorder second(scene, communicator, first.checkpoint.value());
      RunResult        result = run(scene, communicator, second);
      std::vector<std::vector<double>> rows;
      // It may have had to be done again from the start.
      if (second.rows().empty() || second.rows().front().front() > 0)
        rows = first.rows();
      rows.insert(rows.end(), second.rows().begin(), second.rows().end());
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
      for (const double part : {0.1, 0.5, 0.8})
        {
          SCOPED_TRACE(part);
          expect_same(whole, resumed_run(scene, communicator, part));
        }
      return whole;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
