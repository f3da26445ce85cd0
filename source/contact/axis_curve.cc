#include <auxfem/contact/axis_curve.h>
#include <auxfem/parameters/numerical_limits.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Half the parameter derivative of the squared distance. */
    double slope_at(const AxisCurve         &curve,
                    const AxisCurve::Vector &point,
                    const double             parameter)
    {
      return (curve.at(parameter) - point) * curve.tangent(parameter);
    }

    /** Root of slope_at() between two bracketing parameters. */
    double root_of_slope(const AxisCurve         &curve,
                         const AxisCurve::Vector &point,
                         double                   low,
                         double                   high)
    {
      // Newton's method doubles the digits, so after such a short step the
      // error is round-off.
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

    /** Nearest point between @p low and @p high, which bracket a local
     * minimum. */
    NearestPoint minimum_between(const AxisCurve         &curve,
                                 const AxisCurve::Vector &point,
                                 const double             low,
                                 const double             high,
                                 const double             begin,
                                 const double             end)
    {
      const auto nearest_at = [&](const double parameter,
                                  const bool   is_inside) {
        return NearestPoint{parameter,
                            (curve.at(parameter) - point).norm(),
                            is_inside};
      };
      if (slope_at(curve, point, low) >= 0)
        return nearest_at(low, low > begin);
      if (slope_at(curve, point, high) <= 0)
        return nearest_at(high, high < end);
      return nearest_at(root_of_slope(curve, point, low, high), true);
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
    // Samples this dense rarely miss a minimum.
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

  CurveChords::CurveChords(const AxisCurve &curve)
  {
    AxisCurve::Vector begin = curve.coefficients[0];
    for (unsigned int i = 0; i < n; ++i)
      {
        const AxisCurve::Vector end = curve.at((i + 1.) / n);
        begins[i]                   = begin;
        chords[i]                   = end - begin;
        const double square         = chords[i].norm_square();
        inverse_squares[i]          = square > 0 ? 1 / square : 0;
        begin                       = end;
      }
    // Error of linear interpolation.
    double largest_bend = 0;
    for (unsigned int k = 2; k <= curve.degree; ++k)
      largest_bend += k * (k - 1.) * curve.coefficients[k].norm();
    deviation = largest_bend / (8 * n * n);
  }

  double CurveChords::least_distance(const AxisCurve::Vector &point) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < n; ++i)
      {
        const AxisCurve::Vector away = point - begins[i];
        const double            foot =
          std::clamp(away * chords[i] * inverse_squares[i], 0., 1.);
        least = std::min(least, (away - foot * chords[i]).norm_square());
      }
    return std::sqrt(least) - deviation;
  }

  namespace
  {
    /** Binomial coefficients by row. */
    class PascalTriangle
    {
    public:
      PascalTriangle()
      {
        for (unsigned int n = 0; n <= BernsteinPolynomial::max_degree; ++n)
          {
            rows[n][0] = rows[n][n] = 1;
            for (unsigned int k = 1; k < n; ++k)
              rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
          }
      }

      double operator()(const unsigned int n, const unsigned int k) const
      {
        return rows[n][k];
      }

    private:
      std::array<std::array<double, BernsteinPolynomial::max_degree + 1>,
                 BernsteinPolynomial::max_degree + 1>
        rows;
    };

    const PascalTriangle &binomial()
    {
      static const PascalTriangle triangle;
      return triangle;
    }

    unsigned int n_sign_changes(const BernsteinPolynomial &polynomial)
    {
      unsigned int n    = 0;
      double       last = 0;
      for (unsigned int i = 0; i <= polynomial.degree; ++i)
        if (const double here = polynomial.coefficients[i]; here != 0)
          {
            if (last * here < 0)
              ++n;
            last = here;
          }
      return n;
    }

    /** Single root of a polynomial with end values of opposite sign. */
    double single_root(const BernsteinPolynomial &polynomial)
    {
      const boost::math::tools::eps_tolerance<double> digits(40);
      boost::uintmax_t                                most_steps = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
        [&](const double parameter) { return polynomial.at(parameter); },
        0.,
        1.,
        polynomial.coefficients[0],
        polynomial.coefficients[polynomial.degree],
        digits,
        most_steps);
      return (low + high) / 2;
    }

    /** As BernsteinPolynomial::add_sign_changes(), for a part of [0, 1]. */
    void add_changes(const BernsteinPolynomial &part,
                     const double               begin,
                     const double               end,
                     std::vector<double>       &parameters)
    {
      constexpr double smallest = 1e-9;
      // Descartes' rule bounds the number of roots by the sign changes.
      const unsigned int n = n_sign_changes(part);
      if (n == 0)
        return;
      if (n == 1 && part.coefficients[0] * part.coefficients[part.degree] < 0)
        parameters.push_back(begin + (end - begin) * single_root(part));
      else if (end - begin < smallest)
        parameters.push_back((begin + end) / 2);
      else
        {
          const double middle      = (begin + end) / 2;
          const auto [first, last] = part.halves();
          if (last.coefficients[0] == 0)
            parameters.push_back(middle);
          add_changes(first, begin, middle, parameters);
          add_changes(last, middle, end, parameters);
        }
    }
  } // namespace

  double BernsteinPolynomial::at(const double parameter) const
  {
    // Horner's scheme in parameter / (1 - parameter), or in its inverse.
    const bool   is_first_half = parameter < 0.5;
    const double small         = is_first_half ? parameter : 1 - parameter,
                 ratio         = small / (1 - small);
    double result = 0, power = 1;
    for (unsigned int k = degree + 1; k-- > 0;)
      {
        const unsigned int i = is_first_half ? k : degree - k;
        result = result * ratio + binomial()(degree, i) * coefficients[i];
      }
    for (unsigned int i = 0; i < degree; ++i)
      power *= 1 - small;
    return result * power;
  }

  std::array<BernsteinPolynomial, 2> BernsteinPolynomial::halves() const
  {
    std::array<BernsteinPolynomial, 2> result;
    BernsteinPolynomial               &first = result[0], &last = result[1];
    last         = *this;
    first.degree = degree;
    for (unsigned int k = 0; k <= degree; ++k)
      {
        first.coefficients[k] = last.coefficients[0];
        for (unsigned int i = 0; i + k < degree; ++i)
          last.coefficients[i] =
            (last.coefficients[i] + last.coefficients[i + 1]) / 2;
      }
    return result;
  }

  bool BernsteinPolynomial::is_nowhere_negative() const
  {
    return std::all_of(coefficients.begin(),
                       coefficients.begin() + degree + 1,
                       [](const double value) { return value >= 0; });
  }

  bool BernsteinPolynomial::is_nowhere_positive() const
  {
    return std::all_of(coefficients.begin(),
                       coefficients.begin() + degree + 1,
                       [](const double value) { return value <= 0; });
  }

  void
  BernsteinPolynomial::add_sign_changes(std::vector<double> &parameters) const
  {
    add_changes(*this, 0, 1, parameters);
  }

  ControlPolygon::ControlPolygon(const AxisCurve   &curve,
                                 const unsigned int degree)
    : degree(degree)
  {
    for (unsigned int i = 0; i <= degree; ++i)
      for (unsigned int k = 0; k <= std::min(i, curve.degree); ++k)
        points[i] +=
          binomial()(i, k) / binomial()(degree, k) * curve.coefficients[k];
  }

  BernsteinPolynomial product(const ControlPolygon &one,
                              const ControlPolygon &other)
  {
    const unsigned int  p = one.degree;
    BernsteinPolynomial result;
    result.degree = 2 * p;
    std::fill_n(result.coefficients.begin(), 2 * p + 1, 0.);
    for (unsigned int i = 0; i <= p; ++i)
      for (unsigned int j = 0; j <= p; ++j)
        result.coefficients[i + j] += binomial()(p, i) * binomial()(p, j) /
          binomial()(2 * p, i + j) * (one.points[i] * other.points[j]);
    return result;
  }
} // namespace auxfem
