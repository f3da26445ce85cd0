#ifndef auxfem_reduced_cell_cell_output_h
#define auxfem_reduced_cell_cell_output_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <string>

namespace auxfem
{
  /**
   * Computes the reduced cell on the calling rank and leaves one folder:
   * original.prm, parameters.prm, log.txt, history.csv with history.units.csv,
   * summary.json; and lines on the screen. Throws InputError, also if the
   * folder cannot be written to, and ComputationError.
   * @param options files that the scene was read from are always spared
   */
  RunResult run_reduced_cell(const Scene &scene, const FolderOptions &options);

  /** The first lines of a run: the cell, what is simulated, the scheme. */
  std::string cell_overview_text(const Scene &scene);
} // namespace auxfem

#endif
