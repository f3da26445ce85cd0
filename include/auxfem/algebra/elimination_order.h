#ifndef auxfem_algebra_elimination_order_h
#define auxfem_algebra_elimination_order_h

#include <auxfem/algebra/sparse_matrix.h>

namespace auxfem
{
  /** CSR offsets in the 32-bit integers of CHOLMOD and KLU. */
  std::vector<int> narrow_offsets(const SparseMatrix &matrix);

  /** Whether they can count the entries of @p matrix. */
  bool fits_narrow_offsets(const SparseMatrix &matrix);

  /**
   * Order of elimination that keeps the factors of @p matrix, on one rank,
   * sparse: METIS or approximate minimum degree, whichever suits the size.
   * Throws std::bad_alloc.
   */
  std::vector<int> elimination_order(const SparseMatrix &matrix);

  /** Whether a row's diagonal is zero, as those of multipliers are. */
  std::vector<bool> zero_diagonals(const SparseMatrix &matrix);

  /**
   * @p order with the @p marked rows behind the last of those they act on: a
   * pivot of a multiplier is then what the elimination of the displacements it
   * constrains has made of zero, negative where these are held or have inertia.
   */
  std::vector<int> behind_neighbours(const std::vector<int>  &order,
                                     const SparseMatrix      &matrix,
                                     const std::vector<bool> &marked);
} // namespace auxfem

#endif
