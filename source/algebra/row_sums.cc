#include <auxfem/algebra/row_sums.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Calls @p take(result, value) for the values in some rows, for four
     * results in turn, as one would wait for itself.
     */
    template <class Take>
    std::array<double, 4> take_in_four(const double           *values,
                                       const std::vector<int> &rows,
                                       const Take             &take)
    {
      std::array<double, 4> results   = {{0, 0, 0, 0}};
      const std::size_t     n         = rows.size();
      const std::size_t     n_in_four = n - n % 4;
      for (std::size_t i = 0; i < n_in_four; i += 4)
        for (unsigned int k = 0; k < 4; ++k)
          take(results[k], values[rows[i + k]]);
      for (std::size_t i = n_in_four; i < n; ++i)
        take(results[0], values[rows[i]]);
      return results;
    }
  } // namespace

  double sum_of_squares(const double *values, const std::vector<int> &rows)
  {
    const auto sums =
      take_in_four(values, rows, [](double &sum, const double value) {
        sum += value * value;
      });
    return sums[0] + sums[1] + sums[2] + sums[3];
  }

  double largest_size(const double *values, const std::vector<int> &rows)
  {
    const auto results =
      take_in_four(values, rows, [](double &result, const double value) {
        result = std::max(result, std::abs(value));
      });
    return *std::max_element(results.begin(), results.end());
  }
} // namespace auxfem
