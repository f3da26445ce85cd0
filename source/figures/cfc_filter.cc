#include <auxfem/figures/cfc_filter.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  CfcFilter::CfcFilter(const double channel_class, const double interval)
    : channel_class(channel_class)
    , interval(interval)
  {
    // SAE J211-1, appendix C: the factor turns the class into the corner of one
    // pass, so that both passes have -3 dB at 5/3 of the class.
    constexpr double corner_over_class = 2.0775;
    corner = std::tan(dealii::numbers::PI * channel_class * corner_over_class *
                      interval);
    const double square      = corner * corner;
    const double root        = std::sqrt(2.) * corner;
    const double denominator = 1 + root + square;
    a0                       = square / denominator;
    a1                       = 2 * a0;
    a2                       = a0;
    b1                       = -2 * (square - 1) / denominator;
    b2                       = (-1 + root - square) / denominator;
  }

  double CfcFilter::gain(const double frequency) const
  {
    const double ratio =
      std::tan(dealii::numbers::PI * frequency * interval) / corner;
    return 1 / (1 + std::pow(ratio, 4));
  }

  template <class Iterator>
  void CfcFilter::pass(const Iterator begin, const Iterator end) const
  {
    double x1 = *begin, x2 = x1, y1 = x1, y2 = x1;
    for (Iterator sample = begin; sample != end; ++sample)
      {
        const double x = *sample;
        const double y = a0 * x + a1 * x1 + a2 * x2 + b1 * y1 + b2 * y2;
        x2             = x1;
        x1             = x;
        y2             = y1;
        y1             = y;
        *sample        = y;
      }
  }

  std::vector<double> CfcFilter::apply(const std::vector<double> &samples,
                                       std::size_t n_reflected) const
  {
    if (samples.size() < 2)
      return samples;
    n_reflected = std::min(n_reflected, samples.size() - 1);
    std::vector<double> values;
    values.reserve(samples.size() + 2 * n_reflected);
    const std::size_t last = samples.size() - 1;
    for (std::size_t i = n_reflected; i > 0; --i)
      values.push_back(2 * samples[0] - samples[i]);
    values.insert(values.end(), samples.begin(), samples.end());
    for (std::size_t i = 1; i <= n_reflected; ++i)
      values.push_back(2 * samples[last] - samples[last - i]);
    pass(values.begin(), values.end());
    pass(values.rbegin(), values.rend());
    return {values.begin() + n_reflected, values.end() - n_reflected};
  }

  std::vector<double> CfcFilter::apply(const std::vector<double> &samples) const
  {
    const double period = 0.6 / channel_class;
    return apply(samples, std::ceil(period / interval));
  }

  bool is_equally_spaced(const RecordedHistory &history)
  {
    const std::vector<double> &times  = history.times;
    const double               length = times.back() - times.front(),
                 step                 = length / (times.size() - 1);
    for (std::size_t i = 0; i < times.size(); ++i)
      // Times in files are rounded.
      if (std::abs(times[i] - times[0] - i * step) > 1e-6 * step)
        return false;
    return true;
  }

  double shortest_interval(const RecordedHistory &history)
  {
    const std::vector<double> &times    = history.times;
    double                     shortest = times.back() - times.front();
    for (std::size_t i = 1; i < times.size(); ++i)
      if (times[i] > times[i - 1])
        shortest = std::min(shortest, times[i] - times[i - 1]);
    return shortest;
  }

  RecordedHistory at_equal_intervals(const RecordedHistory &history,
                                     const std::size_t      n)
  {
    RecordedHistory result;
    const double    begin = history.times.front(),
                 step     = (history.times.back() - begin) / n;
    std::size_t after     = 1;
    for (std::size_t i = 0; i <= n; ++i)
      {
        const double time = begin + i * step;
        while (after + 1 < history.times.size() && history.times[after] < time)
          ++after;
        const double from = history.times[after - 1], to = history.times[after];
        const double part =
          to > from ? std::min(1., (time - from) / (to - from)) : 1;
        result.times.push_back(time);
        result.values.push_back((1 - part) * history.values[after - 1] +
                                part * history.values[after]);
      }
    return result;
  }

  std::optional<RecordedHistory> filtered(const RecordedHistory &history,
                                          const double           channel_class)
  {
    const std::size_t n = history.times.size();
    if (n < 2)
      return std::nullopt;
    double longest = 0;
    for (std::size_t i = 1; i < n; ++i)
      longest = std::max(longest, history.times[i] - history.times[i - 1]);
    // Intervals may miss the limit by round-off.
    if (longest > (1 + 1e-6) * CfcFilter::longest_interval(channel_class))
      return std::nullopt;
    RecordedHistory result = history;
    if (!is_equally_spaced(history))
      {
        // Shorter intervals than a hundredth of a period show nothing more.
        const double interval =
          std::max(shortest_interval(history),
                   CfcFilter::longest_interval(channel_class) / 10);
        const double length = history.times.back() - history.times.front();
        result = at_equal_intervals(history, std::ceil(length / interval));
      }
    const double interval =
      (result.times.back() - result.times.front()) / (result.times.size() - 1);
    result.values = CfcFilter(channel_class, interval).apply(result.values);
    return result;
  }
} // namespace auxfem
