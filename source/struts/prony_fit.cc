#include <auxfem/mathematics/non_negative_least_squares.h>
#include <auxfem/struts/prony_fit.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace auxfem
{
  namespace
  {
    /** Relaxation times (s) that cover the frequencies of @p measured, half as
     * many as these. */
    std::vector<double>
    covering_times(const std::vector<MeasuredModulus> &measured)
    {
      const auto [lowest, highest] =
        std::minmax_element(measured.begin(),
                            measured.end(),
                            [](const MeasuredModulus &one,
                               const MeasuredModulus &other) {
                              return one.frequency < other.frequency;
                            });
      const double decades = std::log10(highest->frequency / lowest->frequency);
      const unsigned int  n = std::max<std::size_t>(1, measured.size() / 2);
      std::vector<double> times;
      for (unsigned int i = 0; i <= n; ++i)
        times.push_back(std::pow(10., decades * i / n) / highest->frequency);
      return times;
    }

    /** Complex modulus of a Maxwell element of unit stiffness. */
    std::complex<double> maxwell_modulus(const double frequency,
                                         const double time)
    {
      const std::complex<double> s_tau(0, frequency * time);
      return s_tau / (1. + s_tau);
    }
  } // namespace

  PronyFit fit_prony_series(const std::vector<MeasuredModulus> &measured)
  {
    const std::vector<double> times = covering_times(measured);
    // The first column is that of the modulus that does not relax.
    std::vector<std::vector<double>> columns(times.size() + 1);
    std::vector<double>              right_side;
    for (const MeasuredModulus &m : measured)
      {
        const double size = std::hypot(m.storage, m.loss);
        right_side.push_back(m.storage / size);
        right_side.push_back(m.loss / size);
        for (std::size_t j = 0; j < columns.size(); ++j)
          {
            const std::complex<double> modulus =
              j == 0 ? 1. : maxwell_modulus(m.frequency, times[j - 1]);
            columns[j].push_back(modulus.real() / size);
            columns[j].push_back(modulus.imag() / size);
          }
      }
    const std::vector<double> moduli =
      non_negative_least_squares(columns, right_side);

    PronyFit fit = {};
    for (const double modulus : moduli)
      fit.instantaneous_modulus += modulus;
    for (std::size_t j = 0; j < times.size(); ++j)
      if (moduli[j + 1] > 0)
        fit.parts[times[j]] = moduli[j + 1] / fit.instantaneous_modulus;
    double sum = 0;
    for (const MeasuredModulus &m : measured)
      {
        std::complex<double> modulus = moduli[0];
        for (std::size_t j = 0; j < times.size(); ++j)
          modulus += moduli[j + 1] * maxwell_modulus(m.frequency, times[j]);
        const double error =
          std::abs(modulus - std::complex<double>(m.storage, m.loss)) /
          std::hypot(m.storage, m.loss);
        sum += error * error;
        if (error > fit.largest_error)
          {
            fit.largest_error   = error;
            fit.worst_frequency = m.frequency;
          }
      }
    fit.rms_error = std::sqrt(sum / measured.size());
    return fit;
  }
} // namespace auxfem
