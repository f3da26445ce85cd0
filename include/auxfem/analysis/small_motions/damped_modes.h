#ifndef auxfem_analysis_small_motions_damped_modes_h
#define auxfem_analysis_small_motions_damped_modes_h

#include <auxfem/analysis/small_motions/natural_modes.h>

namespace auxfem
{
  /**
   * Gives each mode of @p found that swings, about @p state without damping, the
   * damped one that it becomes: a solution of A(s) x = 0 near it, with the
   * dynamic stiffness A of all connectors and damping. Where damping mixes
   * modes, each is given the one in which it has the largest part. None where
   * the search leads to no oscillation, or to one that another mode has.
   * Then counts those with |s| up to the highest of these and of the natural
   * frequencies (n_roots()), and looks for what is missing. Collective.
   */
  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found);
} // namespace auxfem

#endif
