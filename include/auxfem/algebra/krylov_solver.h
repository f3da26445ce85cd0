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
   * Iterative solution of S z = g on the rows of joints by Belos on Tpetra,
   * preconditioned by smoothed aggregation (MueLu) or an incomplete
   * factorization (Ifpack2). All functions are collective.
   */
  class KrylovSolver
  {
  public:
    virtual ~KrylovSolver() = default;

    /**
     * Builds the preconditioner.
     * @param is_new_pattern whether the pattern of @p matrix or @p rows has
     *   changed
     * @param is_definite whether the matrix may be positive definite: conjugate
     *   gradients are tried first
     * @returns whether it succeeded on all ranks.
     */
    virtual bool factorize(const SparseMatrix &matrix,
                           const JointRows    &rows,
                           bool                is_new_pattern,
                           bool                is_definite) = 0;

    /**
     * Solves for @p g into @p z, owned rows. Returns an empty text or the
     * reason of failure; @p z is then the best iterate.
     */
    virtual std::string solve(const double *g, double *z) = 0;

    /**
     * Lower bound for the number of negative eigenvalues of a matrix that may
     * be positive definite: those of the coarsest multigrid level, else 1 if
     * conjugate gradients for a random right-hand side meet a negative
     * curvature. None if they do not converge or the preconditioner is
     * indefinite.
     */
    virtual std::optional<unsigned long> n_negative() = 0;

    /** Number of iterations of all solutions so far. */
    virtual unsigned long n_iterations() const = 0;
  };

  std::unique_ptr<KrylovSolver>
  make_krylov_solver(const SolverParameters &parameters);

  /**
   * Solves with a matrix that is symmetric positive definite in free rows and
   * columns, e.g. a mass matrix, by conjugate gradients with Jacobi
   * preconditioning.
   *
   * @param values right-hand side in owned rows; on return the solution at all
   *   local unknowns, ghosts included
   * @return whether it converged; else @p values are undefined. Collective.
   */
  bool solve_by_conjugate_gradients(const TangentMatrix &matrix,
                                    std::vector<double> &values);

  /**
   * A x = b as operators on the rows that each rank owns. All operators are
   * collective.
   */
  struct OperatorEquations
  {
    MPI_Comm     communicator;
    unsigned int n_owned;
    /** y = A x. */
    std::function<void(const double *x, double *y)> multiply;
    /** Replaces x by an approximate solution y of A y = x; returns success. */
    std::function<bool(double *x)> precondition;
  };

  /**
   * Solves @p equations for @p b, owned rows, by GMRES (Saad & Schultz 1986;
   * deal.II) from the initial guess @p x, until the preconditioned residual is
   * below @p tolerance times that of b. Returns an empty text or the reason of
   * failure. Collective.
   */
  std::string solve_by_gmres(const OperatorEquations   &equations,
                             const std::vector<double> &b,
                             double                     tolerance,
                             std::vector<double>       &x);
} // namespace auxfem

#endif
