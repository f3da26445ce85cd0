#ifndef auxfem_figures_cfc_filter_h
#define auxfem_figures_cfc_filter_h

#include <auxfem/figures/recorded_history.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * The low-pass filter of impact tests for a channel frequency class (CFC 60,
   * 180, 600, 1000): a Butterworth filter of second order that runs forwards,
   * then backwards, so that nothing is delayed (SAE J211-1, appendix C; ISO
   * 6487). It has -3 dB at 5/3 of the class in Hz.
   *
   * The standard leaves the start open. Here each end is continued by its odd
   * reflection, and each pass starts in the steady state of its first sample.
   */
  class CfcFilter
  {
  public:
    /**
     * @param channel_class in Hz
     * @param interval between samples (s), at most longest_interval()
     */
    CfcFilter(double channel_class, double interval);

    /** Longest interval between samples (s): a tenth of 1 / class. */
    static double longest_interval(const double channel_class)
    {
      return 0.1 / channel_class;
    }

    /** Ratio of amplitudes after and before both passes at @p frequency (Hz).
     */
    double gain(double frequency) const;

    /**
     * Filtered @p samples.
     * @param n_reflected samples of the reflection at each end
     */
    std::vector<double> apply(const std::vector<double> &samples,
                              std::size_t                n_reflected) const;

    /** As above, reflected for a period of the filter's corner frequency. */
    std::vector<double> apply(const std::vector<double> &samples) const;

  private:
    /** One pass along @p samples, in place. */
    template <class Iterator>
    void pass(Iterator begin, Iterator end) const;

    double channel_class, interval;
    /** tan(w T / 2) with the angular corner frequency w. */
    double corner;
    /** y_n = a0 x_n + a1 x_(n-1) + a2 x_(n-2) + b1 y_(n-1) + b2 y_(n-2) */
    double a0, a1, a2, b1, b2;
  };

  /**
   * @p history filtered by @p channel_class, at equal intervals. Where its own
   * are unequal, it is interpolated linearly. Empty if they are longer than
   * CfcFilter::longest_interval().
   */
  std::optional<RecordedHistory> filtered(const RecordedHistory &history,
                                          double                 channel_class);

  /** Whether the times of @p history have equal intervals, but for round-off.
   */
  bool is_equally_spaced(const RecordedHistory &history);

  /** Shortest interval between different times of @p history (s). */
  double shortest_interval(const RecordedHistory &history);

  /** @p history at @p n equal intervals, by linear interpolation. */
  RecordedHistory at_equal_intervals(const RecordedHistory &history,
                                     std::size_t            n);
} // namespace auxfem

#endif
