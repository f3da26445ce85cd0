#ifndef auxfem_algebra_sparse_matrix_h
#define auxfem_algebra_sparse_matrix_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <algorithm>
#include <vector>

namespace auxfem
{
  /**
   * This rank's rows of a square sparse matrix, by rows. Row i is that of owned
   * unknown i of the layout; columns are local numbers of the layout. The
   * pattern is symmetric and has the whole diagonal.
   */
  struct SparseMatrix
  {
    explicit SparseMatrix(const UnknownLayout &layout);

    const UnknownLayout *layout;
    /** Index of the first entry of every owned row, and the end of the last. */
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

  /** Sorts what belongs to a row by its member `column`; mostly it is in order.
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

  /** @name Of the values in some rows, on this rank alone. */
  ///@{
  double sum_of_squares(const double *values, const std::vector<int> &rows);

  /** The largest absolute value; 0 without rows. */
  double largest_size(const double *values, const std::vector<int> &rows);
  ///@}

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
