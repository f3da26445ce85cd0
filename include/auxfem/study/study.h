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
  /** A scene that is studied and what it is looked at by. */
  struct StudyTask
  {
    const Scene                    &scene;
    std::vector<QuantityDefinition> quantities;
  };

  /** One line of the table of studies: a question to a scene. */
  struct StudyKind
  {
    /** As in Study/Kind. */
    std::string name;

    /** Names that its pictures may have. */
    std::vector<std::string> pictures;

    /** The simulations it takes, each once. Throws InputError for one that is
     * wrong, or if there is nothing to compare. */
    std::vector<PlannedRun> (*plan)(const StudyTask &task);

    /** What they show; @p runs are those of plan(), @p further does what they
     * give reason for. Collective. */
    StudyReport (*report)(const StudyTask                &task,
                          const std::vector<MeasuredRun> &runs,
                          StudyRuns                      &further);
  };

  /** All studies the program knows (study/register.cc). */
  const std::vector<StudyKind> &study_registry();

  /** @name Entries of the table, one per file; only register.cc needs them. */
  ///@{
  StudyKind convergence_study();
  StudyKind work_precision_study();
  StudyKind effects_study();
  ///@}

  /**
   * The study that @p scene asks for, in memory.
   * @param folder where runs are kept, see StudyRuns.
   * @param listener is told of them, on the first rank.
   *
   * Throws InputError and Interrupted. Collective.
   */
  StudyReport compute_study(
    const Scene               &scene,
    MPI_Comm                   communicator,
    const std::string         &folder   = "",
    const StudyRuns::Listener &listener = [](const StudyProgress &) {});

  /**
   * The same with its lines on the screen and its tables and pictures in the
   * folder that @p scene names: study.md, study.csv, pictures with their
   * scripts, log.txt, and the runs, with which it goes on if it is interrupted.
   */
  RunResult run_study(const Scene         &scene,
                      MPI_Comm             communicator,
                      const FolderOptions &options);

  /** What run_study() leaves in its folder besides what every run does, of all
   * kinds of studies. The runs that are kept do not belong to it. */
  std::vector<std::string> study_files();

  /** The dry run: prints which simulations the study is made of. Collective. */
  void check_study(const Scene &scene, MPI_Comm communicator);
} // namespace auxfem

#endif
