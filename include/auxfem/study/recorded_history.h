#ifndef auxfem_study_recorded_history_h
#define auxfem_study_recorded_history_h

#include <vector>

namespace auxfem
{
  /**
   * A quantity as a run has recorded it: values at increasing times, two at
   * least. What lies between them is taken from the polynomial through the
   * nearest ones, so that a comparison of runs does not see the steps of the
   * record, but the errors of the runs.
   */
  struct RecordedHistory
  {
    std::vector<double> times; ///< s
    std::vector<double> values;
  };

  /**
   * The value at @p time (s), which must not lie outside: one that was recorded
   * if there is one, else of the polynomial of fourth degree through the five
   * nearest (of lower degree through fewer, if there are no more).
   */
  double value_at(const RecordedHistory &history, double time);

  /** The largest value and its time. */
  struct Maximum
  {
    double time; ///< s
    double value;
  };

  /**
   * The maximum of the polynomial through the five values around the largest
   * one; the largest itself at either end of the record.
   */
  Maximum maximum_of(const RecordedHistory &history);

  /** The integral over all times, of cubic polynomials piece by piece. */
  double integral_of(const RecordedHistory &history);

  /** @p history with all values of the other sign. */
  RecordedHistory negative(RecordedHistory history);
} // namespace auxfem

#endif
