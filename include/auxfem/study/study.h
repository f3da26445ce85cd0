#ifndef auxfem_study_study_h
#define auxfem_study_study_h

#include <auxfem/output/output_folder.h>
#include <auxfem/study/quantities.h>
#include <auxfem/study/study_report.h>
#include <auxfem/study/study_runs.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** A studied scene and the quantities by which runs are compared. */
  struct StudyTask
  {
    const Scene                    &scene;
    std::vector<QuantityDefinition> quantities;
  };

  /** A kind of study, an entry of the registry. */
  struct StudyKind
  {
    /** Name in Study/Kind. */
    std::string name;

    /** Names of all possible pictures. */
    std::vector<std::string> pictures;

    /**
     * Distinct simulations of the study. Throws InputError if one is invalid or
     * there is nothing to compare.
     */
    std::vector<PlannedRun> (*plan)(const StudyTask &task);

    /**
     * Report on @p runs, the results of plan(); @p further computes additional
     * runs. Collective.
     */
    StudyReport (*report)(const StudyTask                &task,
                          const std::vector<MeasuredRun> &runs,
                          StudyRuns                      &further);
  };

  /** All kinds of studies. */
  const std::vector<StudyKind> &study_registry();

  /** @name Entries of the registry, one per file */
  ///@{
  StudyKind convergence_study();
  StudyKind work_precision_study();
  StudyKind effects_study();
  ///@}

  /**
   * Computes the study of @p scene in memory.
   * @param folder for stored runs, see StudyRuns
   * @param listener receives the progress on the first rank
   *
   * Throws InputError and Interrupted. Collective.
   */
  StudyReport compute_study(
    const Scene               &scene,
    MPI_Comm                   communicator,
    const std::string         &folder   = "",
    const StudyRuns::Listener &listener = [](const StudyProgress &) {});

  /**
   * Computes the study of @p scene with output to the screen and to its folder:
   * study.md, study.csv, pictures with their scripts, log.txt. Stored runs
   * allow an interrupted study to continue.
   */
  RunResult run_study(const Scene         &scene,
                      MPI_Comm             communicator,
                      const FolderOptions &options);

  /**
   * Files that run_study() may write besides those of every run, without stored
   * runs.
   */
  std::vector<std::string> study_files();

  /** Dry run: prints the simulations of the study. Collective. */
  void check_study(const Scene &scene, MPI_Comm communicator);
} // namespace auxfem

#endif
