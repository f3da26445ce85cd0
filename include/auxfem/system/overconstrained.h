#ifndef auxfem_system_overconstrained_h
#define auxfem_system_overconstrained_h

#include <auxfem/system/linear_solver.h>
#include <auxfem/system/system.h>

namespace auxfem
{
  /**
   * Throws InputError naming a rigid part or a revolute hinge whose conditions
   * follow from those of others and supports at @p state: a bar between two fixed joints, the
   * second diagonal of a closed loop. Their forces would be undetermined. Does
   * nothing without conditions. Collective; uses @p matrix and @p solver.
   */
  void refuse_overconstrained(System        &system,
                              State          state,
                              TangentMatrix &matrix,
                              LinearSolver  &solver);
} // namespace auxfem

#endif
