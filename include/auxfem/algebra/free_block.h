#ifndef auxfem_algebra_free_block_h
#define auxfem_algebra_free_block_h

#include <auxfem/algebra/sparse_assembly.h>
#include <auxfem/algebra/unknown_selection.h>

namespace auxfem
{
  /**
   * Rows and columns of a tangent or mass matrix that belong to free
   * displacements and rotations and to multipliers, assembled: the matrix of
   * the structure that its supports hold, as eigenvalue problems want it.
   */
  class FreeBlock
  {
  public:
    /** With the pattern that @p matrix has now. Collective. */
    explicit FreeBlock(const TangentMatrix &matrix);

    FreeBlock(const FreeBlock &)            = delete;
    FreeBlock &operator=(const FreeBlock &) = delete;

    /** Takes the entries of @p matrix; its pattern must be the one it was. */
    void assemble(const TangentMatrix &matrix);

    const SparseMatrix &matrix() const
    {
      return assembly.matrix();
    }

    /** Which unknowns the rows of matrix() are. */
    const UnknownSelection &selection() const
    {
      return free;
    }

  private:
    const UnknownSelection free;
    SparseAssembly         assembly;
    const unsigned long    version;
  };
} // namespace auxfem

#endif
