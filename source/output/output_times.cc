#include <auxfem/output/output_times.h>

#include <cmath>

namespace auxfem
{
  OutputTimes::OutputTimes(const std::optional<double> interval,
                           const double                nearness)
    : interval(interval)
    , nearness(nearness)
  {}

  std::optional<double> OutputTimes::after(const double time) const
  {
    if (!interval)
      return {};
    double number = std::floor(time / *interval) + 1;
    // Of a time just below a multiple the quotient may be rounded up to it.
    if ((number - 1) * *interval > time)
      --number;
    return number * *interval;
  }

  bool OutputTimes::has(const double time) const
  {
    if (!interval)
      return false;
    return std::abs(time - std::round(time / *interval) * *interval) <=
      2 * nearness;
  }
} // namespace auxfem
