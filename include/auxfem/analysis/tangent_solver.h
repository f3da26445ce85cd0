#ifndef auxfem_analysis_tangent_solver_h
#define auxfem_analysis_tangent_solver_h

#include <auxfem/algebra/linear_solver.h>
#include <auxfem/equations/equations.h>
#include <auxfem/time/step_report.h>

namespace auxfem
{
  /**
   * The equations with room for a tangent and its factorization; counts and
   * times all that is done with them.
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

    const Equations    &equations() const;
    const LatticeModel &model() const;

    /** Equations::residual(). */
    void residual(const Evaluation &evaluation, EvaluationResults &results);

    /** Equations::tangent() into matrix(). */
    void assemble(const Evaluation        &evaluation,
                  const EvaluationResults &results,
                  const TangentFactors    &factors);

    /** Factorizes matrix() as it is now; false if it is singular. */
    bool factorize();

    /**
     * Solves for the right-hand side set in right_side(), ghosts included;
     * not finite if that fails, and failure() says why.
     */
    void solve(Vector &increment);

    /** As above, on the owned rows. */
    const Epetra_Vector &solve();

    /**
     * Solves with matrix(), symmetric and positive definite in free rows, by
     * conjugate gradients with its diagonal; needs no factorization. Returns
     * false if that does not converge.
     */
    bool solve_by_conjugate_gradients(Vector &increment);

    Epetra_Vector     &right_side();
    const std::string &failure() const;
    TangentMatrix     &matrix();

  private:
    const Equations &equation_system;
    TangentMatrix    tangent;
    LinearSolver     linear_solver;
    Work            &work;
  };
} // namespace auxfem

#endif
