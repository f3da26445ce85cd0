#include <auxfem/output/order_report.h>

#include <cstdio>

namespace auxfem
{
  std::string order_search_text(const OrderReport &report)
  {
    char text[300];
    std::snprintf(text,
                  sizeof(text),
                  "Elements found by a search run of %lu steps with %u "
                  "unknowns (%.2f CPU s), for an error of %.1e "
                  "(tolerance %.1e)",
                  report.steps,
                  report.unknowns,
                  report.cpu_seconds,
                  report.predicted_error,
                  report.tolerance);
    return text;
  }

  std::string mesh_error_text(const OrderReport &report)
  {
    if (!report.estimated_error)
      return "";
    char text[200];
    std::snprintf(text,
                  sizeof(text),
                  "Error of the elements, estimated: %.1e "
                  "(tolerance %.1e; estimates took %.2f CPU s)",
                  *report.estimated_error,
                  report.tolerance,
                  report.cpu_seconds_of_estimates);
    return text;
  }

  Json json_of(const OrderReport &report)
  {
    Json json = {{"tolerance", report.tolerance},
                 {"predicted_error", report.predicted_error},
                 {"search",
                  {{"unknowns", report.unknowns},
                   {"steps", report.steps},
                   {"iterations", report.iterations},
                   {"cpu_seconds", report.cpu_seconds},
                   {"reached_time", report.reached}}},
                 {"cpu_seconds_of_estimates", report.cpu_seconds_of_estimates}};
    if (report.estimated_error)
      json["estimated_error"] = *report.estimated_error;
    return json;
  }
} // namespace auxfem
