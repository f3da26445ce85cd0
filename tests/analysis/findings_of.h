#ifndef auxfem_tests_analysis_findings_of_h
#define auxfem_tests_analysis_findings_of_h

#include <auxfem/output/memory_recorder.h>
#include <auxfem/simulation.h>

namespace auxfem
{
  namespace testing_support
  {
    /** Of a run of the scene of @p text. */
    inline RunResult result_of(const std::string              &text,
                               const std::vector<std::string> &overrides = {},
                               const MPI_Comm communicator = MPI_COMM_SELF)
    {
      const Scene    scene = read_scene_from_text(text, "test.prm", overrides);
      MemoryRecorder recorder(scene, communicator);
      return run(scene, communicator, recorder);
    }

    /** What that makes of its own results. */
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
