#ifndef auxfem_algebra_krylov_solver_h
#define auxfem_algebra_krylov_solver_h

#include <auxfem/algebra/joint_rows.h>
#include <auxfem/algebra/solver_parameters.h>
#include <auxfem/algebra/sparse_matrix.h>

#include <memory>
#include <optional>
#include <string>

namespace auxfem
{
  /**
   * Iterative solution of S z = g on the rows of joints (Trilinos Belos on
   * Tpetra) with smoothed aggregation (MueLu) or an incomplete factorization
   * (Ifpack2) as preconditioner. All functions are collective.
   */
  class KrylovSolver
  {
  public:
    virtual ~KrylovSolver() = default;

    /**
     * Makes the preconditioner.
     * @param is_new_pattern whether that of @p matrix or @p rows have changed
     * @param is_definite whether it may be positive definite: conjugate
     * gradients are tried
     * @returns whether that is possible on all ranks.
     */
    virtual bool factorize(const SparseMatrix &matrix,
                           const JointRows    &rows,
                           bool                is_new_pattern,
                           bool                is_definite) = 0;

    /**
     * Solves for @p g into @p z, owned rows. Returns an empty text or why the
     * equations were not solved; @p z is then the best that was found.
     */
    virtual std::string solve(const double *g, double *z) = 0;

    /**
     * Negative eigenvalues of a matrix that may be positive definite, see
     * factorize(), at least: those of the coarsest level of multigrid, else 1
     * if conjugate gradients find that it is not positive definite. They do, as
     * they come to the solution for a random right-hand side, with a
     * preconditioner that is positive definite. None if they do not come to it,
     * or with another preconditioner.
     */
    virtual std::optional<unsigned long> n_negative() = 0;

    /** Of all solutions so far. */
    virtual unsigned long n_iterations() const = 0;
  };

  std::unique_ptr<KrylovSolver>
  make_krylov_solver(const SolverParameters &parameters);
} // namespace auxfem

#endif
