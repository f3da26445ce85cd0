#include <auxfem/output/csv_table.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/reduced_cell/comparison.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>

namespace auxfem
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double largest(const CellHistory &history, double CellSample::*quantity)
    {
      double result = 0;
      for (const CellSample &sample : history.samples)
        result = std::max(result, std::abs(sample.*quantity));
      return result;
    }

    /**
     * Largest difference; the reference is 1 at its largest. Not a number
     * unless both have come to the end.
     */
    double difference(const CellHistory &history,
                      const CellHistory &reference,
                      double CellSample::*quantity)
    {
      if (history.exit_state != "completed" ||
          reference.exit_state != "completed")
        return unknown;
      double result = 0;
      for (std::size_t i = 0; i < reference.samples.size(); ++i)
        {
          const double off = std::abs(history.samples[i].*quantity -
                                      reference.samples[i].*quantity);
          if (std::isnan(off))
            return unknown;
          result = std::max(result, off);
        }
      const double scale = largest(reference, quantity);
      return scale > 0 ? result / scale : unknown;
    }

    double relative_balance(const CellHistory &history)
    {
      EnergyRecord record;
      for (const CellSample &sample : history.samples)
        record.add(sample.energies);
      return record.relative(record.largest_balance);
    }

    /** The time history of @p scene with the scheme @p name in place of its own. */
    CellHistory history_with(const std::string &name, const Scene &scene)
    {
      try
        {
          return compute_history(read_scene_from_text(scene.all_parameters,
                                                      scene.file,
                                                      {"Time/Scheme=" + name}));
        }
      catch (const InputError &error)
        {
          CellHistory none;
          none.exit_state = error.what();
          return none;
        }
    }

    /** All schemes that a reduced cell may have, that of the reference first.
     */
    std::vector<std::string> compared_schemes()
    {
      std::vector<std::string> names = {arkode_entry().name};
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        if (entry.serves(Model::reduced_cell) && entry.name != names.front())
          names.push_back(entry.name);
      return names;
    }

    ComparisonRow make_row(const Scene       &scene,
                           const std::string &scheme,
                           const CellHistory &history,
                           const CellHistory &reference)
    {
      ComparisonRow row;
      row.name         = std::filesystem::path(scene.file).stem();
      row.scheme       = scheme;
      row.exit_state   = history.exit_state;
      const bool began = !history.samples.empty();
      row.angle        = began ? history.samples.back().angle : unknown;
      row.lower_rise   = began ? history.samples.back().lower_rise : unknown;
      row.transmitted  = began ? history.samples.back().transmitted : unknown;
      row.largest_transmitted =
        began ? largest(history, &CellSample::transmitted) : unknown;
      row.relative_balance = began ? relative_balance(history) : unknown;
      row.angle_difference = difference(history, reference, &CellSample::angle);
      row.transmitted_difference =
        difference(history, reference, &CellSample::transmitted);
      return row;
    }

    const std::vector<Column> columns = {
      {"case", "", "parameter file"},
      {"scheme", "", "Time/Scheme"},
      {"theta_end", "deg", "angle at the end"},
      {"Y2_end", "m", "rise of the lower part at the end"},
      {"f2_end", "N", "force on the foundation at the end"},
      {"f2_largest", "N", "its largest size"},
      {"relative_balance", "1", "error of the energy balance"},
      {"theta_difference", "1", "largest difference from arkode"},
      {"f2_difference", "1", "largest difference from arkode"},
      {"exit", "", "completed, or why it ended early"}};

    std::vector<std::string> cells_of(const ComparisonRow &row)
    {
      const auto number = [](const char *pattern, const double value) {
        char text[40];
        std::snprintf(text, sizeof(text), pattern, value);
        return std::string(std::isnan(value) ? "nan" : text);
      };
      return {row.name,
              row.scheme,
              number("%.9g", degrees(row.angle)),
              number("%.9g", row.lower_rise),
              number("%.9g", row.transmitted),
              number("%.9g", row.largest_transmitted),
              number("%.2e", row.relative_balance),
              number("%.2e", row.angle_difference),
              number("%.2e", row.transmitted_difference),
              row.exit_state};
    }

    /** One line of the table on the screen. */
    void print(const std::vector<std::string> &cells)
    {
      static const std::vector<int> widths =
        {-16, -19, 14, 15, 14, 14, 17, 17, 14};
      for (unsigned int i = 0; i < widths.size(); ++i)
        std::cout << (widths[i] < 0 ? std::left : std::right)
                  << std::setw(std::abs(widths[i])) << cells[i] << ' ';
      // a reason may have several lines; the first says what happened
      const std::string &last = cells.back();
      std::cout << ' ' << last.substr(0, last.find('\n')) << '\n' << std::right;
    }
  } // namespace

  std::vector<ComparisonRow> compare_schemes(const Scene &scene)
  {
    std::vector<ComparisonRow> rows;
    CellHistory                reference;
    for (const std::string &scheme : compared_schemes())
      {
        const CellHistory history = history_with(scheme, scene);
        if (rows.empty())
          reference = history;
        rows.push_back(make_row(scene, scheme, history, reference));
      }
    return rows;
  }

  void run_comparison(const std::vector<Scene> &scenes,
                      const std::string        &folder,
                      const FileRules          &rules)
  {
    for (const Scene &scene : scenes)
      if (scene.context.model != Model::reduced_cell)
        throw InputError(scene.file +
                         ": --compare is for scenes with Model = reduced cell");
    FileRules with_inputs = rules;
    for (const Scene &scene : scenes)
      with_inputs = with_inputs_of(scene, with_inputs);
    const OutputFolder claim(folder,
                             {{"comparison.csv", "comparison.units.csv"}, {}},
                             with_inputs);
    const std::string  file = folder + "/comparison.csv";
    CsvTable           table(file, columns);
    write_column_reference(folder + "/comparison.units.csv", columns);

    std::vector<std::string> names;
    names.reserve(columns.size());
    for (const Column &column : columns)
      names.push_back(column.name +
                      (column.unit.empty() ? "" : " (" + column.unit + ")"));
    print(names);
    for (const Scene &scene : scenes)
      for (const ComparisonRow &row : compare_schemes(scene))
        {
          const std::vector<std::string> cells = cells_of(row);
          print(cells);
          table.append_text(cells);
        }
    std::cout << "The table is in " << file << std::endl;
  }
} // namespace auxfem
