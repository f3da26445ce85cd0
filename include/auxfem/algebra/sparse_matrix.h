#ifndef auxfem_algebra_sparse_matrix_h
#define auxfem_algebra_sparse_matrix_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <algorithm>
#include <vector>

namespace auxfem
{
  /**
   * This rank's rows of a square sparse matrix (CSR). Row i belongs to owned
   * unknown i of the layout; columns are local numbers. The pattern is
   * symmetric and contains the diagonal.
   */
  struct SparseMatrix
  {
    explicit SparseMatrix(const UnknownLayout &layout);

    const UnknownLayout *layout;
    /** Index of the first entry of every owned row, and the end. */
    std::vector<std::size_t> first;
    std::vector<int>         columns; ///< ascending in a row
    std::vector<double>      entries;
    /** Whether the entries are symmetric (to round-off). */
    bool is_symmetric = true;

    /**
     * @p y = A x in owned rows.
     * @param x values at local unknowns, ghosts up to date
     */
    void multiply(const double *x, double *y) const;
  };

  /**
   * Sorts the items of a row by their member `column`; usually they are in
   * order.
   */
  template <typename T>
  void sort_by_column(std::vector<T> &row)
  {
    const auto is_before = [](const T &a, const T &b) {
      return a.column < b.column;
    };
    if (!std::is_sorted(row.begin(), row.end(), is_before))
      std::sort(row.begin(), row.end(), is_before);
  }

  /**
   * Assembles a SparseMatrix from dense blocks. The positions of each block's
   * entries are precomputed, so that adding a block is a plain scatter.
   */
  class SparseAssembly
  {
  public:
    /**
     * @param layout must outlive the object.
     * @param first index of the first unknown of each block in @p unknowns, and
     *   the end
     * @param unknowns local unknowns; -1 omits the row and column
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
     * Sets all entries to zero.
     * @param symmetry of the blocks to add; with `enforced` their symmetric
     *   parts are added.
     */
    void reset(Symmetry symmetry);

    /** Adds the row-major @p values to block @p block. */
    void add(std::size_t block, const double *values);

    void add_to_diagonal(unsigned int owned, double value);

  private:
    /** Rows of blocks that contribute to each owned row of the matrix. */
    class BlockRows;

    void make_pattern(const BlockRows &rows);
    void find_positions(const BlockRows &rows);

    SparseMatrix             sum;
    bool                     enforces_symmetry = false;
    std::vector<std::size_t> begins; ///< of each block's positions, and the end
    std::vector<int>         sizes;  ///< of each block
    /** Index of each block entry in the matrix; -1 if omitted. */
    std::vector<int> positions;
    std::vector<int> diagonal_positions;
  };

  /** @name Norms of the values in some rows, on this rank alone */
  ///@{
  double sum_of_squares(const double *values, const std::vector<int> &rows);

  /** Largest absolute value; 0 without rows. */
  double largest_size(const double *values, const std::vector<int> &rows);
  ///@}

  /**
   * Assembled rows and columns of a tangent or mass matrix for free
   * displacements, rotations and multipliers, i.e. of the supported structure;
   * for eigenvalue problems.
   */
  class FreeBlock
  {
  public:
    /** Uses the present pattern of @p matrix. Collective. */
    explicit FreeBlock(const TangentMatrix &matrix);

    FreeBlock(const FreeBlock &)            = delete;
    FreeBlock &operator=(const FreeBlock &) = delete;

    /** Copies the entries of @p matrix, whose pattern must be unchanged. */
    void assemble(const TangentMatrix &matrix);

    const SparseMatrix &matrix() const
    {
      return assembly.matrix();
    }

    /** Unknowns of the rows of matrix(). */
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
