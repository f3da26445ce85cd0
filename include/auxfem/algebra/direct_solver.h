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
  /** Outcome of a factorization, the same on all ranks. */
  enum class FactorizationOutcome
  {
    done,
    /**
     * Singular to round-off; from CHOLMOD also: factorization needs pivoting.
     */
    singular,
    not_finite, ///< the matrix has entries that are no numbers
    out_of_memory,
    /** The factors have more entries than the solver's integers can count. */
    too_large
  };

  /**
   * Numbers of negative, zero and positive eigenvalues of a symmetric matrix.
   * At a stable equilibrium there is one negative eigenvalue per multiplier
   * constraint (Sylvester; Gould 1985).
   */
  struct Inertia
  {
    unsigned long negative = 0, zero = 0, positive = 0;
  };

  /** Sign (1 or -1) of the determinant of a regular symmetric matrix. */
  inline int determinant_sign(const Inertia &inertia)
  {
    return inertia.negative % 2 == 0 ? 1 : -1;
  }

  /**
   * Solves A x = b by factors that stay valid until the next analyse() or
   * factorize(); the matrix itself is not kept. All functions but inertia(),
   * determinant_sign() and memory() are collective; a failure of one rank, lack
   * of memory included, is reported on all.
   */
  class DirectSolver
  {
  public:
    virtual ~DirectSolver() = default;

    /** Symbolic factorization: uses the pattern of @p matrix only. */
    virtual FactorizationOutcome analyse(const SparseMatrix &matrix) = 0;

    /** Factorizes @p matrix, which must have the pattern analysed last. */
    virtual FactorizationOutcome factorize(const SparseMatrix &matrix) = 0;

    /**
     * Replaces the right-hand side @p x on owned rows by the solution, after
     * the outcome `done`. Throws std::bad_alloc on all ranks if one lacks
     * memory.
     */
    virtual void solve(double *x) = 0;

    /**
     * Inertia of the whole matrix factorized last, the same on all ranks; none
     * if the factors do not give it (unsymmetric and some singular matrices).
     * The count of zeros of a singular matrix depends on round-off.
     */
    virtual std::optional<Inertia> inertia() const = 0;

    /**
     * Sign of the determinant of the matrix factorized last, 1 or -1, the same
     * on all ranks; none if it is singular. Derived from the inertia unless the
     * solver computes it for other matrices.
     */
    virtual std::optional<int> determinant_sign() const
    {
      const std::optional<Inertia> signs = inertia();
      return signs ? std::optional(auxfem::determinant_sign(*signs))
                   : std::nullopt;
    }

    /** Memory of the factors on this rank (bytes). */
    virtual std::size_t memory() const = 0;

    /**
     * Makes the next factorization choose its pivots anew; the present factors
     * are lost.
     */
    virtual void forget_pivots()
    {}
  };

  /**
   * Wraps a solver for one rank to serve several: gathers the pattern (once)
   * and the entries (each time) on the first rank and scatters the solution.
   * The solver sees finite entries only; its std::bad_alloc becomes
   * `out_of_memory`.
   */
  std::unique_ptr<DirectSolver>
  make_first_rank_solver(std::unique_ptr<DirectSolver> solver);

  /** Ranks on which MUMPS factorizes. */
  enum class MumpsRanks
  {
    first,
    /**
     * Contributions are summed in order of arrival: round-off varies from run
     * to run.
     */
    all
  };

  /** Fill-reducing order of rows. */
  enum class EliminationOrder
  {
    minimum_degree,   ///< AMD (Amestoy, Davis, Duff 1996)
    nested_dissection ///< METIS (Karypis, Kumar 1998)
  };

  /**
   * @name Direct solvers for any number of ranks. All factorize on the first
   *   rank, except MUMPS with MumpsRanks::all.
   */
  ///@{
  /**
   * CHOLMOD's simplicial LDL' (Chen, Davis, Hager, Rajamanickam 2008) for
   * symmetric matrices. Indefinite ones are factorized without pivoting;
   * `singular` where that is inaccurate. Not for matrices with multipliers.
   */
  std::unique_ptr<DirectSolver> make_cholmod(EliminationOrder order);

  /** KLU (Davis, Palamadai Natarajan 2010), for any matrix; no inertia. */
  std::unique_ptr<DirectSolver> make_klu(EliminationOrder order);

  /**
   * MUMPS (Amestoy, Duff, Koster, L'Excellent 2001) for any matrix: LDL' with
   * 1x1 and 2x2 pivots for symmetric matrices, else LU.
   */
  std::unique_ptr<DirectSolver> make_mumps(MumpsRanks ranks);
  ///@}

  /** CSR offsets in the 32-bit integers of CHOLMOD and KLU. */
  std::vector<int> narrow_offsets(const SparseMatrix &matrix);

  /** Whether 32-bit offsets can count the entries of @p matrix. */
  bool fits_narrow_offsets(const SparseMatrix &matrix);

  /**
   * Fill-reducing elimination order of @p matrix, on one rank. Throws
   * std::bad_alloc.
   */
  std::vector<int> elimination_order(const SparseMatrix &matrix,
                                     EliminationOrder    kind);

  /**
   * Backward error of @p x, the largest of |A x - b| / (|A| y + |b|) by rows
   * (J. L. Rigal, J. Gaches, J. ACM 14, 1967, 543-548). y is the largest |x| of
   * all motions, rotations times Unknowns::length, or of all multipliers.
   * Residuals below smallest_full_precision are ignored; non-finite numbers
   * give infinity.
   *
   * @param x values at local unknowns, ghosts up to date
   * @param b owned rows
   * @param symmetry as in TangentMatrix::multiply(). Collective.
   */
  double backward_error(const TangentMatrix       &matrix,
                        const std::vector<double> &x,
                        const std::vector<double> &b,
                        Symmetry                   symmetry = Symmetry::none);

  /** Whether the entries of this rank's rows are finite. */
  bool has_finite_entries(const SparseMatrix &matrix);

  /** Returns the gravest outcome of all ranks on all ranks. Collective. */
  FactorizationOutcome gravest_outcome(FactorizationOutcome mine,
                                       MPI_Comm             communicator);

  /** Result of @p action, or `out_of_memory` if it throws std::bad_alloc. */
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
   * Scaling factors s_i at local unknowns that bring the largest s_i |a_ij| s_j
   * of each row near 1, independently of units (D. Ruiz, A scaling algorithm to
   * equilibrate both rows and columns norms in matrices, RAL-TR-2001-034). A
   * positive definite @p matrix gives 1/sqrt(a_ii); rows of zeros give 1.
   * Collective.
   *
   * @param scale result, sized for local unknowns
   * @param room scratch for owned unknowns; with both allocated before, nothing
   *   is allocated
   */
  void equilibrate(const SparseMatrix  &matrix,
                   std::vector<double> &scale,
                   std::vector<double> &room);

  /**
   * Lower estimate of a norm by two power iterations, or one if that gives less
   * than @p threshold. @p apply multiplies owned values by the matrix, which is
   * symmetric or the product of a matrix and its transpose. Collective.
   *
   * @param x scratch for owned unknowns
   */
  double estimate_norm(const UnknownLayout &layout,
                       std::vector<double> &x,
                       double               threshold,
                       const std::function<void(std::vector<double> &)> &apply);

  /**
   * Norm of the inverse above which a matrix with equilibrated rows and columns
   * counts as singular. Chosen between free lattices (7e15 and more) and
   * lattices held at one joint (up to 6e14), with up to 120,000 unknowns and
   * slenderness 1e4.
   */
  constexpr double singular_inverse_norm = 2e15;

  /**
   * Ratio of a pivot to its terms before cancellation below which the norm of
   * the inverse is estimated; larger pivots do not indicate a singular matrix.
   */
  constexpr double suspicious_pivot = sqrt_round_off;

  /**
   * Numbers below this are denormal or arise from denormal terms, with fewer
   * digits than others: e.g. tails of a Gaussian load.
   */
  constexpr double smallest_full_precision =
    std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
} // namespace auxfem

#endif
