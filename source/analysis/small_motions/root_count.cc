#include <auxfem/analysis/small_motions/root_count.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;
    using Complex = CharacteristicEquation::Complex;

    /** Follows the argument of the determinant along lines that are straight in
     * log s. */
    class Argument
    {
    public:
      explicit Argument(CharacteristicEquation &equation) : equation(equation)
      {}

      /** From log s = @p from to @p to in @p n parts at first; none where a
       * root is on the way. */
      std::optional<double>
      change(const Complex from, const Complex to, const unsigned int n)
      {
        double sum = 0;
        auto   a   = point(from);
        for (unsigned int i = 1; i <= n; ++i)
          {
            const auto b = point(from + (to - from) * (double(i) / n));
            const auto part =
              a && b ? between(*a, *b, 0) : std::optional<double>();
            if (!part)
              return std::nullopt;
            sum += *part;
            a = b;
          }
        return sum;
      }

    private:
      struct Point
      {
        Complex z;            ///< log s
        Complex value, slope; ///< of log det A, by z
      };

      std::optional<Point> point(const Complex z)
      {
        const Complex s    = std::exp(z);
        const auto    here = equation.at(s);
        if (!here)
          return std::nullopt;
        return Point{z, here->value, here->slope * s};
      }

      /** Of log det A by the slopes of both ends, where that agrees with its
       * values; their real parts have no turns that could hide. */
      static std::optional<double> straight(const Point &a, const Point &b)
      {
        constexpr double allowed   = 0.4;
        const Complex    by_slopes = (a.slope + b.slope) / 2. * (b.z - a.z),
                      left         = b.value - a.value - by_slopes;
        const double imaginary     = std::remainder(left.imag(), 2 * PI);
        if (!(std::abs(left.real()) < allowed && std::abs(imaginary) < allowed))
          return std::nullopt;
        return by_slopes.imag() + imaginary;
      }

      std::optional<double>
      between(const Point &a, const Point &b, const unsigned int depth)
      {
        constexpr unsigned int deepest = 24;
        const auto             middle  = point((a.z + b.z) / 2.);
        if (depth > deepest || !middle)
          return std::nullopt;
        const auto first = straight(a, *middle), second = straight(*middle, b);
        if (first && second)
          return *first + *second;
        const auto left = between(a, *middle, depth + 1);
        if (!left)
          return std::nullopt;
        const auto right = between(*middle, b, depth + 1);
        if (!right)
          return std::nullopt;
        return *left + *right;
      }

      CharacteristicEquation &equation;
    };
  } // namespace

  double RootRegion::least_angle() const
  {
    return kind == Kind::relaxes ? std::acos(-ratio) : 0.;
  }

  double RootRegion::largest_angle() const
  {
    return kind == Kind::relaxes ? PI : std::acos(-ratio);
  }

  bool RootRegion::contains(const std::complex<double> s) const
  {
    const double size    = std::abs(s);
    const bool   relaxes = -s.real() >= ratio * size;
    return size > inner && size < outer && relaxes == (kind == Kind::relaxes);
  }

  std::optional<unsigned int> n_roots(CharacteristicEquation &equation,
                                      const RootRegion       &region)
  {
    constexpr unsigned int around = 8;
    const double outer = std::log(region.outer), inner = std::log(region.inner);
    const auto   along =
      std::max(4u, static_cast<unsigned int>(2 * (outer - inner)));
    const Complex least(0., region.least_angle()),
      largest(0., region.largest_angle());
    struct Line
    {
      Complex      from, to;
      unsigned int n;
    };
    // Of the half above the real axis; below the argument changes alike.
    std::vector<Line> border = {{outer + least, outer + largest, around},
                                {inner + largest, inner + least, around}};
    if (region.kind == RootRegion::Kind::relaxes)
      border.push_back({inner + least, outer + least, along});
    else
      border.push_back({outer + largest, inner + largest, along});
    Argument argument(equation);
    double   sum = 0;
    for (const Line &line : border)
      {
        const auto part = argument.change(line.from, line.to, line.n);
        if (!part)
          return std::nullopt;
        sum += *part;
      }
    const double n = sum / PI;
    return n > -0.5 && std::abs(n - std::round(n)) < 0.1
      ? std::optional<unsigned int>(std::lround(n))
      : std::nullopt;
  }
} // namespace auxfem
