#ifndef auxfem_analysis_saved_state_h
#define auxfem_analysis_saved_state_h

#include <auxfem/equations/equations.h>
#include <auxfem/time/records.h>

namespace auxfem
{
  /** Keeps all of @p state, an accepted one, in @p records. Collective. */
  void
  save_state(const State &state, const Equations &equations, Records &records);

  /**
   * The state that save_state() has kept, to the last digit on as many ranks.
   * Throws InputError if a record is missing. Collective.
   */
  State saved_state(const Equations &equations, const Records &records);

  /** Its displacements alone. Throws as saved_state(). Collective. */
  Vector saved_displacement(const Equations &equations, const Records &records);

  /** When that was (s); of a path of equilibria the arc length (m). */
  double time_of_saved_state(const Records &records);

  /** Steps of the scene until then, or points of a path. */
  unsigned long step_of_saved_state(const Records &records);

  /** Where it was on a path of equilibria; nothing if on none. */
  std::optional<PathPosition> saved_path_position(const Records &records);
} // namespace auxfem

#endif
