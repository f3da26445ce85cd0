#ifndef auxfem_algebra_elimination_order_h
#define auxfem_algebra_elimination_order_h

#include <auxfem/algebra/direct_solvers.h>

namespace auxfem
{
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
} // namespace auxfem

#endif
