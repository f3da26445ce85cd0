#ifndef auxfem_tests_analysis_resumed_run_h
#define auxfem_tests_analysis_resumed_run_h

#include <auxfem/output/recorder.h>
#include <auxfem/simulation.h>

#include <analysis/simulation/expect_same.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Stores the checkpoints of a run, and can resume one. */
    class CheckpointRecorder : public MemoryRecorder
    {
    public:
      /** @param former checkpoint to resume from; nullptr: none */
      CheckpointRecorder(const Scene                &scene,
                         const MPI_Comm              communicator,
                         const CheckpointData *const former)
        : MemoryRecorder(scene, communicator)
        , former(former)
      {}

      void begin(const Equations &equations) override
      {
        // A run may restart from its beginning.
        checkpoints.clear();
        MemoryRecorder::begin(equations);
      }

      const CheckpointData *restart_checkpoint() const override
      {
        return former;
      }

      void serialize(const Solution    &solution,
                     CheckpointArchive &archive) override
      {
        MemoryRecorder::serialize(solution, archive);
        if (!archive.is_saving())
          former = nullptr;
      }

      void store_checkpoint(CheckpointData records) override
      {
        checkpoints.push_back({std::move(records), rows().size()});
      }

      struct Checkpoint
      {
        CheckpointData records;
        std::size_t    n_rows;
      };

      std::vector<Checkpoint> checkpoints;

    private:
      const CheckpointData *former;
    };

    /** A result with all rows since the first step. */
    struct RecordedRun
    {
      RunResult                        result;
      std::vector<std::vector<double>> rows;
    };

    /**
     * A run from its start, or resumed from a checkpoint with the rows before
     * it.
     */
    inline RecordedRun recorded_run(CheckpointRecorder &recorder,
                                    const Scene        &scene,
                                    const MPI_Comm      communicator,
                                    std::vector<std::vector<double>> rows = {})
    {
      RunResult result = run(scene, communicator, recorder);
      rows.insert(rows.end(), recorder.rows().begin(), recorder.rows().end());
      return {std::move(result), std::move(rows)};
    }

    inline void expect_same(const RecordedRun &a, const RecordedRun &b)
    {
      EXPECT_EQ(a.rows, b.rows);
      EXPECT_EQ(a.result.exit_state, b.result.exit_state);
      expect_same_work(a.result.work, b.result.work);
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
     * Expects equal digits in a run of @p text and in runs resumed from an
     * early, a middle and a late checkpoint. Runs on this rank or those of @p communicator. Returns the whole run and the last resumed one.
     */
    inline std::array<RecordedRun, 2>
    runs_that_are_same(const std::string              &text,
                       const std::vector<std::string> &overrides = {},
                       const MPI_Comm communicator = MPI_COMM_SELF)
    {
      const Scene scene = read_scene_from_text(text, "test.prm", overrides);
      CheckpointRecorder recorder(scene, communicator, nullptr);
      const RecordedRun  whole = recorded_run(recorder, scene, communicator);
      RecordedRun        resumed;
      const std::size_t  n = recorder.checkpoints.size();
      EXPECT_GT(n, 2u);
      for (const std::size_t i : {n / 10, n / 2, 4 * n / 5})
        if (i < n)
          {
            const auto        &checkpoint = recorder.checkpoints[i];
            CheckpointRecorder later(scene, communicator, &checkpoint.records);
            resumed = recorded_run(later,
                                   scene,
                                   communicator,
                                   {whole.rows.begin(),
                                    whole.rows.begin() + checkpoint.n_rows});
            expect_same(whole, resumed);
          }
      return {whole, resumed};
    }

    inline RecordedRun
    expect_same_when_resumed(const std::string              &text,
                             const std::vector<std::string> &overrides = {},
                             const MPI_Comm communicator = MPI_COMM_SELF)
    {
      return runs_that_are_same(text, overrides, communicator)[0];
    }
  } // namespace testing_support
} // namespace auxfem

#endif
