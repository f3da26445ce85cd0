#include <auxfem/optimization/optimization_report.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/summary.h>

#include <algorithm>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    const std::string design_reference_file = "optimization.units.csv",
                      front_reference_file  = "front.units.csv";
  } // namespace

  std::vector<std::string> optimization_files()
  {
    return {design_table_file,
            design_reference_file,
            front_table_file,
            front_reference_file,
            best_scene_file};
  }

  namespace
  {
    /** Name of a column with @p text, in which commas would separate. */
    std::string column_name(std::string text)
    {
      std::replace(text.begin(), text.end(), ',', ';');
      return text;
    }

    std::vector<Column> columns_of(const Scene &scene)
    {
      const OptimizationDefinition &optimization = scene.optimization;
      std::vector<Column> columns = {{"evaluation", "", "number of the run"}};
      for (std::size_t v = 0; v < optimization.variables.size(); ++v)
        columns.push_back({short_name(optimization, v),
                           optimization.variables[v].unit,
                           optimization.variables[v].path});
      for (const Objective &objective : optimization.objectives)
        columns.push_back({column_name(objective.expression),
                           "",
                           column_name(objective.text())});
      for (const ResultLimit &limit : optimization.limits)
        columns.push_back(
          {column_name(limit.expression), "", column_name(limit.text)});
      columns.push_back({"excess",
                         "",
                         "largest excess over a constraint as a part of its "
                         "limit; 0 or less: all are met"});
      columns.push_back({"best_so_far", "", "first objective"});
      columns.push_back({"verdict", "", "on the results of the run"});
      columns.push_back({"exit_state", "", "completed or why not"});
      columns.push_back({"design", "", "folder in designs"});
      return columns;
    }

    /** A table of @p designs. */
    void write_table(const Scene               &scene,
                     const Goals               &goals,
                     const std::vector<Design> &designs,
                     const std::string         &file,
                     const std::string         &reference)
    {
      const OptimizationDefinition &optimization = scene.optimization;
      const std::string             folder       = scene.output.directory + "/";
      const std::vector<Column>     columns      = columns_of(scene);
      CsvTable                      table(folder + file, columns);
      write_column_reference(folder + reference, columns);
      const Design *best = nullptr;
      for (std::size_t n = 0; n < designs.size(); ++n)
        {
          const Design            &design = designs[n];
          std::vector<std::string> cells  = {std::to_string(n + 1)};
          for (std::size_t v = 0; v < design.point.size(); ++v)
            cells.push_back(text_of_cell(
              optimization.variables[v].value_at(design.point[v])));
          const auto add = [&cells](const bool is_there, const double value) {
            cells.push_back(is_there ? text_of_cell(value) : "nan");
          };
          const bool is_there = design.goals.has_value();
          for (std::size_t i = 0; i < goals.objectives().size(); ++i)
            add(is_there, is_there ? design.goals->objectives[i] : 0);
          for (std::size_t i = 0; i < goals.limits().size(); ++i)
            add(is_there, is_there ? design.goals->limited[i] : 0);
          add(is_there, is_there ? goals.largest_excess(*design.goals) : 0);
          if (design.is_usable() && goals.meets_constraints(*design.goals) &&
              (best == nullptr ||
               is_better(design,
                         *best,
                         goals,
                         optimization.constraint_tolerance())))
            best = &design;
          add(best != nullptr,
              best != nullptr ? best->goals->objectives[0] : 0);
          cells.push_back(design.verdict);
          cells.push_back(column_name(
            design.exit_state.substr(0, design.exit_state.find('\n'))));
          cells.push_back(name_of(design));
          table.append_text(cells);
        }
    }

    void write_best_scene(const Scene              &scene,
                          const OptimizationResult &result,
                          const Goals              &goals)
    {
      std::vector<std::string> overrides =
        case_of_design(scene, result.best.point, scene.output.directory)
          .overrides;
      // The last assignments count: this run is to be looked at.
      const std::string folder = scene.output.directory;
      overrides.push_back("Output/Directory=" + folder + "/best");
      overrides.push_back(std::string("Output/Graphics=") +
                          (scene.output.graphics ? "true" : "false"));
      overrides.push_back("Output/Checkpoints=" +
                          std::to_string(scene.output.checkpoints));
      replace_file(folder + "/" + best_scene_file,
                   "# Best design of " + scene.file + "\n# " +
                     line_of(scene, goals, result.best) + "\n\n" +
                     scene_of_case(scene, overrides).changed_parameters);
    }

    Json json_of(const Scene                     &scene,
                 const Design                    &design,
                 const std::optional<GoalValues> &refined)
    {
      Json json = {{"design", name_of(design)}};
      for (std::size_t v = 0; v < design.point.size(); ++v)
        {
          const DesignVariable &variable   = scene.optimization.variables[v];
          json["variables"][variable.path] = variable.value_at(design.point[v]);
        }
      const auto add_goals = [&scene, &json](const std::string &name,
                                             const GoalValues  &goals) {
        for (std::size_t i = 0; i < goals.objectives.size(); ++i)
          json[name][scene.optimization.objectives[i].expression] =
            goals.objectives[i];
        for (std::size_t i = 0; i < goals.limited.size(); ++i)
          json[name][scene.optimization.limits[i].expression] =
            goals.limited[i];
      };
      if (design.goals)
        add_goals("results", *design.goals);
      if (refined)
        add_goals("results_refined", *refined);
      return json;
    }

    Json json_of(const Sensitivity &sensitivity)
    {
      return {{"derivative", sensitivity.derivative},
              {"error", sensitivity.error},
              {"elasticity", sensitivity.elasticity},
              {"elasticity_error", sensitivity.elasticity_error}};
    }

    Json json_of_sensitivities(const Scene              &scene,
                               const OptimizationResult &result)
    {
      Json json = Json::object();
      for (std::size_t v = 0; v < result.sensitivities.size(); ++v)
        if (const auto &found = result.sensitivities[v])
          {
            Json &one = json[scene.optimization.variables[v].path];
            for (std::size_t i = 0; i < found->objectives.size(); ++i)
              one[scene.optimization.objectives[i].expression] =
                json_of(found->objectives[i]);
            for (std::size_t i = 0; i < found->limited.size(); ++i)
              one[scene.optimization.limits[i].expression] =
                json_of(found->limited[i]);
          }
      return json;
    }
  } // namespace

  void write_designs(const Scene              &scene,
                     const OptimizationResult &result,
                     const Goals              &goals)
  {
    write_table(scene,
                goals,
                result.designs,
                design_table_file,
                design_reference_file);
    if (!result.front.empty())
      write_table(scene,
                  goals,
                  result.front,
                  front_table_file,
                  front_reference_file);
    write_best_scene(scene, result, goals);
  }

  void write_optimization(const Scene                &scene,
                          const OptimizationResult   &result,
                          const Goals                &goals,
                          const std::vector<Finding> &findings)
  {
    write_designs(scene, result, goals);
    Json json = json_of_run(scene, "completed", scene.time.end_time);
    json.erase("time_reached");
    json.erase("end_time");
    add_verdict(json, findings);
    Json &optimization             = json["optimization"];
    optimization["designs"]        = result.designs.size();
    optimization["failed_designs"] = result.n_failed();
    optimization["first"] = json_of(scene, result.first, result.refined_first);
    optimization["best"]  = json_of(scene, result.best, result.refined_best);
    if (result.best.goals)
      {
        const Gain gain      = gain_of(result, goals);
        optimization["gain"] = gain.value;
        if (gain.error)
          optimization["gain_error"] = *gain.error;
      }
    if (!result.sensitivities.empty())
      optimization["sensitivities"] = json_of_sensitivities(scene, result);
    if (!result.front.empty())
      optimization["designs_of_the_front"] = result.front.size();
    replace_file(scene.output.directory + "/summary.json",
                 json_text(json) + '\n');
  }
} // namespace auxfem
