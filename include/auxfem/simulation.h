#ifndef auxfem_simulation_h
#define auxfem_simulation_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/run_checkpoints.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The scene of @p run, with @p overrides (`Subsection/Parameter=value`). Throws
   * InputError, with names, if these change what the results until now depend
   * on, if a file has changed that the scene is read from, and if the run has
   * got to its end time.
   */
  Scene scene_to_resume(const RestartedRun             &run,
                        const std::vector<std::string> &overrides);

  /**
   * Runs the analysis that a scene asks for, into the folder of results that it
   * names. Throws InputError or ComputationError; what was computed until then
   * is on disk. Collective, as are the functions below.
   * @param options with the checkpoint of an earlier run the run continues from
   *   there; the scene is then scene_to_resume()
   */
  RunResult
  run(const Scene &scene, MPI_Comm communicator, const FolderOptions &options);

  /** Runs the analysis for @p recorder in place of a folder. */
  RunResult run(const Scene &scene, MPI_Comm communicator, Recorder &recorder);

  /**
   * The dry run of --check: builds everything, prints counts and effects,
   * computes and writes nothing.
   */
  void check(const Scene &scene, MPI_Comm communicator);
} // namespace auxfem

#endif
