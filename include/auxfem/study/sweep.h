#ifndef auxfem_study_sweep_h
#define auxfem_study_sweep_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>
#include <auxfem/study/scene_cases.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** A case of a sweep. */
  struct SweepCase
  {
    std::vector<std::string> values; ///< by parameter of the sweep
    SceneCase                scene_case;
  };

  /** All cases of @p scene. Throws InputError for the first one that is no valid
   * scene. */
  std::vector<SweepCase> sweep_cases(const Scene &scene);

  /**
   * Runs all cases of @p scene, several at a time on several ranks; skips those
   * that an earlier sweep into this folder has completed. Writes sweep.csv, one
   * row for each case, and the results of the cases in folders. Cases that fail
   * have rows without results. Throws Interrupted. Collective.
   */
  RunResult run_sweep(const Scene         &scene,
                      MPI_Comm             communicator,
                      const FolderOptions &options);
} // namespace auxfem

#endif
