#include <auxfem/algebra/row_sums.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  double sum_of_squares(const double *values, const std::vector<int> &rows)
  {
    double sum = 0;
    for (const int row : rows)
      sum += values[row] * values[row];
    return sum;
  }

  double largest_size(const double *values, const std::vector<int> &rows)
  {
    double largest = 0;
    for (const int row : rows)
      largest = std::max(largest, std::abs(values[row]));
    return largest;
  }
} // namespace auxfem
