#ifndef auxfem_algebra_krylov_solver_h
#define auxfem_algebra_krylov_solver_h

#include <auxfem/algebra/joint_rows.h>
#include <auxfem/algebra/solver_parameters.h>
#include <auxfem/algebra/sparse_matrix.h>

#include <memory>

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
    explicit KrylovSolver(const SolverParameters &parameters);
    ~KrylovSolver();

    /**
     * Makes the preconditioner.
     * @param is_new_pattern whether that of @p matrix or @p rows have changed
     * @param is_definite whether it may be positive definite: conjugate
     * gradients are tried
     * @returns whether that is possible on all ranks.
     */
    bool factorize(const SparseMatrix &matrix,
                   const JointRows    &rows,
                   bool                is_new_pattern,
                   bool                is_definite);

    /**
     * Solves for @p g into @p z, owned rows. Returns an empty text or why the
     * equations were not solved; @p z is then the best that was found.
     */
    std::string solve(const double *g, double *z);

    /** Of all solutions so far. */
    unsigned long n_iterations() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace auxfem

#endif
