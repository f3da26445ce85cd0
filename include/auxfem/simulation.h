#ifndef auxfem_simulation_h
#define auxfem_simulation_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/run_checkpoints.h>
#include <auxfem/output/start_times.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

namespace auxfem
{
  /**
   * One run from a scene to the folder of results that it names: the analysis
   * that the scene asks for. Collective, as are the functions below. Throws
   * InputError or ComputationError; what was computed until then is on disk.
   * @param start of this rank, for the summary.
   * @param rules for what lies in the folder before the run.
   */
  RunResult run(const Scene      &scene,
                MPI_Comm          communicator,
                const StartTimes &start,
                const FileRules  &rules);

  /**
   * Goes on with a run in its folder.
   * @param scene scene_to_resume() of @p former
   */
  RunResult resume(const Scene      &scene,
                   RunToResume       former,
                   MPI_Comm          communicator,
                   const StartTimes &start,
                   const FileRules  &rules);

  /** As run(), of which @p recorder is told in place of the folder. */
  RunResult run(const Scene &scene, MPI_Comm communicator, Recorder &recorder);

  /**
   * The dry run of --check: builds everything, prints counts and effects,
   * computes and writes nothing.
   */
  void check(const Scene &scene, MPI_Comm communicator);

  /**
   * --compare: every scheme of the reduced cell on every one of @p scenes, as a
   * table on the screen and in @p folder. See reduced_cell/comparison.h.
   */
  void compare(const std::vector<Scene> &scenes,
               const std::string        &folder,
               const FileRules          &rules,
               MPI_Comm                  communicator);
} // namespace auxfem

#endif
