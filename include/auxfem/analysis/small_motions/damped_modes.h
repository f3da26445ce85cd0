#ifndef auxfem_analysis_small_motions_damped_modes_h
#define auxfem_analysis_small_motions_damped_modes_h

#include <auxfem/analysis/small_motions/natural_modes.h>

namespace auxfem
{
  /**
   * Finds the damped modes about @p state, solutions of A(s) x = 0 with the
   * dynamic stiffness A of all connectors and damping that swing, with |s| up
   * to
   * just above the highest frequency of @p found (MotionPencil). Each is given to
   * the natural mode that has the largest part in it, pairs with the largest
   * parts first; those left over are its further ones. Collective.
   */
  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found);
} // namespace auxfem

#endif
