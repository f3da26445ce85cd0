#ifndef auxfem_algebra_factor_checks_h
#define auxfem_algebra_factor_checks_h

#include <auxfem/algebra/direct_solver.h>
#include <auxfem/parameters/numerical_limits.h>

#include <functional>
#include <new>

namespace auxfem
{
  /** Of this rank's rows. */
  bool has_finite_entries(const SparseMatrix &matrix);

  /**
   * The gravest outcome of all ranks, for all of them. Collective.
   */
  FactorizationOutcome agree(FactorizationOutcome mine, MPI_Comm communicator);

  /** What @p action returns, or `out_of_memory` if it throws std::bad_alloc. */
  template <typename Action>
  FactorizationOutcome guard_memory(const Action &action)
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
  double estimate_norm(const UnknownLayout                              &layout,
                       std::vector<double>                              &x,
                       double                                            enough,
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
} // namespace auxfem

#endif
