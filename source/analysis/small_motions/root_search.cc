#include <auxfem/analysis/small_motions/complex_shape.h>
#include <auxfem/analysis/small_motions/root_search.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Complex = RootSearch::Complex;

    /** Of Im s over |s|: what is less does not swing. */
    constexpr double least_swing = 1e-6;
  } // namespace

  RootSearch::RootSearch(CharacteristicEquation  &equation,
                         const UnknownLayout     &layout,
                         const RootRegion        &region,
                         const std::vector<Root> &known)
    : equation(equation)
    , layout(layout)
    , region(region)
    , roots(known)
    , n_given(known.size())
  {}

  unsigned int RootSearch::weight() const
  {
    unsigned int sum = 0;
    for (const Root &root : roots)
      if (region.contains(root.s))
        sum += weight(root);
    return sum;
  }

  /** Newton's method for det A, to four digits, with the roots that are known
   * divided out (Maehly 1954). */
  std::optional<Complex> RootSearch::newton(const Complex start)
  {
    constexpr unsigned int most_steps = 60;
    constexpr double       near = 1e-4, longest = 0.5;
    Complex                s = start;
    for (unsigned int i = 0; i < most_steps; ++i)
      {
        const auto here = equation.at(s);
        // A root itself, to the last digit.
        if (!here)
          return s;
        Complex slope = here->slope;
        for (const Root &root : roots)
          {
            if (s != root.s)
              slope -= 1. / (s - root.s);
            if (weight(root) == 2 && s != std::conj(root.s))
              slope -= 1. / (s - std::conj(root.s));
          }
        Complex change = 1. / slope;
        if (!std::isfinite(std::abs(change)))
          return std::nullopt;
        const double size = std::abs(change) / std::abs(s);
        if (size > longest)
          change *= longest / size;
        s -= change;
        if (std::abs(s) > 2 * region.outer || std::abs(s) < region.inner / 2)
          return std::nullopt;
        if (size <= near)
          return s;
      }
    return std::nullopt;
  }

  bool RootSearch::is_new(const Root &root) const
  {
    // Two roots that are about to be one have nearly one shape.
    constexpr double near = 1e-7;
    return std::none_of(roots.begin(), roots.end(), [&](const Root &known) {
      return std::abs(known.s - root.s) <= near * std::abs(root.s) &&
        are_parallel(layout, known.shape, root.shape);
    });
  }

  void RootSearch::find_from(const Complex start, const Way way)
  {
    constexpr double off = 1e-2;
    const auto       near =
      way == Way::deflation ? newton(start) : std::optional<Complex>(start);
    if (!near)
      return;
    const Complex guess(near->real(), std::abs(near->imag()));
    auto          root = equation.refine(guess, roots.size());
    if (!root ||
        (way == Way::deflation &&
         std::abs(root->s - guess) > off * std::abs(guess)))
      return;
    if (std::abs(root->s.imag()) <= least_swing * std::abs(root->s))
      root->s = root->s.real();
    else if (root->s.imag() < 0)
      return;
    if (is_new(*root))
      {
        turn_phase(layout, root->shape);
        roots.push_back(*root);
      }
  }

  void RootSearch::find(const unsigned int          n,
                        const std::vector<Complex> &starts)
  {
    for (const Complex start : starts)
      if (weight() < n)
        find_from(start, Way::deflation);
    // Points of a sequence that leaves no gaps.
    constexpr double   golden = 0.6180339887498949, other = 0.7548776662466927;
    const double       decades = std::log(region.outer / region.inner);
    const unsigned int most    = 10 + 4 * n;
    for (unsigned int i = 1; i <= most && weight() < n; ++i)
      {
        const double part  = std::pow(std::fmod(i * golden, 1.), 2),
                     angle = region.least_angle() +
          (region.largest_angle() - region.least_angle()) *
            std::fmod(i * other, 1.);
        const Complex start =
          std::polar(region.outer * std::exp(-part * decades), angle);
        find_from(start, Way::inverse_iteration);
        if (weight() < n)
          find_from(start, Way::deflation);
      }
  }

  std::vector<CharacteristicEquation::Root> RootSearch::found() const
  {
    std::vector<Root> inside;
    std::copy_if(roots.begin(),
                 roots.end(),
                 std::back_inserter(inside),
                 [this](const Root &root) { return region.contains(root.s); });
    std::sort(inside.begin(),
              inside.end(),
              [](const Root &one, const Root &other) {
                return std::abs(one.s) < std::abs(other.s);
              });
    return inside;
  }

  std::vector<CharacteristicEquation::Root> RootSearch::found_anew() const
  {
    std::vector<Root> inside;
    std::copy_if(roots.begin() + n_given,
                 roots.end(),
                 std::back_inserter(inside),
                 [this](const Root &root) { return region.contains(root.s); });
    return inside;
  }
} // namespace auxfem
