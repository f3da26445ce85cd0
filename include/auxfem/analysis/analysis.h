#ifndef auxfem_analysis_analysis_h
#define auxfem_analysis_analysis_h

#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

namespace auxfem
{
  /** One line of the table of analyses: a kind of question to a scene. */
  struct AnalysisEntry
  {
    std::string name;

    /** One sentence for users. */
    std::string description;

    /** Whether it is what @p scene asks for. */
    bool (*serves)(const Scene &scene);

    /**
     * Computes @p scene. Throws InputError and ComputationError; the recorder
     * has then been told of all that was computed. Collective.
     */
    RunResult (*run)(const Scene &scene,
                     MPI_Comm     communicator,
                     Recorder    &recorder);

    /** The dry run: builds everything, prints counts and effects. Collective.
     */
    void (*check)(const Scene &scene, MPI_Comm communicator);
  };

  /** All analyses the program knows (analysis/register.cc). */
  const std::vector<AnalysisEntry> &analysis_registry();

  /** The analysis that @p scene asks for. */
  const AnalysisEntry &analysis_of(const Scene &scene);

  /** @name Entries of the table, one per file; only register.cc needs them. */
  ///@{
  AnalysisEntry transient_entry();
  AnalysisEntry static_steps_entry();
  AnalysisEntry static_path_entry();
  AnalysisEntry reduced_cell_entry();
  ///@}
} // namespace auxfem

#endif
