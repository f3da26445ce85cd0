#include <auxfem/contact/contact_law.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  double ContactLaw::force(const double depth) const
  {
    if (depth <= 0)
      return 0;
    return depth < smoothing ? stiffness * depth * depth / (2 * smoothing)
                             : stiffness * (depth - smoothing / 2);
  }

  double ContactLaw::slope(const double depth) const
  {
    if (depth <= 0)
      return 0;
    return depth < smoothing ? stiffness * depth / smoothing : stiffness;
  }

  double ContactLaw::energy(const double depth) const
  {
    if (depth <= 0)
      return 0;
    return depth < smoothing
      ? stiffness * depth * depth * depth / (6 * smoothing)
      : stiffness *
        (depth * (depth - smoothing) / 2 + smoothing * smoothing / 6);
  }

  double ContactLaw::mean_force(const double from, const double to) const
  {
    const double low = std::min(from, to), high = std::max(from, to);
    if (!(high > low))
      return force(to);
    // Simpson's rule is exact on each piece of the law.
    const auto integral = [this](const double begin, const double end) {
      return begin < end ? (end - begin) / 6 *
          (force(begin) + 4 * force((begin + end) / 2) + force(end))
                         : 0.;
    };
    const double first  = std::max(low, 0.);
    const double middle = std::clamp(smoothing, first, std::max(first, high));
    return (integral(first, middle) + integral(middle, high)) / (high - low);
  }

  double ContactLaw::mean_slope(const double from, const double to) const
  {
    // Below this the difference of forces is mostly round-off.
    constexpr double digits = 1e-6;
    if (std::abs(to - from) <=
        digits * std::max({std::abs(to), std::abs(from), smoothing}))
      return slope((from + to) / 2) / 2;
    return (force(to) - mean_force(from, to)) / (to - from);
  }
} // namespace auxfem
