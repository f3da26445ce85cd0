#ifndef auxfem_study_study_h
#define auxfem_study_study_h

#include <auxfem/output/output_folder.h>
#include <auxfem/study/study_kind.h>

#include <mpi.h>

namespace auxfem
{
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
