#ifndef auxfem_output_overview_h
#define auxfem_output_overview_h

#include <auxfem/output/summary.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** The first lines of a run on the screen: program, file and title. */
  std::string heading_text(const Scene &scene);

  /**
   * Lines with counts, size and mass, simulated and omitted effects with their
   * reasons, and @p notes, without the final line break.
   */
  std::string overview_text(const Scene                       &scene,
                            const Counts                      &counts,
                            const std::vector<EffectDecision> &decisions,
                            const std::vector<std::string>    &notes);

  /**
   * For `--check`: prints overview_text() and writes `lattice.vtu` to the
   * output folder: struts, those of rigid parts too, and connectors at rest
   * with their numbers, dimensions and materials. Throws InputError if it
   * cannot be written. Collective.
   */
  void show_lattice(const Scene &scene, const Equations &equations);
} // namespace auxfem

#endif
