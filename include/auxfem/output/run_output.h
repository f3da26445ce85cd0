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
   * Recorder that writes all files of a run to one folder and prints to the
   * screen: parameters.prm, original.prm, log.txt, history.csv, graphics
   * series, summary.json, checkpoints. Rows are flushed, so that results before
   * a failure are readable.
   *
   * begin() removes results of an earlier run in the folder (files of these
   * names only). Nothing is written before, so that an invalid scene destroys
   * no results. It throws InputError for a probe without joints and for an
   * unusable folder; later functions throw ComputationError if writing fails.
   *
   * The wall time of the summary starts here.
   * @param scene must outlive the object
   * @param communicator every call is collective on it
   * @param options input files are always kept; a checkpoint must be of a run
   *   in the same folder, whose results are continued
   */
  std::unique_ptr<Recorder> make_run_output(const Scene         &scene,
                                            MPI_Comm             communicator,
                                            const FolderOptions &options = {});
} // namespace auxfem

#endif
