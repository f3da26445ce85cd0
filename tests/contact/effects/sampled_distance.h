#ifndef auxfem_tests_equations_sampled_distance_h
#define auxfem_tests_equations_sampled_distance_h

#include <auxfem/contact/axis_curve.h>

#include <algorithm>
#include <array>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Minimum of @p least and the values of a function at @p n + 1 equidistant
     * points of [0, 1]. Skips points that cannot be the minimum.
     * @param steepest bound of the slope of the function */
    template <typename Function>
    double least_value(const unsigned int n,
                       const double       steepest,
                       const Function    &function,
                       double             least)
    {
      for (unsigned int i = 0; i <= n;)
        {
          const double value = function(double(i) / n);
          least              = std::min(least, value);
          i += 1 +
            static_cast<unsigned int>(
                 std::min<double>(n, n * (value - least) / steepest));
        }
      return least;
    }

    /** Upper bound of the norm of a vector polynomial on [0, 1] from monomial
     * coefficients: its longest Bernstein coefficient. */
    inline double
    longest(const std::vector<AxisCurve::Vector> &power_coefficients)
    {
      const unsigned int degree = power_coefficients.size() - 1;
      double             bound  = 0;
      for (unsigned int i = 0; i <= degree; ++i)
        {
          AxisCurve::Vector bernstein_coefficient;
          double            part = 1;
          for (unsigned int k = 0; k <= i; ++k)
            {
              bernstein_coefficient += part * power_coefficients[k];
              if (k < degree)
                part *= double(i - k) / (degree - k);
            }
          bound = std::max(bound, bernstein_coefficient.norm());
        }
      return bound;
    }

    /** Upper bound of the norm of the tangents of a curve (m). */
    inline double longest_tangent(const AxisCurve &curve)
    {
      std::vector<AxisCurve::Vector> tangent;
      for (unsigned int k = 1; k <= curve.degree; ++k)
        tangent.push_back(k * curve.coefficients[k]);
      return longest(tangent);
    }

    /** Upper bound of the distance (m) of points of equal parameter on two
     * curves of equal degree. */
    inline double longest_way(const AxisCurve &from, const AxisCurve &to)
    {
      std::vector<AxisCurve::Vector> way;
      for (unsigned int k = 0; k <= to.degree; ++k)
        way.push_back(to.coefficients[k] - from.coefficients[k]);
      return longest(way);
    }

    /** Minimum of @p least and the distances of @p n + 1 points of the @p range
     * of @p one from @p other (m). */
    inline double sampled_distance(const unsigned int           n,
                                   const AxisCurve             &one,
                                   const std::array<double, 2> &range,
                                   const AxisCurve             &other,
                                   const double                 least)
    {
      const double length = range[1] - range[0];
      return least_value(
        n,
        length * longest_tangent(one),
        [&](const double part) {
          return nearest_point(other, one.at(range[0] + length * part))
            .distance;
        },
        least);
    }
  } // namespace testing_support
} // namespace auxfem

#endif
