#ifndef auxfem_equations_tangent_solver_h
#define auxfem_equations_tangent_solver_h

#include <auxfem/algebra/linear_solver.h>
#include <auxfem/equations/equations.h>
#include <auxfem/state/step_report.h>

namespace auxfem
{
  /**
   * Tangent matrix of the equations with its factorization; records counts and
   * times. The constructor and all computations are collective.
   */
  class TangentSolver
  {
  public:
    /** @param work statistics; must outlive the object, as @p equations */
    TangentSolver(const Equations        &equations,
                  const SolverParameters &parameters,
                  Work                   &work);

    const Equations &equations() const
    {
      return equation_system;
    }

    const LatticeModel &model() const
    {
      return equation_system.model();
    }

    /** Equations::residual(). */
    void residual(const Evaluation &evaluation, EvaluationResults &results);

    /** Equations::find_stage_results(). */
    void find_stage_results(const Evaluation  &stage,
                            EvaluationResults &results);

    /** Counts Work::shortened. */
    void count_backtrack()
    {
      ++work.shortened;
    }

    /** Equations::tangent() into matrix(). */
    void assemble(const Evaluation        &evaluation,
                  const EvaluationResults &results,
                  const TangentFactors    &factors);

    /** Factorizes matrix(). Returns false if it is singular or not finite;
     * last_failure() gives the reason. Throws ComputationError if memory does
     * not suffice. */
    bool factorize(Exactness exactness = Exactness::exact);

    /** Solves for the right-hand side in the owned rows of @p values, with
     * increments in prescribed rows; overwrites them with the solution,
     * including ghosts. Returns false on failure; last_failure() gives the
     * reason, and the values are not finite. */
    bool solve(Vector &values);

    /** As solve(), by Jacobi-preconditioned conjugate gradients without
     * factorization; matrix() must be symmetric positive definite in free rows.
     * Returns false without convergence. */
    bool solve_by_conjugate_gradients(Vector &values);

    /** Reason why the last factorization or solution failed. */
    const std::string &last_failure() const
    {
      return solver.last_failure();
    }

    /** @name Inertia of the last factorization; empty if already queried.
     * Collective. */
    ///@{
    std::optional<Inertia>       new_inertia();
    std::optional<NegativeModes> new_negative_modes();
    ///@}

    /** Linear solver with its factorization. */
    const LinearSolver &linear_solver() const
    {
      return solver;
    }

    TangentMatrix &matrix()
    {
      return tangent;
    }

    /** Makes later results independent of earlier factorizations; keeps the
     * factorization of linear equations. */
    void restart()
    {
      if (!equation_system.is_linear())
        solver.forget_pivots();
      is_new_factorization = false;
    }

  private:
    const Equations &equation_system;
    TangentMatrix    tangent;
    LinearSolver     solver;
    Work            &work;
    /** Whether new_inertia() has not been queried yet. */
    bool is_new_factorization = false;
  };
} // namespace auxfem

#endif
