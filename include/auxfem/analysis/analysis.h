#ifndef auxfem_analysis_analysis_h
#define auxfem_analysis_analysis_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

namespace auxfem
{
  /** A line of the table of analyses: one kind of question about a scene. */
  struct AnalysisEntry
  {
    std::string name;

    /** One sentence for users. */
    std::string description;

    /** Whether @p scene requests it. */
    bool (*serves)(const Scene &scene);

    /**
     * Computes @p scene and writes results into the folder that the scene
     * names. Throws InputError and ComputationError; results so far are then
     * on disk. Collective.
     */
    RunResult (*run)(const Scene         &scene,
                     MPI_Comm             communicator,
                     const FolderOptions &options);

    /**
     * Computes @p scene for a recorder, without a folder; nullptr for analyses
     * without rows to record. Throws as run(). Collective.
     */
    RunResult (*observe)(const Scene &scene,
                         MPI_Comm     communicator,
                         Recorder    &recorder);

    /** Dry run: builds everything, prints counts and effects. Collective. */
    void (*check)(const Scene &scene, MPI_Comm communicator);

    /** Files that only this analysis writes into its folder. */
    std::vector<std::string> files;
  };

  /** All analyses of the program (analysis/analysis.cc). */
  const std::vector<AnalysisEntry> &analysis_registry();

  /** The analysis that @p scene requests. */
  const AnalysisEntry &analysis_of(const Scene &scene);

  /** @name Entries of the table; only analysis.cc needs them. */
  ///@{
  AnalysisEntry simulation_entry();
  AnalysisEntry static_path_entry();
  AnalysisEntry modes_entry();
  AnalysisEntry buckling_entry();
  AnalysisEntry frequency_response_entry();
  AnalysisEntry effective_properties_entry();
  AnalysisEntry effective_response_entry();
  AnalysisEntry dispersion_entry();
  AnalysisEntry reduced_cell_entry();
  AnalysisEntry study_entry();
  AnalysisEntry sweep_entry();
  AnalysisEntry optimization_entry();
  ///@}
} // namespace auxfem

#endif
