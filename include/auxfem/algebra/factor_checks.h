#ifndef auxfem_algebra_factor_checks_h
#define auxfem_algebra_factor_checks_h

#include <auxfem/algebra/direct_solver.h>

#include <functional>

namespace auxfem
{
  /** Of this rank's rows. */
  bool has_finite_entries(const SparseMatrix &matrix);

  /**
   * The gravest outcome of all ranks, for all of them. Collective.
   */
  FactorizationOutcome agree(FactorizationOutcome mine, MPI_Comm communicator);

  /** What @p action returns, or `out_of_memory` if it throws std::bad_alloc. */
  FactorizationOutcome
  guard_memory(const std::function<FactorizationOutcome()> &action);

  /**
   * Factors s_i so that s_i |a_ij| s_j is at most 1 everywhere and 1 at least
   * once in each row (J. R. Bunch, Equilibration of symmetric matrices in the
   * max-norm, J. ACM 18, 1971, 566-572); 1/sqrt(a_ii) where @p matrix,
   * symmetric and on one rank, is positive definite. 1 for rows of zeros.
   */
  std::vector<double> equilibration(const SparseMatrix &matrix);

  /**
   * Estimate from below of the norm of a symmetric n x n matrix, or of the
   * product of a matrix and its transpose, that @p apply multiplies a vector
   * by: power iteration, two applications.
   */
  double estimate_norm(std::size_t                                       n,
                       const std::function<void(std::vector<double> &)> &apply);

  /**
   * The inverse of a matrix whose rows and columns are scaled to about 1 has a
   * norm above this if the matrix is singular to round-off.
   */
  constexpr double singular_inverse_norm = 4e13;

  /**
   * Pivots smaller than this times what they were computed from call for the
   * estimate of the inverse's norm; others are no sign of a singular matrix.
   */
  constexpr double suspicious_pivot = 1e-8;
} // namespace auxfem

#endif
