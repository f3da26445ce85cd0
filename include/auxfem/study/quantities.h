#ifndef auxfem_study_quantities_h
#define auxfem_study_quantities_h

#include <auxfem/study/measured_run.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Quantities by which a study compares runs of @p scene: those of the scene,
   * else probe displacements, else the strain energy; for the reduced cell
   * angle and foundation force. Throws InputError for a column missing in @p
   * columns (of history.csv), for a time after the end, and for an unavailable
   * norm.
   */
  std::vector<QuantityDefinition>
  compared_quantities(const Scene                    &scene,
                      const std::vector<std::string> &columns);

  /** Columns and fields needed for @p quantities. */
  Selection selection_for(const std::vector<QuantityDefinition> &quantities,
                          double                                 end_time);

  /**
   * Values of a quantity at the points of comparison: one number, a history or
   * a field.
   */
  struct QuantityValues
  {
    std::vector<double> numbers;
    /**
     * Whether the norm is the root of the sum of squares, as for energies,
     * instead of the maximum.
     */
    bool is_field = false;
  };

  /**
   * Times and points at which histories and fields of several runs are
   * compared.
   */
  struct Comparison
  {
    std::vector<double> times; ///< s
    /** Points, by time of the field (s). */
    std::map<double, std::vector<FieldPoint>> points;
  };

  /**
   * Uses the times of the completed run with the fewest, except the start, and
   * the Gauss points of the run with the most.
   */
  Comparison comparison_of(const std::vector<MeasuredRun> &runs);

  /** Value of @p quantity in @p run, which must be completed. */
  QuantityValues value_of(const QuantityDefinition &quantity,
                          const MeasuredRun        &run,
                          const Comparison         &comparison);

  /** Exact value of @p quantity, if known. */
  std::optional<QuantityValues>
  exact_value_of(const QuantityDefinition &quantity,
                 double                    end_time,
                 const Comparison         &comparison);

  /**
   * Norm of the difference between @p values and @p others; NaN if one is NaN.
   */
  double norm_of_change(const QuantityValues &values,
                        const QuantityValues &others);

  /**
   * Norm of the difference between @p values and @p reference over the norm of
   * @p reference, or the absolute norm if that is zero; NaN if one is NaN.
   */
  double relative_difference(const QuantityValues &values,
                             const QuantityValues &reference);

  /**
   * Relative error of a reference above which it measures nothing.
   * @tuned judgement
   */
  constexpr double unresolved_error = 0.1;
} // namespace auxfem

#endif
