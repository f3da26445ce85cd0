#ifndef auxfem_algebra_sparse_assembly_h
#define auxfem_algebra_sparse_assembly_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/tangent_matrix.h>

namespace auxfem
{
  /**
   * A SparseMatrix as the sum of dense blocks. Each block remembers where its
   * entries lie, so adding it is a plain scatter.
   */
  class SparseAssembly
  {
  public:
    /**
     * @param layout must outlive the object.
     * @param first index of the first unknown of each block in @p unknowns, and
     *   the end of the last
     * @param unknowns local unknowns; -1: its row and column are left out
     *
     * Throws InputError if the blocks of a rank have more entries than an int
     * can count. Collective.
     */
    SparseAssembly(const UnknownLayout            &layout,
                   const std::vector<std::size_t> &first,
                   const std::vector<int>         &unknowns);

    const SparseMatrix &matrix() const
    {
      return sum;
    }

    /**
     * All entries zero.
     * @param symmetry of what will be added; with `enforced` the symmetric
     *   part of each block is.
     */
    void reset(Symmetry symmetry);

    /** Adds the row-major @p values to block @p block. */
    void add(std::size_t block, const double *values);

    void add_to_diagonal(unsigned int owned, double value);

  private:
    /** The rows of blocks that are added to each owned row of the matrix. */
    class BlockRows;

    void make_pattern(const BlockRows &rows);
    void find_positions(const BlockRows &rows);

    SparseMatrix             sum;
    bool                     enforces_symmetry = false;
    std::vector<std::size_t> begins; ///< of each block's positions, and the end
    std::vector<int>         sizes;  ///< of each block
    /** Index of each entry of a block in the matrix; -1: none. */
    std::vector<int> positions;
    std::vector<int> diagonal_positions;
  };
} // namespace auxfem

#endif
