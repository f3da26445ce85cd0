#ifndef auxfem_algebra_direct_solver_h
#define auxfem_algebra_direct_solver_h

#include <auxfem/algebra/sparse_matrix.h>

#include <memory>
#include <optional>

namespace auxfem
{
  /** How a factorization ended, the same on all ranks. */
  enum class FactorizationOutcome
  {
    done,
    /** To round-off; of CHOLMOD also: not without pivoting. */
    singular,
    not_finite, ///< the matrix has entries that are no numbers
    out_of_memory,
    /** The solver's integers cannot count the entries of its factors. */
    too_large
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

  /** The sign of the determinant, 1 or -1, of a regular symmetric matrix. */
  inline int determinant_sign(const Inertia &inertia)
  {
    return inertia.negative % 2 == 0 ? 1 : -1;
  }

  /**
   * Solution of A x = b by factors that serve until the next analyse() or
   * factorize(); these neither keep nor change the matrix. All functions but
   * inertia(), determinant_sign() and memory() are collective; what one rank
   * meets, lack of memory included, all ranks report.
   */
  class DirectSolver
  {
  public:
    virtual ~DirectSolver() = default;

    /** Does what depends on the pattern of @p matrix only. */
    virtual FactorizationOutcome analyse(const SparseMatrix &matrix) = 0;

    /** Factorizes @p matrix, whose pattern was analysed last. */
    virtual FactorizationOutcome factorize(const SparseMatrix &matrix) = 0;

    /**
     * Replaces the right-hand side @p x on owned rows by the solution. The last
     * outcome must have been `done`. Throws std::bad_alloc on all ranks if one
     * has no memory for it.
     */
    virtual void solve(double *x) = 0;

    /**
     * Of the whole matrix factorized last, the same on all ranks; none where
     * the factors do not tell it (unsymmetric ones, and some singular ones). Of
     * a singular matrix what is zero is a matter of round-off.
     */
    virtual std::optional<Inertia> inertia() const = 0;

    /**
     * 1 or -1: of the determinant of the matrix factorized last, symmetric or
     * not, the same on all ranks; none of a singular one. That of the inertia,
     * unless a solver knows it of more matrices.
     */
    virtual std::optional<int> determinant_sign() const
    {
      const std::optional<Inertia> signs = inertia();
      return signs ? std::optional(auxfem::determinant_sign(*signs))
                   : std::nullopt;
    }

    /** Memory of the factors on this rank (bytes). */
    virtual std::size_t memory() const = 0;

    /** The next factorization chooses its pivots from its own entries; that of
     * before is lost. */
    virtual void forget_pivots()
    {}
  };

  /**
   * Lets a solver for one rank serve any number of them: brings the pattern
   * (once) and the entries (each time) to the first rank, and the solution back
   * from there. The solver sees finite entries only; its std::bad_alloc becomes
   * `out_of_memory`.
   */
  std::unique_ptr<DirectSolver>
  make_first_rank_solver(std::unique_ptr<DirectSolver> solver);
} // namespace auxfem

#endif
