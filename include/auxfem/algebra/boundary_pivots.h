#ifndef auxfem_algebra_boundary_pivots_h
#define auxfem_algebra_boundary_pivots_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <optional>

namespace auxfem
{
  /**
   * By local row, the rank that can eliminate it while others eliminate theirs:
   * the lowest of those whose rows it acts on, if these are several; none of
   * other rows, and none of those that have to wait, because they act on a row
   * that another rank eliminates. Joints go as a whole, those that multipliers
   * tie to each other go together and do not wait for others. Collective.
   */
  std::vector<std::optional<unsigned int>>
  boundary_pivots(const SparseMatrix &matrix, const Unknowns &unknowns);
} // namespace auxfem

#endif
