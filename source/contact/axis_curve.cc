#include <auxfem/contact/axis_curve.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Half the derivative of the square of the distance by the parameter. */
    double slope_at(const AxisCurve         &curve,
                    const AxisCurve::Vector &point,
                    const double             parameter)
    {
      return (curve.at(parameter) - point) * curve.tangent(parameter);
    }

    /** Where slope_at(), which has a root between two parameters, is zero. */
    double root_of_slope(const AxisCurve         &curve,
                         const AxisCurve::Vector &point,
                         double                   low,
                         double                   high)
    {
      constexpr unsigned int most_steps = 60;
      constexpr double       digits     = 1e-15;
      double                 at         = (low + high) / 2;
      for (unsigned int i = 0; i < most_steps; ++i)
        {
          const AxisCurve::Vector away    = curve.at(at) - point,
                                  tangent = curve.tangent(at);
          const double slope              = away * tangent;
          (slope < 0 ? low : high)        = at;
          const double growth = tangent * tangent + away * curve.bend(at);
          double       next   = growth > 0 ? at - slope / growth : low;
          if (!(next > low && next < high))
            next = (low + high) / 2;
          if (std::abs(next - at) <= digits)
            return next;
          at = next;
        }
      return at;
    }
  } // namespace

  NearestPoint nearest_point(const AxisCurve         &curve,
                             const AxisCurve::Vector &point,
                             const double             begin,
                             const double             end)
  {
    // A polynomial of the degree n has at most 2 n - 1 extrema of the distance.
    const unsigned int n =
      curve.degree == 1 ? 1 : std::min(2 * curve.degree + 2, 12u);
    unsigned int best   = 0;
    double       square = 0;
    const auto   at     = [&](const unsigned int i) {
      return begin + (end - begin) * i / n;
    };
    for (unsigned int i = 0; i <= n; ++i)
      if (const double d = (curve.at(at(i)) - point).norm_square();
          i == 0 || d < square)
        {
          best   = i;
          square = d;
        }
    const double low  = at(best > 0 ? best - 1 : 0),
                 high = at(std::min(best + 1, n));
    const auto found  = [&](const double parameter, const bool is_inside) {
      return NearestPoint{parameter,
                          (curve.at(parameter) - point).norm(),
                          is_inside};
    };
    if (slope_at(curve, point, low) >= 0)
      return found(low, low > begin);
    if (slope_at(curve, point, high) <= 0)
      return found(high, high < end);
    return found(root_of_slope(curve, point, low, high), true);
  }
} // namespace auxfem
