#include <auxfem/analysis/small_motions/root_count.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

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

  bool RootRegion::contains(const std::complex<double> s) const
  {
    const double size = std::abs(s);
    return size > inner && size < outer && -s.real() < ratio * size;
  }

  std::optional<unsigned int> n_roots(CharacteristicEquation &equation,
                                      const RootRegion       &region)
  {
    // The half above the real axis; below the argument changes alike.
    const double  last = std::acos(-RootRegion::ratio);
    const Complex outer(std::log(region.outer), 0.),
      inner(std::log(region.inner), 0.), up(0., last);
    constexpr unsigned int around = 8;
    const auto             along =
      std::max(4u, static_cast<unsigned int>(2 * (outer - inner).real()));
    Argument   argument(equation);
    const auto outwards = argument.change(outer, outer + up, around);
    if (!outwards)
      return std::nullopt;
    const auto back = argument.change(outer + up, inner + up, along);
    if (!back)
      return std::nullopt;
    const auto inwards = argument.change(inner + up, inner, around);
    if (!inwards)
      return std::nullopt;
    const double n = (*outwards + *back + *inwards) / PI;
    return n > -0.5 && std::abs(n - std::round(n)) < 0.1
      ? std::optional<unsigned int>(std::lround(n))
      : std::nullopt;
  }
} // namespace auxfem
