#ifndef auxfem_system_linear_solver_h
#define auxfem_system_linear_solver_h

#include <auxfem/system/linear_solver_method.h>

namespace auxfem
{
  /**
   * Solution of the linear equations A x = b of a TangentMatrix, directly or by
   * iteration, with a factorization (or preconditioner) that serves until the
   * next factorize(). Between the two the matrix must stay as it is.
   */
  class LinearSolver
  {
  public:
    /**
     * `auto`: KLU on one rank, MUMPS on several where Trilinos has it, else
     * KLU. Throws InputError where a type cannot serve the scene.
     */
    LinearSolver(const SolverParameters &parameters,
                 TangentMatrix          &matrix,
                 const System           &system);

    /**
     * Factorizes the matrix as it is now. Returns false if it is singular
     * (numerically) on any rank. Throws ComputationError on all ranks if the
     * factors find no room in memory; std::bad_alloc on one of several ranks if
     * what comes before them does not.
     */
    bool factorize();

    /**
     * Solves A x = b for the values set in right_side(); returns x on the
     * owned rows. If that fails, failure() says why, and x is the best that was
     * found or not finite.
     */
    const Epetra_Vector &solve();

    /**
     * As solve(), x into @p at_local_unknowns, ghosts included; not finite if
     * that fails.
     */
    void solve(Epetra_Vector &at_local_unknowns);

    /** Why the last solve() failed; empty if it did not. */
    const std::string &failure() const;

    /** Iterations of all solutions so far; 0 for direct types. */
    unsigned long n_iterations() const;

    /** Owned rows of the right-hand side, to be filled before solve(). */
    Epetra_Vector &right_side();

  private:
    const DofNumbering                 &numbering;
    Epetra_Vector                       rhs, solution;
    std::unique_ptr<LinearSolverMethod> method;
    std::string                         why_failed;
  };
} // namespace auxfem

#endif
