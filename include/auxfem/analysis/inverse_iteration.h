#ifndef auxfem_analysis_inverse_iteration_h
#define auxfem_analysis_inverse_iteration_h

#include <auxfem/analysis/tangent_solver.h>

#include <functional>
#include <optional>

namespace auxfem
{
  /**
   * Inverse iteration x <- A^-1 W x with the matrix A of @p solver, which is
   * factorized for it, from a random start that is the same in every run.
   *
   * @param weight diagonal of W, on owned rows
   * @param takes_part whether a local unknown is part of the mode; the others
   *   are zero
   * @param mode receives the last iterate, on local unknowns
   * @param is_enough whether @p mode will do after so many iterations
   * @return by how much the last iteration has made the largest entry grow;
   *   nothing if A is singular
   */
  std::optional<double>
  inverse_iteration(TangentSolver                           &solver,
                    const Vector                            &weight,
                    const std::function<bool(unsigned int)> &takes_part,
                    unsigned int                             n_iterations,
                    Vector                                  &mode,
                    const std::function<bool(unsigned int)> &is_enough = {});

  /**
   * Refuses a structure that can move without resistance, where equilibrium
   * without inertia is asked for. The softest mode of the stiffness at
   * @p state is found by inverse iteration; if its energy is round-off, an InputError
   * names the joint that moves most in it.
   *
   * @param first_step length of the step (s) that viscosity resists in; none:
   *   it does not resist.
   * @return whether the solver's factorization now is that of this stiffness,
   *   as it is.
   */
  bool refuse_mechanism(TangentSolver        &solver,
                        const State          &state,
                        std::optional<double> first_step);

  /**
   * Refuses constraints that follow from others, or from the supports: the
   * forces in rigid parts and hinges would not be determined. Throws
   * InputError, naming one of them. Collective, as are the others.
   */
  void refuse_overconstrained(TangentSolver &solver, const State &state);
} // namespace auxfem

#endif
