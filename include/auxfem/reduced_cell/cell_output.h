#ifndef auxfem_reduced_cell_cell_output_h
#define auxfem_reduced_cell_cell_output_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/start_times.h>
#include <auxfem/scene/scene.h>

#include <memory>

namespace auxfem
{
  /**
   * What a run of the reduced cell leaves behind, in one folder: original.prm,
   * parameters.prm, log.txt, history.csv with history.units.csv, summary.json;
   * and its lines on the screen. Made on all ranks, used on one. begin_cell()
   * throws InputError if the folder cannot be written to.
   * @param scene must outlive the object.
   * @param start for the summary.
   * @param rules files that the scene was read from are always spared.
   */
  std::unique_ptr<Recorder> make_cell_output(const Scene      &scene,
                                             const StartTimes &start,
                                             const FileRules  &rules);


  /** What its begin_cell() prints: the cell, what is simulated, the scheme.
   */
  std::string cell_overview_text(const Scene &scene);
} // namespace auxfem

#endif
