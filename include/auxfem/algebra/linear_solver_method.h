#ifndef auxfem_algebra_linear_solver_method_h
#define auxfem_algebra_linear_solver_method_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/model/lattice_model.h>
#include <auxfem/scene/scene.h>

#include <Epetra_Vector.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** How a LinearSolver solves its equations A x = b. */
  class LinearSolverMethod
  {
  public:
    virtual ~LinearSolverMethod() = default;

    /**
     * Prepares solutions with the matrix as it is now. Returns false if it is
     * singular (numerically) on any rank.
     */
    virtual bool factorize() = 0;

    /**
     * Solves for the right-hand side @p b into @p x, both on the owned rows.
     * Returns an empty text, or why the equations were not solved; @p x is then
     * the best that was found or not finite.
     */
    virtual std::string solve(const Epetra_Vector &b, Epetra_Vector &x) = 0;

    /** Iterations of all solutions so far; 0 for direct methods. */
    virtual unsigned long n_iterations() const = 0;
  };

  /**
   * Direct solution with a kept factorization (Trilinos Amesos): the symbolic
   * work is done once, the numeric factorization serves until the next
   * factorize(), also when the matrix changes in between.
   */
  std::unique_ptr<LinearSolverMethod>
  make_direct_method(const SolverParameters &parameters,
                     TangentMatrix          &matrix,
                     const DofNumbering     &numbering);

  /**
   * GMRES on the joints' unknowns, those inside the struts being condensed,
   * with multigrid or an incomplete factorization as preconditioner (Trilinos
   * AztecOO, ML, Ifpack). factorize() makes the preconditioner; between it and
   * solve() the matrix must stay as it is.
   *
   * Throws InputError for scenes with rigid parts or revolute hinges: their
   * conditions make the matrix one of a saddle point, for which these
   * preconditioners are not made.
   */
  std::unique_ptr<LinearSolverMethod>
  make_gmres_method(const SolverParameters &parameters,
                    TangentMatrix          &matrix,
                    const LatticeModel     &model);
} // namespace auxfem

#endif
