#ifndef auxfem_figures_transmission_h
#define auxfem_figures_transmission_h

#include <auxfem/figures/body_figures.h>
#include <auxfem/figures/recorded_history.h>

#include <complex>
#include <limits>
#include <optional>
#include <vector>

namespace auxfem
{
  /** Choices in the evaluation of transmission, see TransmissionDefinition. */
  struct TransmissionOptions
  {
    double from = 0; ///< s; earlier values are left out
    /** s; later values are left out */
    double to = std::numeric_limits<double>::infinity();
    /** Whether the values are weighted by Hann's window, for vibrations that
     * do not end within the time. */
    bool hann_window = false;
    /** Highest frequency of the spectrum (Hz). */
    double largest_frequency = std::numeric_limits<double>::infinity();
  };

  /** A frequency of the discrete Fourier transforms of two histories. */
  struct TransmissionLine
  {
    double frequency; ///< Hz
    /** Complex amplitudes of the cosines exp(i 2 pi f t) of input and output.
     */
    std::complex<double> input, output;
    /** Output over input; empty where the input is below a thousandth of its
     * largest amplitude, so that the quotient shows round-off and leakage. */
    std::optional<std::complex<double>> ratio;
  };

  /** Transmission from an input to an output. */
  struct Transmission
  {
    Peak input_peak, output_peak;
    /** Root mean squares over time. */
    double                        input_rms = 0, output_rms = 0;
    std::vector<TransmissionLine> spectrum;

    /** Output over input peak; empty without input. */
    std::optional<double> peak_ratio() const;
    /** Output over input root mean square; empty without input. */
    std::optional<double> rms_ratio() const;
    /** Line of the largest input apart from the mean; nullptr if there is
     * none. */
    const TransmissionLine *main_line() const;
  };

  /**
   * Transmission between two histories with the same times, of which @p
   * options choose a part. Where intervals are unequal, both are interpolated
   * linearly to the shortest one. Empty if fewer than four times are left.
   */
  std::optional<Transmission>
  transmission_between(const RecordedHistory     &input,
                       const RecordedHistory     &output,
                       const TransmissionOptions &options);
} // namespace auxfem

#endif
