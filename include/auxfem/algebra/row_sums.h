#ifndef auxfem_algebra_row_sums_h
#define auxfem_algebra_row_sums_h

#include <vector>

namespace auxfem
{
  /** @name Of the values in some rows, on this rank alone. */
  ///@{
  double sum_of_squares(const double *values, const std::vector<int> &rows);

  /** The largest absolute value; 0 without rows. */
  double largest_size(const double *values, const std::vector<int> &rows);
  ///@}
} // namespace auxfem

#endif
