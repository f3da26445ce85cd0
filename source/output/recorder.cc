#include <auxfem/output/recorder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/step_ends.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

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

  OutputTimes::OutputTimes(const std::optional<double> interval,
                           const double                nearness)
    : interval(interval)
    , nearness(nearness)
  {}

  std::optional<double> OutputTimes::after(const double time) const
  {
    if (!interval)
      return {};
    double number = std::floor(time / *interval) + 1;
    // The quotient of a time just below a multiple may be rounded up.
    if ((number - 1) * *interval > time)
      --number;
    return number * *interval;
  }

  bool OutputTimes::has(const double time) const
  {
    if (!interval)
      return false;
    return std::abs(time - std::round(time / *interval) * *interval) <=
      2 * nearness;
  }

  MemoryRecorder::MemoryRecorder(const Scene   &scene,
                                 const MPI_Comm communicator)
    : scene(scene)
    , communicator(communicator)
    , row_times(scene.output.row_interval, step_end_tolerance(scene.time))
  {}

  void MemoryRecorder::begin(const Equations &equations)
  {
    history.emplace(scene, equations, communicator);
    column_list = history->columns();
    row_list.clear();
  }

  void MemoryRecorder::step(const Solution &solution,
                            const StepReport & /*report*/)
  {
    if (scene.output.row_interval)
      history->note(solution.state);
    else
      row_list.push_back(history->values(solution));
  }

  std::vector<double> MemoryRecorder::column(const std::string &name) const
  {
    const auto position = std::find_if(column_list.begin(),
                                       column_list.end(),
                                       [&name](const Column &candidate) {
                                         return candidate.name == name;
                                       });
    if (position == column_list.end())
      throw InputError("The history of " + scene.file + " has no column '" +
                       name + "'.");
    std::vector<double> numbers;
    numbers.reserve(row_list.size());
    for (const std::vector<double> &row : row_list)
      numbers.push_back(row[position - column_list.begin()]);
    return numbers;
  }
} // namespace auxfem
