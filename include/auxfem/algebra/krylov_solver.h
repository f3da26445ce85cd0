#ifndef auxfem_algebra_krylov_solver_h
#define auxfem_algebra_krylov_solver_h

#include <auxfem/algebra/joint_order.h>
#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/tangent_matrix.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

  /**
   * Solves with a matrix that is symmetric and positive definite in free rows
   * and columns, as a mass matrix, by conjugate gradients with its diagonal;
   * needs no factorization.
   *
   * @param values the right-hand side in owned rows, replaced by the solution at
   *   all local unknowns, ghosts included
   * @return whether it has converged; @p values are undefined if it has not.
   * Collective.
   */
  bool solve_by_conjugate_gradients(const TangentMatrix &matrix,
                                    std::vector<double> &values);

  /** A x = b as operators on the rows that each rank owns. What they compute is
   * collective. */
  struct OperatorEquations
  {
    MPI_Comm     communicator;
    unsigned int n_owned;
    /** y = A x. */
    std::function<void(const double *x, double *y)> multiply;
    /** Makes x what nearly solves A y = x; returns whether that succeeded. */
    std::function<bool(double *x)> precondition;
  };

  /**
   * Solves @p equations for @p b, owned rows, into @p x, whose values are the
   * first guess, by GMRES (Saad & Schultz 1986; deal.II), until the
   * preconditioned residual is below @p tolerance times that of b. Returns an
   * empty text or why that was not reached. Collective.
   */
  std::string solve_by_gmres(const OperatorEquations   &equations,
                             const std::vector<double> &b,
                             double                     tolerance,
                             std::vector<double>       &x);
} // namespace auxfem

#endif
