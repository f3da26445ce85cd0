#ifndef auxfem_algebra_free_block_h
#define auxfem_algebra_free_block_h

#include <auxfem/algebra/tangent_matrix.h>

#include <memory>

namespace auxfem
{
  /**
   * Rows and columns of @p matrix that belong to free displacements and
   * rotations and to multipliers, under their global numbers: the matrix of the
   * structure that its supports hold. Symmetric where the physics is, that is
   * without follower loads, dashpots on turning lines and gyroscopic terms.
   * Collective.
   */
  std::unique_ptr<Epetra_CrsMatrix> free_block(const TangentMatrix &matrix,
                                               const DofNumbering  &numbering);
} // namespace auxfem

#endif
