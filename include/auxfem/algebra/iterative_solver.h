#ifndef auxfem_algebra_iterative_solver_h
#define auxfem_algebra_iterative_solver_h

#include <auxfem/algebra/linear_solver_method.h>


namespace auxfem
{
  /**
   * Solution of A x = b for the unknowns at joints by iteration: joints with
   * few neighbours and multipliers are eliminated (JointElimination), the rest
   * is solved by a Krylov method with multigrid or an incomplete factorization
   * (KrylovSolver), or eliminated too where it is small. What factorize()
   * prepares serves until the next one. All functions are collective.
   */
  class IterativeSolver : public LinearSolverMethod
  {
  public:
    explicit IterativeSolver(const SolverParameters &parameters);
    ~IterativeSolver() override;

    /**
     * Starts anew for matrices of another pattern.
     * @param unknowns of their rows and columns, none inside struts; rows and
     * columns of prescribed ones are those of the identity. Kept.
     */
    FactorizationOutcome analyse(const SparseMatrix &matrix,
                                 const Unknowns     &unknowns) override;

    /**
     * Prepares solutions with @p matrix, which has the pattern of those before
     * it since analyse(). The order of elimination is made with the first, as
     * multipliers need entries.
     */
    FactorizationOutcome factorize(const SparseMatrix &matrix) override;

    /**
     * Replaces the right-hand side @p x on owned rows by the solution. Returns
     * an empty text or why the equations were not solved to the tolerance; @p x
     * is then the best that was found or not finite.
     */
    std::string solve(double *x) override;

    /** Iterations of all solutions so far. */
    unsigned long n_iterations() const override;

    /** Memory on this rank but for the preconditioner's (bytes). */
    std::size_t memory() const override;

    /** None: only what is eliminated is known. */
    std::optional<Inertia> inertia() const override;
    std::optional<int>     determinant_sign() const override;

  private:
    struct Parts;

    /** Whether all that is eliminated allows conjugate gradients. */
    bool may_be_definite(const SparseMatrix &matrix) const;

    const SolverParameters parameters;
    std::unique_ptr<Parts> parts;
    double                 n_multipliers = 0; ///< of this rank
    unsigned long          n_before      = 0;
  };
} // namespace auxfem

#endif
