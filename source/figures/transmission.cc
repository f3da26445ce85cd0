#include <auxfem/figures/cfc_filter.h>
#include <auxfem/figures/transmission.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include <fftw3.h>

namespace auxfem
{
  namespace
  {
    RecordedHistory part_of(const RecordedHistory     &history,
                            const TransmissionOptions &options)
    {
      RecordedHistory part;
      for (std::size_t i = 0; i < history.times.size(); ++i)
        if (history.times[i] >= options.from && history.times[i] <= options.to)
          {
            part.times.push_back(history.times[i]);
            part.values.push_back(history.values[i]);
          }
      return part;
    }

    /** Number of equal intervals that resolve @p history. */
    std::size_t n_equal_intervals(const RecordedHistory &history)
    {
      const std::vector<double> &times = history.times;
      if (is_equally_spaced(history))
        return times.size() - 1;
      // Very short steps, as at events, would ask for too many intervals.
      constexpr std::size_t most_per_row = 16;
      return std::min<std::size_t>(std::ceil((times.back() - times.front()) /
                                             shortest_interval(history)),
                                   most_per_row * times.size());
    }

    double root_mean_square(const std::vector<double> &values)
    {
      double sum = 0;
      for (const double value : values)
        sum += value * value;
      return std::sqrt(sum / values.size());
    }

    /** Weights of the periodic Hann window, whose mean is one. */
    double hann_weight(const std::size_t i, const std::size_t n)
    {
      return 1 - std::cos(2 * dealii::numbers::PI * i / n);
    }

    /**
     * Complex amplitudes of @p values, which last over n intervals: the last of
     * the n + 1 values is where the period would begin again.
     */
    std::vector<std::complex<double>> amplitudes(std::vector<double> values,
                                                 const bool hann_window)
    {
      values.pop_back();
      const std::size_t n = values.size();
      if (hann_window)
        for (std::size_t i = 0; i < n; ++i)
          values[i] *= hann_weight(i, n);
      std::vector<std::complex<double>> result(n / 2 + 1);
      // FFTW's complex numbers have the layout of std::complex.
      fftw_plan plan =
        fftw_plan_dft_r2c_1d(n,
                             values.data(),
                             reinterpret_cast<fftw_complex *>(result.data()),
                             FFTW_ESTIMATE);
      fftw_execute(plan);
      fftw_destroy_plan(plan);
      for (std::size_t k = 0; k < result.size(); ++k)
        result[k] *= (k == 0 || 2 * k == n ? 1. : 2.) / n;
      return result;
    }

    std::vector<TransmissionLine> spectrum(const RecordedHistory     &input,
                                           const RecordedHistory     &output,
                                           const TransmissionOptions &options)
    {
      const auto   in      = amplitudes(input.values, options.hann_window);
      const auto   out     = amplitudes(output.values, options.hann_window);
      const double length  = input.times.back() - input.times.front();
      double       largest = 0;
      for (const std::complex<double> &amplitude : in)
        largest = std::max(largest, std::abs(amplitude));
      constexpr double              least_part = 1e-3;
      std::vector<TransmissionLine> lines;
      for (std::size_t k = 0;
           k < in.size() && k / length <= options.largest_frequency;
           ++k)
        {
          TransmissionLine line{k / length, in[k], out[k], {}};
          if (std::abs(in[k]) > least_part * largest)
            line.ratio = out[k] / in[k];
          lines.push_back(line);
        }
      return lines;
    }

    std::optional<double> quotient(const double output, const double input)
    {
      return input == 0 ? std::nullopt : std::optional(output / input);
    }
  } // namespace

  std::optional<double> Transmission::peak_ratio() const
  {
    return quotient(std::abs(output_peak.value), std::abs(input_peak.value));
  }

  std::optional<double> Transmission::rms_ratio() const
  {
    return quotient(output_rms, input_rms);
  }

  const TransmissionLine *Transmission::main_line() const
  {
    const TransmissionLine *largest = nullptr;
    for (std::size_t k = 1; k < spectrum.size(); ++k)
      if (spectrum[k].ratio &&
          (largest == nullptr ||
           std::abs(spectrum[k].input) > std::abs(largest->input)))
        largest = &spectrum[k];
    return largest;
  }

  std::optional<Transmission>
  transmission_between(const RecordedHistory     &input,
                       const RecordedHistory     &output,
                       const TransmissionOptions &options)
  {
    constexpr std::size_t least_times = 4;
    const RecordedHistory in          = part_of(input, options),
                          out         = part_of(output, options);
    if (in.times.size() < least_times)
      return std::nullopt;
    Transmission result;
    result.input_peak       = peak_of(in);
    result.output_peak      = peak_of(out);
    const std::size_t     n = n_equal_intervals(in);
    const RecordedHistory x = at_equal_intervals(in, n),
                          y = at_equal_intervals(out, n);
    result.input_rms        = root_mean_square(x.values);
    result.output_rms       = root_mean_square(y.values);
    result.spectrum         = spectrum(x, y, options);
    return result;
  }
} // namespace auxfem
