#ifndef auxfem_figures_figure_table_h
#define auxfem_figures_figure_table_h

#include <auxfem/figures/body_figures.h>
#include <auxfem/figures/recorded_table.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A figure of a body under the name it has in evaluation.csv and
   * summary.json. */
  struct BodyFigure
  {
    Column column;
    /** The figure of a body; empty if the body has none. */
    std::function<std::optional<double>(const BodyFigures &)> value;
    /** Heading on the screen; empty: it is in the files only. */
    std::string heading = {};
  };

  /** All figures of bodies, in the order of the columns. Accelerations are in
   * standard gravities, 9.80665 m/s2. */
  const std::vector<BodyFigure> &body_figure_columns();
} // namespace auxfem

#endif
