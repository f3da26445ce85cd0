#ifndef auxfem_output_order_report_h
#define auxfem_output_order_report_h

#include <auxfem/output/verdict.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** A sentence on how the elements were found, without the last line break. */
  std::string order_search_text(const OrderReport &report);

  /** A sentence on what the run says of their error, without the last line
   * break. */
  std::string mesh_error_text(const OrderReport &report);

  /** All of it for summary.json. */
  Json json_of(const OrderReport &report);
} // namespace auxfem

#endif
