#ifndef auxfem_tests_analysis_findings_of_h
#define auxfem_tests_analysis_findings_of_h

#include <auxfem/analysis/analysis.h>
#include <auxfem/output/recorder.h>
#include <auxfem/simulation.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <filesystem>

#include <unistd.h>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * Runs the scene of @p text; analyses without rows use a temporary folder.
     */
    inline RunResult result_of(const std::string              &text,
                               const std::vector<std::string> &overrides = {},
                               const MPI_Comm communicator = MPI_COMM_SELF)
    {
      Scene scene = read_scene_from_text(text, "test.prm", overrides);
      if (analysis_of(scene).observe == nullptr)
        {
          namespace mpi          = dealii::Utilities::MPI;
          scene.output.directory = testing::TempDir() + "auxfem-test-" +
            mpi::broadcast(communicator, std::to_string(getpid()));
          const RunResult result =
            run(scene, communicator, {FileRules{{}, /*replaces*/ true}});
          MPI_Barrier(communicator);
          if (mpi::this_mpi_process(communicator) == 0)
            std::filesystem::remove_all(scene.output.directory);
          return result;
        }
      MemoryRecorder recorder(scene, communicator);
      return run(scene, communicator, recorder);
    }

    /** Findings of the run. */
    inline std::vector<Finding>
    findings_of(const std::string              &text,
                const std::vector<std::string> &overrides    = {},
                const MPI_Comm                  communicator = MPI_COMM_SELF)
    {
      return result_of(text, overrides, communicator).findings;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
