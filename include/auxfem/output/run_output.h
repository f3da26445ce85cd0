#ifndef auxfem_output_run_output_h
#define auxfem_output_run_output_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/summary.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/step_report.h>

#include <memory>

namespace auxfem
{
  /**
   * Everything a run leaves behind, in one folder: parameters.prm,
   * original.prm, log.txt, history.csv, solution.pvd, rigid_parts.pvd and
   * connectors.pvd with their series (of what the scene has), summary.json,
   * checkpoints.
   * Also the lines on the screen. Rows are on disk as soon as they are written;
   * what was computed before a failure stays readable.
   *
   * Results of an earlier run in the same folder are removed in begin() (files
   * of these names only), so that what is there belongs together. Before it
   * nothing is written, so that a scene found wrong during set-up costs no
   * results. It throws InputError for a probe whose joints do not exist, and if
   * the folder cannot be written to; what writes later, ComputationError if the
   * disk takes no more.
   *
   * The wall time of the summary starts here.
   * @param scene must outlive the object.
   * @param communicator all ranks take part in every call.
   * @param options files that the scene was read from are always spared. A
   *   checkpoint is that of a run in the same folder, whose results are
   *   continued.
   */
  std::unique_ptr<Recorder> make_run_output(const Scene         &scene,
                                            MPI_Comm             communicator,
                                            const FolderOptions &options = {});

  /** Prints what its begin() prints, and writes nothing. Collective. */
  void print_overview(const Scene &scene, const Equations &equations);
} // namespace auxfem

#endif
