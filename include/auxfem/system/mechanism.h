#ifndef auxfem_system_mechanism_h
#define auxfem_system_mechanism_h

#include <auxfem/scene/scene.h>
#include <auxfem/system/linear_solver.h>
#include <auxfem/system/system.h>

namespace auxfem
{
  /**
   * Refuses a structure that can move without resistance, where equilibrium
   * without inertia is asked for. The softest mode of the stiffness at
   * @p state is found by inverse iteration; if its energy is round-off, an InputError
   * names the joint that moves most in it.
   *
   * @param dt length of the step (s) that viscosity resists in; infinity: it
   *   does not.
   *
   * Uses and overwrites @p matrix and the factorization of @p solver.
   */
  void refuse_mechanism(System        &system,
                        State          state,
                        double         dt,
                        TangentMatrix &matrix,
                        LinearSolver  &solver);
} // namespace auxfem

#endif
