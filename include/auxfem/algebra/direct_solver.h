#ifndef auxfem_algebra_direct_solver_h
#define auxfem_algebra_direct_solver_h

#include <auxfem/algebra/sparse_matrix.h>

#include <memory>
#include <optional>
#include <string>

namespace auxfem
{
  /** How a factorization ended, the same on all ranks. */
  enum class FactorizationOutcome
  {
    done,
    singular,
    not_finite, ///< the matrix has entries that are no numbers
    out_of_memory
  };

  /**
   * Numbers of negative, zero and positive eigenvalues of a symmetric matrix.
   * A stable equilibrium has as many negative ones as there are constraints
   * with multipliers (Sylvester; Gould 1985).
   */
  struct Inertia
  {
    unsigned long negative = 0, zero = 0, positive = 0;
  };

  /**
   * Solution of A x = b by factors that serve until the next factorize(). All
   * functions are collective.
   */
  class DirectSolver
  {
  public:
    virtual ~DirectSolver() = default;

    /** Does what depends on the pattern of @p matrix only. */
    virtual FactorizationOutcome analyse(const SparseMatrix &matrix) = 0;

    /** Factorizes @p matrix, whose pattern was analysed last. */
    virtual FactorizationOutcome factorize(const SparseMatrix &matrix) = 0;

    /** Replaces the right-hand side @p x on owned rows by the solution. */
    virtual void solve(double *x) = 0;

    /**
     * Of the whole matrix factorized last, the same on all ranks; none where
     * the factors do not tell it (unsymmetric ones).
     */
    virtual std::optional<Inertia> inertia() const = 0;

    /** Memory of the factors on this rank (bytes). */
    virtual std::size_t memory() const = 0;
  };
} // namespace auxfem

#endif
