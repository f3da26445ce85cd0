#ifndef auxfem_output_order_report_h
#define auxfem_output_order_report_h

#include <auxfem/output/verdict.h>

#include <optional>

namespace auxfem
{
  /** What came of `Discretization/Order = auto`. */
  struct OrderReport
  {
    double tolerance = 0;
    /** Of the motion of joints, in the energy norm, by the search run. */
    double predicted_error = 0;
    /** The same by the run itself; none before its end. */
    std::optional<double> estimated_error = {};
    /** @name The search run. */
    ///@{
    unsigned int  unknowns = 0;
    unsigned long steps = 0, iterations = 0;
    double        cpu_seconds = 0; ///< with the choice, over all ranks
    double        reached     = 0; ///< time (s), less than the end if it failed
    ///@}
    /** Of estimates during the run, over all ranks. */
    double cpu_seconds_of_estimates = 0;
  };

  /** A sentence on how the elements were found, without the last line break. */
  std::string order_search_text(const OrderReport &report);

  /** A sentence on what the run says of their error, without the last line
   * break. */
  std::string mesh_error_text(const OrderReport &report);

  /** All of it for summary.json. */
  Json json_of(const OrderReport &report);
} // namespace auxfem

#endif
