#ifndef auxfem_figures_recorded_history_h
#define auxfem_figures_recorded_history_h

#include <vector>

namespace auxfem
{
  /**
   * Recorded quantity of a run: at least two values at increasing times. Values
   * in between are interpolated by polynomials, so that comparisons show the
   * errors of the runs and not the sampling. Studies compare such records.
   */
  struct RecordedHistory
  {
    std::vector<double> times; ///< s
    std::vector<double> values;
  };

  /**
   * Value at @p time (s) within the record: the recorded one if it exists, else
   * that of the polynomial through the five nearest values (fewer if there are
   * fewer).
   */
  double value_at(const RecordedHistory &history, double time);

  /** A maximum and its time. */
  struct Maximum
  {
    double time; ///< s
    double value;
  };

  /**
   * Maximum of the polynomial through the five values around the largest one;
   * at either end of the record, the largest value itself.
   */
  Maximum maximum_of(const RecordedHistory &history);

  /** Integral over all times, by piecewise cubic polynomials. */
  double integral_of(const RecordedHistory &history);

  /** @p history with the sign of all values changed. */
  RecordedHistory negative(RecordedHistory history);
} // namespace auxfem

#endif
