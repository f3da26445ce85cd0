#ifndef auxfem_equations_displaced_state_h
#define auxfem_equations_displaced_state_h

#include <auxfem/model/numbering.h>
#include <auxfem/time/state.h>

namespace auxfem
{
  /** @p state with @p factor times @p shape added, of all local unknowns;
   * rotations as vectors in the global frame. */
  State displaced(const State        &state,
                  const DofNumbering &numbering,
                  const Vector       &shape,
                  double              factor);
} // namespace auxfem

#endif
