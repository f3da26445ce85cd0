#ifndef auxfem_algebra_sparse_matrix_h
#define auxfem_algebra_sparse_matrix_h

#include <auxfem/algebra/unknown_layout.h>

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
} // namespace auxfem

#endif
