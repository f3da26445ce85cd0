#include <auxfem/output/csv_table.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/study/sweep_table.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string sweep_file           = "sweep.csv",
                      sweep_reference_file = "sweep.units.csv";

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

  void SweepTable::add(const CaseResults &results)
  {
    Row row;
    row.verdict    = results.verdict;
    row.exit_state = results.exit_state;
    for (const auto &[path, value] : results.results)
      if (row.results.emplace(path, value).second && known.insert(path).second)
        paths.push_back(path);
    rows.push_back(row);
  }

  void SweepTable::write(const std::vector<SweepCase> &cases) const
  {
    const std::vector<std::string> names  = short_names(paths);
    const std::vector<std::size_t> chosen = chosen_results();
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
        const std::string &case_folder = cases[c].scene_case.folder;
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

  std::vector<std::size_t> SweepTable::chosen_results() const
  {
    std::vector<std::size_t> chosen;
    if (scene.sweep.results.empty())
      for (std::size_t i = 0; i < paths.size(); ++i)
        chosen.push_back(i);
    const std::map<std::string, std::size_t> positions =
      names_of_results(paths);
    for (const std::string &wanted : scene.sweep.results)
      {
        const auto found = positions.find(wanted);
        if (found != positions.end())
          chosen.push_back(found->second);
        else if (!paths.empty())
          throw InputError("Sampling/Results: no case has a result \"" +
                           wanted +
                           "\". Allowed: " + joined(short_names(paths), 60));
      }
    return chosen;
  }
} // namespace auxfem
