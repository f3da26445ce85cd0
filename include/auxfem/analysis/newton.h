#ifndef auxfem_analysis_newton_h
#define auxfem_analysis_newton_h

#include <auxfem/system/linear_solver.h>
#include <auxfem/system/system.h>
#include <auxfem/time/step_report.h>
#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  /**
   * Newton's method for one step, with the factorization kept as long as it
   * serves.
   *
   * A step is solved when the free force rows are below tolerance * F + floor
   * and the moment rows below (tolerance * F + floor) * l: F the largest
   * internal force of this iterate and of all accepted steps, l the mean strut
   * length, floor the round-off of the residual itself, below which no
   * iteration can go. The conditions of rigid parts must hold to their own
   * round-off.
   */
  class Newton
  {
  public:
    Newton(System                 &system,
           const NewtonParameters &parameters,
           const SolverParameters &solver);

    /** What came of an attempt. */
    struct Result
    {
      bool         converged      = false;
      unsigned int iterations     = 0;
      unsigned int factorizations = 0;
      /** Of the iterative linear solver; 0 with direct ones. */
      unsigned int linear_iterations = 0;
      /** In units of the force scale. */
      double relative_residual = 0;
      /** Why it did not converge. */
      std::string reason;
    };

    /** Solves step.to, which the scheme has predicted. */
    Result solve(const ImplicitScheme &scheme, const Step &step);

    /** Forgets the factorization (the state jumped). */
    void drop_factorization();

    const PhaseTimes &times() const;
    LinearSolver     &solver();
    TangentMatrix    &tangent();

  private:
    ResidualNorm timed_residual(const Step &step);
    bool         factorize(const ImplicitScheme &scheme, const Step &step);
    /** Returns the number of iterations of the linear solver. */
    unsigned int solve_increment(const Step &step);
    bool   meets_conditions(const ResidualNorm &norm, const State &state) const;
    double in_force_units(const ResidualNorm &norm) const;

    System                        &system;
    NewtonParameters               parameters;
    std::unique_ptr<TangentMatrix> matrix;
    LinearSolver                   linear_solver;
    Vector                         increment;
    PhaseTimes                     phase_times;
    /** Of all accepted steps (N). */
    double largest_force = 0;
    /** Step length the kept factorization belongs to; negative: none is kept.
     */
    double factorized_dt = -1;
  };
} // namespace auxfem

#endif
