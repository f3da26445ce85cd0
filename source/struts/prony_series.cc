#include <auxfem/struts/prony_series.h>

#include <cmath>
#include <limits>

namespace auxfem
{
  PronySeries prony_series(const std::map<double, double> &parts)
  {
    PronySeries series{1, {}};
    for (const auto &[time, part] : parts)
      {
        series.terms.push_back({part, time});
        series.long_time -= part;
      }
    // Parts that add up to 1 in decimals leave a round-off.
    if (std::abs(series.long_time) <
        parts.size() * std::numeric_limits<double>::epsilon())
      series.long_time = 0;
    return series;
  }

  PronySeries series_of_youngs_modulus(const PronySeries &shear,
                                       const double       poissons_ratio)
  {
    // Over the instantaneous shear modulus: 3 K / G and E / G.
    const double bulk = 2 * (1 + poissons_ratio) / (1 - 2 * poissons_ratio),
                 youngs_modulus = 2 * (1 + poissons_ratio);
    const auto sum = [&](const double rate, const auto &term_value) {
      double total = 0;
      for (const PronySeries::Term &term : shear.terms)
        total += term_value(term, 1 - rate * term.time);
      return total;
    };
    // Both for s = -rate.
    const auto modulus = [&](const double rate) {
      return shear.long_time +
        sum(rate, [&](const PronySeries::Term &t, const double d) {
               return -t.ratio * rate * t.time / d;
             });
    };
    const auto slope = [&](const double rate) {
      return sum(rate, [](const PronySeries::Term &t, const double d) {
        return t.ratio * t.time / (d * d);
      });
    };
    PronySeries result{3 * bulk * shear.long_time / (bulk + shear.long_time) /
                         youngs_modulus,
                       {}};
    double      faster_than = 0;
    for (auto term = shear.terms.rbegin(); term != shear.terms.rend(); ++term)
      {
        double low = faster_than, high = 1 / term->time;
        faster_than = high;
        // The modulus falls from above -3 K to minus infinity.
        for (int i = 0; i < 200 && low < high; ++i)
          {
            const double middle = (low + high) / 2;
            if (middle == low || middle == high)
              break;
            (modulus(middle) + bulk > 0 ? low : high) = middle;
          }
        const double rate = (low + high) / 2;
        result.terms.push_back(
          {3 * bulk * bulk / (rate * slope(rate)) / youngs_modulus, 1 / rate});
      }
    return result;
  }
} // namespace auxfem
