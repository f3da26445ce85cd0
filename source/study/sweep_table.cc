#include <auxfem/output/csv_table.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/quantities.h>
#include <auxfem/study/sweep_table.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** Members of summary.json that are no results of the analysis. */
    bool is_bookkeeping(const std::string &name)
    {
      static const std::set<std::string> names = {"counts",
                                                  "cpu_seconds",
                                                  "cpu_seconds_of_start",
                                                  "effects",
                                                  "end_time",
                                                  "peak_memory_bytes",
                                                  "size_metre",
                                                  "struts_of_section",
                                                  "time_reached",
                                                  "wall_seconds",
                                                  "warnings",
                                                  "work"};
      return names.count(name) > 0;
    }

    void add_numbers(const Json        &json,
                     const std::string &path,
                     NamedResults      &results)
    {
      if (json.is_number())
        results.emplace_back(path, json.get<double>());
      else if (json.is_object())
        for (const auto &member : json.items())
          add_numbers(member.value(), path + "." + member.key(), results);
      else if (json.is_array())
        for (std::size_t i = 0; i < json.size(); ++i)
          add_numbers(json[i], path + "." + std::to_string(i + 1), results);
    }
  } // namespace

  NamedResults results_in(const Json &summary)
  {
    NamedResults results;
    for (const auto &member : summary.items())
      if (!is_bookkeeping(member.key()))
        add_numbers(member.value(), member.key(), results);
    return results;
  }

  std::vector<std::string> short_names(const std::vector<std::string> &paths)
  {
    std::map<std::string, unsigned int> numbers;
    const auto last_part = [](const std::string &path) {
      return path.substr(path.rfind('.') + 1);
    };
    const auto is_index = [](const std::string &part) {
      return part.find_first_not_of("0123456789") == std::string::npos;
    };
    for (const std::string &path : paths)
      ++numbers[last_part(path)];
    std::vector<std::string> names;
    for (const std::string &path : paths)
      {
        const std::string part = last_part(path);
        names.push_back(is_index(part) || numbers[part] > 1 ? path : part);
      }
    return names;
  }

  Json summary_in(const std::string &folder)
  {
    std::ifstream stream(folder + "/summary.json");
    const Json    summary = Json::parse(stream, nullptr, false);
    return summary.is_discarded() ? Json() : summary;
  }

  namespace
  {
    const std::string sweep_file           = "sweep.csv",
                      sweep_reference_file = "sweep.units.csv";

    /** Quantities of the scene that are numbers, by the history in @p folder. */
    NamedResults quantities_of(const Scene &scene, const std::string &folder)
    {
      NamedResults results;
      if (scene.study.quantities.empty())
        return results;
      MeasuredRun run;
      run.exit_state              = "completed";
      const RecordedTable history = read_table(folder + "/history.csv");
      for (std::size_t i = 0; i < history.names.size(); ++i)
        run.columns[history.names[i]] = history.columns[i];
      for (const QuantityDefinition &quantity : scene.study.quantities)
        if (quantity.is_number() && run.columns.count(quantity.columns[0]) > 0)
          results.emplace_back(quantity.name,
                               value_of(quantity, run, {}).numbers[0]);
      return results;
    }

    std::string result_text(const std::map<std::string, double> &results,
                            const std::string                   &path)
    {
      const auto found = results.find(path);
      return found == results.end() ? "nan" : text_of_cell(found->second);
    }

    /** Common unit of the values of a parameter; empty if there is none. */
    std::string unit_of(const std::vector<SweepCase> &cases,
                        const unsigned int            parameter)
    {
      std::set<std::string> units;
      for (const SweepCase &one : cases)
        try
          {
            units.insert(split_quantity(one.values[parameter]).unit);
          }
        catch (const InputError &)
          {
            return "";
          }
      return units.size() == 1 ? *units.begin() : "";
    }

    /** @p value without @p unit at its end. */
    std::string without_unit(const std::string &value, const std::string &unit)
    {
      return unit.empty() ? value
                          : value.substr(0, value.size() - unit.size() - 1);
    }
  } // namespace

  std::vector<std::string> SweepTable::files()
  {
    return {sweep_file, sweep_reference_file};
  }

  void SweepTable::add(const SweepCase &one, const std::string &failure)
  {
    Row row;
    row.exit_state     = failure.substr(0, failure.find('\n'));
    const Json summary = summary_in(one.folder);
    if (failure.empty() && !summary.is_null())
      {
        row.verdict        = summary.value("verdict", "");
        row.exit_state     = summary.value("exit_state", "");
        NamedResults found = results_in(summary);
        for (const auto &quantity : quantities_of(scene, one.folder))
          found.push_back(quantity);
        for (const auto &[path, value] : found)
          if (row.results.emplace(path, value).second &&
              known.insert(path).second)
            paths.push_back(path);
      }
    rows.push_back(row);
  }

  void SweepTable::write(const std::vector<SweepCase> &cases) const
  {
    const std::vector<std::string> names  = short_names(paths);
    const std::vector<std::size_t> chosen = chosen_results(names);
    std::vector<Column>            columns;
    std::vector<std::string>       units;
    for (unsigned int p = 0; p < scene.sweep.parameters.size(); ++p)
      {
        units.push_back(unit_of(cases, p));
        columns.push_back({scene.sweep.parameters[p].name(),
                           units.back(),
                           scene.sweep.parameters[p].path});
      }
    for (const std::size_t i : chosen)
      columns.push_back({names[i], "", paths[i]});
    columns.push_back({"verdict", "", "on the results of the case"});
    columns.push_back({"exit_state", "", "completed, or why not"});
    columns.push_back({"case", "", "folder in cases"});
    const std::string folder = scene.output.directory + "/";
    CsvTable          table(folder + sweep_file, columns);
    write_column_reference(folder + sweep_reference_file, columns);
    for (std::size_t c = 0; c < cases.size(); ++c)
      {
        std::vector<std::string> cells;
        for (unsigned int p = 0; p < units.size(); ++p)
          cells.push_back(without_unit(cases[c].values[p], units[p]));
        for (const std::size_t i : chosen)
          cells.push_back(result_text(rows[c].results, paths[i]));
        cells.push_back(rows[c].verdict);
        cells.push_back(rows[c].exit_state);
        const std::string &case_folder = cases[c].folder;
        cells.push_back(case_folder.substr(case_folder.rfind('/') + 1));
        for (std::string &cell : cells)
          std::replace(cell.begin(), cell.end(), ',', ';');
        table.append_text(cells);
      }
  }

  std::vector<Finding> SweepTable::findings() const
  {
    std::size_t n_failed = 0, n_doubtful = 0;
    Verdict     worst = Verdict::sound;
    for (const Row &row : rows)
      if (row.exit_state != "completed")
        {
          ++n_failed;
          worst = std::max(worst, Verdict::doubtful);
        }
      else if (row.verdict != name_of(Verdict::sound))
        {
          ++n_doubtful;
          worst = std::max(worst,
                           row.verdict == name_of(Verdict::doubtful)
                             ? Verdict::doubtful
                             : Verdict::not_to_be_used);
        }
    if (worst == Verdict::sound)
      return {};
    std::ostringstream text;
    text << "Of " << rows.size() << " cases, " << n_failed
         << " are not complete and " << n_doubtful
         << " have results that are not sound: see verdict and exit_state in "
         << sweep_file << ", and the summaries in the folders of the cases.";
    return {{worst, text.str(), 0, ""}};
  }

  std::vector<std::size_t>
  SweepTable::chosen_results(const std::vector<std::string> &names) const
  {
    std::vector<std::size_t> chosen;
    if (scene.sweep.results.empty())
      for (std::size_t i = 0; i < paths.size(); ++i)
        chosen.push_back(i);
    for (const std::string &wanted : scene.sweep.results)
      {
        const std::size_t before = chosen.size();
        for (std::size_t i = 0; i < paths.size(); ++i)
          if (wanted == paths[i] || wanted == names[i])
            chosen.push_back(i);
        if (chosen.size() == before && !paths.empty())
          throw InputError("Sampling/Results: no case has a result \"" +
                           wanted + "\". Allowed: " + joined(names, 60));
      }
    return chosen;
  }
} // namespace auxfem
