#ifndef auxfem_analysis_analysis_h
#define auxfem_analysis_analysis_h

#include <auxfem/output/output_folder.h>
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
     * Computes @p scene and writes its results into the folder that the scene
     * names. Throws InputError and ComputationError; what was computed until
     * then is on disk. Collective.
     */
    RunResult (*run)(const Scene         &scene,
                     MPI_Comm             communicator,
                     const FolderOptions &options);

    /**
     * Computes @p scene for a recorder, without a folder; nullptr for an
     * analysis that has no rows to record. Throws as run(). Collective.
     */
    RunResult (*observe)(const Scene &scene,
                         MPI_Comm     communicator,
                         Recorder    &recorder);

    /** The dry run: builds everything, prints counts and effects. Collective.
     */
    void (*check)(const Scene &scene, MPI_Comm communicator);

    /** Files that only this analysis writes into its folder. */
    std::vector<std::string> files;
  };

  /** All analyses the program knows (analysis/register.cc). */
  const std::vector<AnalysisEntry> &analysis_registry();

  /** The analysis that @p scene asks for. */
  const AnalysisEntry &analysis_of(const Scene &scene);

  /** @name Entries of the table; only register.cc needs them. */
  ///@{
  AnalysisEntry simulation_entry();
  AnalysisEntry static_path_entry();
  AnalysisEntry modes_entry();
  AnalysisEntry buckling_entry();
  AnalysisEntry frequency_response_entry();
  AnalysisEntry reduced_cell_entry();
  AnalysisEntry study_entry();
  ///@}
} // namespace auxfem

#endif
