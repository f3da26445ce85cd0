#include <auxfem/mathematics/non_negative_least_squares.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/householder.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace auxfem
{
  namespace
  {
    using Columns = std::vector<std::vector<double>>;

    /** Least squares with the columns @p used alone; other entries are zero. */
    std::vector<double> least_squares(const Columns                   &columns,
                                      const std::vector<double>       &b,
                                      const std::vector<unsigned int> &used)
    {
      dealii::FullMatrix<double> matrix(b.size(), used.size());
      for (unsigned int j = 0; j < used.size(); ++j)
        for (unsigned int i = 0; i < b.size(); ++i)
          matrix(i, j) = columns[used[j]][i];
      dealii::Vector<double> right_side(b.begin(), b.end()),
        solution(used.size());
      dealii::Householder<double>(matrix).least_squares(solution, right_side);
      std::vector<double> x(columns.size(), 0.);
      for (unsigned int j = 0; j < used.size(); ++j)
        x[used[j]] = solution[j];
      return x;
    }

    /** Residual b - A x. */
    std::vector<double> residual(const Columns             &columns,
                                 std::vector<double>        b,
                                 const std::vector<double> &x)
    {
      for (std::size_t j = 0; j < columns.size(); ++j)
        for (std::size_t i = 0; i < b.size(); ++i)
          b[i] -= columns[j][i] * x[j];
      return b;
    }

    double product(const std::vector<double> &one,
                   const std::vector<double> &other)
    {
      return std::inner_product(one.begin(), one.end(), other.begin(), 0.);
    }
  } // namespace

  std::vector<double> non_negative_least_squares(const Columns &columns,
                                                 const std::vector<double> &b)
  {
    std::vector<double>       x(columns.size(), 0.);
    std::vector<unsigned int> used;
    // Every column enters a few times at most; round-off could let it cycle.
    for (std::size_t pass = 0; pass < 10 * columns.size(); ++pass)
      {
        const std::vector<double> r        = residual(columns, b, x);
        double                    steepest = 0;
        unsigned int              entering = columns.size();
        for (unsigned int j = 0; j < columns.size(); ++j)
          {
            const double slope = product(columns[j], r) /
              std::sqrt(product(columns[j], columns[j]) * product(b, b));
            if (std::find(used.begin(), used.end(), j) == used.end() &&
                slope > std::max(steepest, round_off))
              {
                steepest = slope;
                entering = j;
              }
          }
        if (entering == columns.size() || used.size() == b.size())
          return x;
        used.push_back(entering);
        while (true)
          {
            const std::vector<double> wanted = least_squares(columns, b, used);
            double                    part   = 1;
            for (const unsigned int j : used)
              if (wanted[j] <= 0)
                part = std::min(part, x[j] / (x[j] - wanted[j]));
            for (const unsigned int j : used)
              x[j] += part * (wanted[j] - x[j]);
            if (part == 1)
              break;
            used.erase(std::remove_if(used.begin(),
                                      used.end(),
                                      [&](const unsigned int j) {
                                        if (x[j] >
                                            std::numeric_limits<double>::min())
                                          return false;
                                        x[j] = 0;
                                        return true;
                                      }),
                       used.end());
          }
      }
    return x;
  }
} // namespace auxfem
