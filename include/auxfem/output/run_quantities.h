#ifndef auxfem_output_run_quantities_h
#define auxfem_output_run_quantities_h

#include <auxfem/figures/recorded_table.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>

#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Name and value of a result. */
  using NamedResults = std::vector<std::pair<std::string, double>>;

  /**
   * Value of @p quantity, a number, in the @p history of its column: in the
   * column's SI unit, for times in that of time, for integrals in their
   * product, for mean square deviations in the square. NaN where the history
   * does not reach its time or target.
   */
  double number_of(const QuantityDefinition &quantity,
                   const RecordedHistory    &history);

  /** Throws InputError if @p quantity needs a column that is none of @p
   * columns. */
  void require_columns(const QuantityDefinition       &quantity,
                       const std::vector<std::string> &columns);

  /** require_columns() for all quantities of @p scene. */
  void require_quantities(const Scene                    &scene,
                          const std::vector<std::string> &columns);

  /** Quantities of @p scene that are numbers, in @p history; none without rows.
   * Throws InputError for a missing column. */
  NamedResults quantities_in(const Scene &scene, const RecordedTable &history);

  /** @p quantities as a member of summary.json; null if there are none. */
  Json json_of_quantities(const NamedResults &quantities);

  /** A line for the screen on each of @p quantities of @p scene. */
  std::string text_of_quantities(const NamedResults        &quantities,
                                 const Scene               &scene,
                                 const std::vector<Column> &columns);
} // namespace auxfem

#endif
