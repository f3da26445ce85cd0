#ifndef auxfem_analysis_saved_state_h
#define auxfem_analysis_saved_state_h

#include <auxfem/equations/equations.h>
#include <auxfem/time/checkpoint_archive.h>

namespace auxfem
{
  /**
   * Saves @p state, an accepted one, or restores it in place of the initial
   * state, with equal digits on as many ranks. Throws InputError if a record is
   * missing. Collective.
   */
  void serialize_state(const Equations   &equations,
                       CheckpointArchive &archive,
                       State             &state);

  /** Displacements of a saved state. Throws as serialize_state(). Collective.
   */
  Vector saved_displacement(const Equations &equations, const Records &records);

  /** Time of a saved state (s); on a path of equilibria its arc length (m). */
  double time_of_saved_state(const Records &records);

  /** Steps of the scene until a saved state, or points of a path. */
  unsigned long step_of_saved_state(const Records &records);

  /** Load factor of a saved state on a path of equilibria. */
  double load_factor_of_saved_state(const Records &records);
} // namespace auxfem

#endif
