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
   * What a study compares the runs of @p scene by: the quantities it defines,
   * else the displacements of its probes, else the strain energy; with the
   * reduced cell those of angle and force on the
   * foundation. Throws InputError for a column that is none of @p columns, those
   * of history.csv, for a time after the end, and for a norm of what the scene
   * does not have.
   */
  std::vector<QuantityDefinition>
  compared_quantities(const Scene                    &scene,
                      const std::vector<std::string> &columns);

  /** What they are computed from. */
  Selection selection_for(const std::vector<QuantityDefinition> &quantities,
                          double                                 end_time);

  /** A number, the values of a history or those of a field, where runs are
   * compared. */
  struct QuantityValues
  {
    std::vector<double> numbers;
    /** Whether the norm of numbers is the root of the sum of their squares, as
     * energies are sums, and not the largest. */
    bool is_field = false;
  };

  /** Where histories and fields of several runs are compared. */
  struct Comparison
  {
    std::vector<double> times; ///< s
    /** By the time of the field (s). */
    std::map<double, std::vector<FieldPoint>> points;
  };

  /**
   * At the times of the completed one of @p runs that has fewest, but for the
   * start; at the Gauss points of the one that has most.
   */
  Comparison comparison_of(const std::vector<MeasuredRun> &runs);

  /** @p quantity in @p run, which has been completed. */
  QuantityValues value_of(const QuantityDefinition &quantity,
                          const MeasuredRun        &run,
                          const Comparison         &comparison);

  /** Its exact value, if that is known. */
  std::optional<QuantityValues>
  exact_value_of(const QuantityDefinition &quantity,
                 double                    end_time,
                 const Comparison         &comparison);

  /** Norm of the difference between @p values and @p others; not a number if one
   * of them is none. */
  double norm_of_change(const QuantityValues &values,
                        const QuantityValues &others);

  /**
   * Norm of the difference between @p values and @p reference over that of the
   * latter; the difference itself if that is zero; not a number if one of them
   * is none.
   */
  double relative_difference(const QuantityValues &values,
                             const QuantityValues &reference);

  /**
   * Relative error from which on nothing is measured by a reference.
   * @tuned judgement
   */
  constexpr double unresolved_error = 0.1;
} // namespace auxfem

#endif
