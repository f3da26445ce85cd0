#ifndef auxfem_system_linear_solver_h
#define auxfem_system_linear_solver_h

#include <auxfem/parameters/scene.h>
#include <auxfem/system/tangent_matrix.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>

#include <memory>

namespace auxfem
{
  /**
   * Direct solution with a kept factorization (Trilinos Amesos): the symbolic
   * work is done once, the numeric factorization serves until the next
   * factorize().
   */
  class LinearSolver
  {
  public:
    /**
     * `auto`: KLU on one rank, MUMPS on several where Trilinos has it, else
     * KLU.
     */
    LinearSolver(const SolverParameters &parameters,
                 TangentMatrix          &matrix,
                 const DofNumbering     &numbering);

    /**
     * Factorizes the matrix as it is now. Returns false if it is singular
     * (numerically) on any rank.
     */
    bool factorize();

    /**
     * Solves A x = b for the values set in right_side(); returns x on the
     * owned rows.
     */
    const Epetra_Vector &solve();

    /** As solve(), x into @p at_local_unknowns, ghosts included. */
    void solve(Epetra_Vector &at_local_unknowns);

    /** Owned rows of the right-hand side, to be filled before solve(). */
    Epetra_Vector &right_side();

  private:
    const DofNumbering                &numbering;
    std::string                        type;
    Epetra_Vector                      rhs, solution;
    Epetra_LinearProblem               problem;
    std::unique_ptr<Amesos_BaseSolver> solver;
    bool                               has_symbolic = false;
  };
} // namespace auxfem

#endif
