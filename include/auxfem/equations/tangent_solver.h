#ifndef auxfem_equations_tangent_solver_h
#define auxfem_equations_tangent_solver_h

#include <auxfem/algebra/linear_solver.h>
#include <auxfem/equations/equations.h>
#include <auxfem/state/step_report.h>

namespace auxfem
{
  /**
   * The equations with room for a tangent and its factorization; counts and
   * times all that is done with them. What computes is collective, as is the
   * constructor.
   */
  class TangentSolver
  {
  public:
    /**
     * @param work takes up all that is done; must outlive the object, as
     *   @p equations.
     */
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
    void count_shortened()
    {
      ++work.shortened;
    }

    /** Equations::tangent() into matrix(). */
    void assemble(const Evaluation        &evaluation,
                  const EvaluationResults &results,
                  const TangentFactors    &factors);

    /**
     * Factorizes matrix() as it is now. Returns false if it is singular or not
     * finite; why() says what was found. Throws ComputationError where the
     * factors find no room.
     */
    bool factorize(Exactness exactness = Exactness::exact);

    /**
     * Solves for the right-hand side in the owned rows of @p values, increments
     * in prescribed ones, and replaces them by the solution, ghosts included.
     * Returns false if that fails: why() says so, and the values are not
     * finite.
     */
    bool solve(Vector &values);

    /**
     * As solve(), with a matrix() that is symmetric and positive definite in
     * free rows, by conjugate gradients with its diagonal; needs no
     * factorization. Returns false if that does not converge.
     */
    bool solve_by_conjugate_gradients(Vector &values);

    /** Why the last factorization or solution failed. */
    const std::string &why() const
    {
      return solver.why();
    }

    /** @name Of the last factorization, as LinearSolver has them; none if either
     * has been asked for already. Collective. */
    ///@{
    std::optional<Inertia>       new_inertia();
    std::optional<NegativeModes> new_negative_modes();
    ///@}

    /** Which linear solver, its factorization. */
    const LinearSolver &linear_solver() const
    {
      return solver;
    }

    TangentMatrix &matrix()
    {
      return tangent;
    }

    /** What follows depends on the factorizations before no longer; that of
     * linear equations stays. */
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
    /** Whether new_inertia() has an answer. */
    bool is_new_factorization = false;
  };
} // namespace auxfem

#endif
