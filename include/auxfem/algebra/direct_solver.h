#ifndef auxfem_algebra_direct_solver_h
#define auxfem_algebra_direct_solver_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/parameters/numerical_limits.h>

#include <functional>
#include <limits>
#include <memory>
#include <new>
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

  /** Where MUMPS factorizes. */
  enum class MumpsRanks
  {
    first,
    /** Contributions add up as they come in: round-off differs from run to
     * run. */
    all
  };

  /** How rows are ordered so that factors stay sparse. */
  enum class EliminationOrder
  {
    minimum_degree,   ///< AMD (Amestoy, Davis, Duff 1996)
    nested_dissection ///< METIS (Karypis, Kumar 1998)
  };

  /**
   * @name Direct solvers, each on any number of ranks. All bring the matrix to
   * the first rank and factorize it there, unless MUMPS is to use all.
   */
  ///@{
  /**
   * CHOLMOD's simplicial LDL' (Chen, Davis, Hager, Rajamanickam 2008), for
   * symmetric matrices: definite ones, and indefinite ones as long as pivots in
   * the order that keeps the factors sparse are sound; `singular` otherwise.
   * Not for matrices with multipliers.
   */
  std::unique_ptr<DirectSolver> make_cholmod(EliminationOrder order);

  /** KLU (Davis, Palamadai Natarajan 2010), for any matrix; no inertia. */
  std::unique_ptr<DirectSolver> make_klu(EliminationOrder order);

  /**
   * MUMPS (Amestoy, Duff, Koster, L'Excellent 2001), for any matrix: LDL' with
   * pivots of one and two rows for symmetric ones, else LU.
   */
  std::unique_ptr<DirectSolver> make_mumps(MumpsRanks ranks);
  ///@}

  /** CSR offsets in the 32-bit integers of CHOLMOD and KLU. */
  std::vector<int> narrow_offsets(const SparseMatrix &matrix);

  /** Whether they can count the entries of @p matrix. */
  bool fits_narrow_offsets(const SparseMatrix &matrix);

  /**
   * Order of elimination that keeps the factors of @p matrix, on one rank,
   * sparse. Throws std::bad_alloc.
   */
  std::vector<int> elimination_order(const SparseMatrix &matrix,
                                     EliminationOrder    kind);

  /**
   * Largest of |A x - b| / (|A| y + |b|) by rows: how wrong the entries of A
   * and b would have to be for @p x to be the solution (J. L. Rigal, J. Gaches,
   * J. ACM 14, 1967, 543-548). y is the largest |x| of all motions, rotations
   * measured in Unknowns::length times radian, or of all multipliers; what is
   * below least_of_full_precision is no error. Infinite if something is no
   * number.
   *
   * @param x values at local unknowns, ghosts up to date
   * @param b owned rows
   * @param symmetry as in TangentMatrix::multiply(). Collective.
   */
  double backward_error(const TangentMatrix       &matrix,
                        const std::vector<double> &x,
                        const std::vector<double> &b,
                        Symmetry                   symmetry = Symmetry::none);

  /** Of this rank's rows. */
  bool has_finite_entries(const SparseMatrix &matrix);

  /**
   * The gravest outcome of all ranks, for all of them. Collective.
   */
  FactorizationOutcome agree(FactorizationOutcome mine, MPI_Comm communicator);

  /** What @p action returns, or `out_of_memory` if it throws std::bad_alloc. */
  template <typename Action>
  FactorizationOutcome catch_bad_alloc(const Action &action)
  {
    try
      {
        return action();
      }
    catch (const std::bad_alloc &)
      {
        return FactorizationOutcome::out_of_memory;
      }
  }

  /**
   * Factors s_i at local unknowns so that the largest s_i |a_ij| s_j of each
   * row is about 1 (D. Ruiz, A scaling algorithm to equilibrate both rows and
   * columns norms in matrices, RAL-TR-2001-034), whatever the units:
   * 1/sqrt(a_ii) where @p matrix is positive definite. 1 for rows of zeros.
   * Collective.
   *
   * @param scale result, room for local unknowns
   * @param room for owned unknowns; with both there, nothing is allocated
   */
  void equilibrate(const SparseMatrix  &matrix,
                   std::vector<double> &scale,
                   std::vector<double> &room);

  /**
   * Estimate from below of the norm of a symmetric matrix, or of the product of
   * a matrix and its transpose, that @p apply multiplies owned values by: power
   * iteration, two applications, or one if that finds less than @p enough.
   * Collective.
   *
   * @param x room for owned unknowns
   */
  double estimate_norm(const UnknownLayout &layout,
                       std::vector<double> &x,
                       double               threshold,
                       const std::function<void(std::vector<double> &)> &apply);

  /**
   * The inverse of a matrix whose rows and columns are scaled to about 1 has a
   * norm above this if the matrix is singular to round-off. Found of lattices
   * with 12 to 120,000 unknowns and slenderness 1 to 1e4: free ones 7e15 and
   * more, those held at one joint only up to 4e12 (400 unknowns), 6e14 (5000).
   */
  constexpr double singular_inverse_norm = 2e15;

  /**
   * Pivots smaller than this times what they were computed from call for the
   * estimate of the inverse's norm; others are no sign of a singular matrix.
   */
  constexpr double suspicious_pivot = sqrt_round_off;

  /** Numbers below have fewer digits than others, or what is subtracted from
   * them has: forces of a load that begins or ends as a Gaussian, say. */
  constexpr double least_of_full_precision =
    std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
} // namespace auxfem

#endif
