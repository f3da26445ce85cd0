#include <auxfem/study/study_report.h>
#include <auxfem/study/tried_values.h>
#include <auxfem/time/schemes.h>

#include <cmath>
#include <cstdio>

namespace auxfem
{
  namespace
  {
    std::string padded(const std::string &text, const std::size_t width)
    {
      return std::string(width - std::min(width, text.size()), ' ') + text;
    }

    std::string
    formatted(const char *pattern, const double number, const int precision)
    {
      char text[40];
      std::snprintf(text, sizeof(text), pattern, precision, number);
      return text;
    }
  } // namespace



  std::string TextTable::markdown() const
  {
    std::vector<std::size_t> widths(header.size(), 3);
    const auto               widen = [&widths](const auto &row) {
      for (std::size_t i = 0; i < row.size(); ++i)
        widths[i] = std::max(widths[i], row[i].size());
    };
    widen(header);
    for (const auto &row : rows)
      widen(row);

    std::string text;
    const auto  add = [&text, &widths](const auto &row) {
      text += "|";
      for (std::size_t i = 0; i < row.size(); ++i)
        text += " " + padded(row[i], widths[i]) + " |";
      text += '\n';
    };
    add(header);
    text += "|";
    for (const std::size_t width : widths)
      text += " " + std::string(width - 1, '-') + ": |";
    text += '\n';
    for (const auto &row : rows)
      add(row);
    return text;
  }



  std::string error_text(const std::optional<double> &error)
  {
    return error ? formatted("%.*e", *error, 2) : "-";
  }



  std::string decimal_text(const std::optional<double> &number,
                           const unsigned int           digits)
  {
    return number ? formatted("%.*f", *number, digits) : "-";
  }



  std::string seconds_text(const double seconds)
  {
    return formatted("%.*g", seconds, 3);
  }



  std::string first_line(const std::string &text)
  {
    return text.substr(0, text.find('\n'));
  }



  std::string percent_text(const std::optional<double> &part)
  {
    // -0.2 % is no number for people.
    const double whole = part ? std::round(100 * *part) : 0;
    return part ? decimal_text(whole == 0 ? 0 : whole, 0) + " %" : "-";
  }



  std::string number_text(const std::optional<double> &number)
  {
    return number ? short_number(*number) : "";
  }



  std::vector<Column> columns_of_settings(const Scene &scene)
  {
    std::vector<Column> columns;
    if (has_mesh(scene))
      columns = {{"order", "", "polynomial order of the struts' elements"},
                 {"elements", "", "elements a strut"}};
    columns.insert(columns.end(),
                   {{"time_step", "s", "time step"},
                    {"relative_tolerance", "1", "Time/Relative tolerance"},
                    {"newton_tolerance", "1", "Newton/Tolerance"},
                    {"scheme", "", "Time/Scheme"}});
    return columns;
  }



  std::vector<std::string> cells_of(const Settings &settings,
                                    const Scene    &scene)
  {
    std::vector<std::string> cells;
    if (has_mesh(scene))
      cells = {std::to_string(settings.order),
               std::to_string(settings.elements())};
    cells.insert(cells.end(),
                 {short_number(settings.time_step),
                  number_text(settings.time_tolerance),
                  short_number(settings.newton_tolerance),
                  settings.scheme});
    return cells;
  }



  std::vector<Column> columns_of_run()
  {
    return {{"unknowns", "", "free unknowns"},
            {"steps", "", "steps done"},
            {"iterations", "", "Newton iterations, or evaluations"},
            {"factorizations", "", "factorizations of the tangent"},
            {"cpu", "s", "processor time of all ranks"},
            {"wall", "s", "wall time"},
            {"memory", "byte", "peak memory of the process, or sum of ranks"},
            {"verdict", "", "how far the run can be relied on"},
            {"exit", "", "completed, or why it ended early"}};
  }



  std::vector<std::string> cells_of(const MeasuredRun &run)
  {
    return {std::to_string(run.unknowns),
            std::to_string(run.steps),
            std::to_string(run.iterations),
            std::to_string(run.factorizations),
            short_number(run.cpu_seconds),
            short_number(run.wall_seconds),
            std::to_string(run.memory),
            name_of(run.verdict),
            run.exit_state};
  }



  unsigned int colour_of_order(const unsigned int order)
  {
    return order - 1;
  }



  unsigned int colour_of_scheme(const std::string &scheme)
  {
    const auto &registry = time_scheme_registry();
    return std::find_if(registry.begin(),
                        registry.end(),
                        [&scheme](const TimeSchemeEntry &entry) {
                          return entry.name == scheme;
                        }) -
      registry.begin();
  }



  Finding unresolved(const QuantityDefinition &quantity)
  {
    return {
      Verdict::doubtful,
      "The reference does not resolve the quantity \"" + quantity.name +
        "\", whose own error is more than 10 %: as if it were zero but for "
        "round-off. It is left out of what is recommended; choose others "
        "in Quantities, or finer runs.",
      0,
      ""};
  }



  void add_finding(const Finding &finding, std::vector<Finding> &findings)
  {
    const bool is_there =
      std::any_of(findings.begin(), findings.end(), [&](const Finding &other) {
        return other.text == finding.text;
      });
    if (!is_there)
      findings.push_back(finding);
  }



  void add_finding_on_reference(const MeasuredRun    &reference,
                                const std::string    &what,
                                std::vector<Finding> &findings)
  {
    if (!reference.completed())
      add_finding({Verdict::not_to_be_used,
                   what + " failed, so that errors are not known: " +
                     first_line(reference.exit_state),
                   0,
                   ""},
                  findings);
    else if (reference.verdict != Verdict::sound)
      add_finding({reference.verdict,
                   what + " is itself " + name_of(reference.verdict) +
                     ". Run the scene with its settings to see why.",
                   0,
                   ""},
                  findings);
  }
} // namespace auxfem
