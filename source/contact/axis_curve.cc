#include <auxfem/contact/axis_curve.h>
#include <auxfem/parameters/numerical_limits.h>

#include <cmath>
#include <limits>

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
      // Newton's method doubles the digits: after a step as short as this what
      // is left is round-off.
      constexpr unsigned int most_steps = 60;
      double                 at         = (low + high) / 2;
      for (unsigned int i = 0; i < most_steps; ++i)
        {
          const AxisCurve::Vector away    = curve.at(at) - point,
                                  tangent = curve.tangent(at);
          const double slope              = away * tangent;
          (slope < 0 ? low : high)        = at;
          const double growth     = tangent * tangent + away * curve.bend(at);
          double       next       = growth > 0 ? at - slope / growth : low;
          const bool   is_newtons = next > low && next < high;
          if (!is_newtons)
            next = (low + high) / 2;
          if (std::abs(next - at) <=
              (is_newtons ? sqrt_round_off : few_round_offs))
            return next;
          at = next;
        }
      return at;
    }

    /** The nearest point between @p low and @p high, one of them at least, of a
     * part of the curve. */
    NearestPoint minimum_between(const AxisCurve         &curve,
                                 const AxisCurve::Vector &point,
                                 const double             low,
                                 const double             high,
                                 const double             begin,
                                 const double             end)
    {
      const auto found = [&](const double parameter, const bool is_inside) {
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

    NearestPoint nearest_on_line(const AxisCurve         &line,
                                 const AxisCurve::Vector &point,
                                 const double             begin,
                                 const double             end)
    {
      const AxisCurve::Vector &along  = line.coefficients[1];
      const double             square = along * along,
                   foot               = square > 0
                      ? (point - line.coefficients[0]) * along / square
                      : begin,
                   at                 = std::clamp(foot, begin, end);
      return {at, (line.at(at) - point).norm(), foot > begin && foot < end};
    }
  } // namespace

  NearestPoint nearest_point(const AxisCurve         &curve,
                             const AxisCurve::Vector &point,
                             const double             begin,
                             const double             end)
  {
    if (curve.degree == 1)
      return nearest_on_line(curve, point, begin, end);
    // Between neighbouring ones of these there is hardly more than one minimum.
    constexpr unsigned int most = 12;
    const unsigned int     n    = std::min(2 * curve.degree + 2, most);
    const auto             at   = [&](const unsigned int i) {
      return i == n ? end : begin + (end - begin) * i / n;
    };
    std::array<double, most + 1> squares;
    for (unsigned int i = 0; i <= n; ++i)
      squares[i] = (curve.at(at(i)) - point).norm_square();
    NearestPoint nearest{begin, std::numeric_limits<double>::infinity(), false};
    for (unsigned int i = 0; i <= n; ++i)
      {
        if ((i > 0 && squares[i - 1] < squares[i]) ||
            (i < n && squares[i + 1] < squares[i]))
          continue;
        const NearestPoint found = minimum_between(curve,
                                                   point,
                                                   at(i > 0 ? i - 1 : 0),
                                                   at(std::min(i + 1, n)),
                                                   begin,
                                                   end);
        if (found.distance < nearest.distance)
          nearest = found;
      }
    return nearest;
  }
} // namespace auxfem
