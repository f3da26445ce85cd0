#ifndef auxfem_study_quantities_h
#define auxfem_study_quantities_h

#include <auxfem/study/measured_run.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * What a study compares the runs of @p scene by: the quantities it defines,
   * else the displacements of its probes, else the strain energy; with the
   * reduced cell those of angle and force on the
   * foundation. Throws InputError for a column that is none of @p columns, those
   * of history.csv, and for a time after the end.
   */
  std::vector<QuantityDefinition>
  compared_quantities(const Scene                    &scene,
                      const std::vector<std::string> &columns);

  /** The columns they are computed from. */
  std::set<std::string>
  columns_of(const std::vector<QuantityDefinition> &quantities);

  /** A number, or the values of a history at the times of a comparison. */
  using QuantityValues = std::vector<double>;

  /**
   * @p quantity in @p run, which has been completed.
   * @param times of comparison for histories (s).
   */
  QuantityValues value_of(const QuantityDefinition  &quantity,
                          const MeasuredRun         &run,
                          const std::vector<double> &times);

  /** Its exact value, if that is known. */
  std::optional<QuantityValues>
  exact_value_of(const QuantityDefinition  &quantity,
                 double                     end_time,
                 const std::vector<double> &times);

  /** Largest difference between @p values and @p others; not a number if one of
   * them is none. */
  double largest_change(const QuantityValues &values,
                        const QuantityValues &others);

  /**
   * Largest difference between @p values and @p reference over the largest size
   * of the latter; the difference itself if that is zero; not a number if one
   * of them is none.
   */
  double relative_difference(const QuantityValues &values,
                             const QuantityValues &reference);

  /** Error of a reference from which on nothing is measured by it. */
  constexpr double unresolved_error = 0.1;

  /**
   * Times for histories: those of the completed one of @p runs that has fewest,
   * but for the start.
   */
  std::vector<double> times_of_comparison(const std::vector<MeasuredRun> &runs);
} // namespace auxfem

#endif
