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
    /**
     * The least of the values of a function at @p n + 1 equidistant points of
     * [0, 1], and of @p least. Skips points that cannot have it.
     * @param steepest bound of the function's slope
     */
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

    /** Bound of the length of a vector that is a polynomial of a parameter in
     * [0, 1], from its coefficients of powers: the longest of Bernstein's. */
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

    /** Bound of the length of a curve's tangents (m). */
    inline double longest_tangent(const AxisCurve &curve)
    {
      std::vector<AxisCurve::Vector> tangent;
      for (unsigned int k = 1; k <= curve.degree; ++k)
        tangent.push_back(k * curve.coefficients[k]);
      return longest(tangent);
    }

    /** Bound of the distance (m) of points of two curves of one degree that
     * have the same parameter. */
    inline double longest_way(const AxisCurve &from, const AxisCurve &to)
    {
      std::vector<AxisCurve::Vector> way;
      for (unsigned int k = 0; k <= to.degree; ++k)
        way.push_back(to.coefficients[k] - from.coefficients[k]);
      return longest(way);
    }

    /** The least of the distances of @p n + 1 points of the part @p range of
     * @p one from @p other, and of @p least (m). */
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
