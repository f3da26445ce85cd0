#include <auxfem/algebra/sparse_matrix.h>

namespace auxfem
{
  SparseMatrix::SparseMatrix(const UnknownLayout &layout)
    : layout(&layout)
    , first(layout.n_owned() + 1, 0)
  {}

  void SparseMatrix::multiply(const double *x, double *y) const
  {
    for (unsigned int row = 0; row < layout->n_owned(); ++row)
      {
        double sum = 0;
        for (std::size_t i = first[row]; i < first[row + 1]; ++i)
          sum += entries[i] * x[columns[i]];
        y[row] = sum;
      }
  }
} // namespace auxfem
