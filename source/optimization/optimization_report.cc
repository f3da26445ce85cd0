#include <auxfem/optimization/optimization_report.h>
#include <auxfem/optimization/refined_designs.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  std::string name_of(const Design &design)
  {
    const std::size_t last   = design.folder.rfind('/'),
                      before = design.folder.rfind('/', last - 1);
    const std::string parent =
      design.folder.substr(before + 1, last - before - 1);
    const std::string own = design.folder.substr(last + 1);
    return parent == "designs" ? own : parent + "/" + own;
  }

  std::string short_name(const OptimizationDefinition &optimization,
                         const std::size_t             v)
  {
    const auto last_part = [](const DesignVariable &variable) {
      return variable.path.substr(variable.path.rfind('/') + 1);
    };
    const std::vector<DesignVariable> &variables = optimization.variables;
    const std::string                  name      = last_part(variables[v]);
    const auto                         n = std::count_if(variables.begin(),
                                 variables.end(),
                                 [&](const DesignVariable &other) {
                                   return last_part(other) == name;
                                 });
    return n > 1 ? variables[v].path : name;
  }

  namespace
  {
    std::string value_text(const DesignVariable &variable, const double part)
    {
      return rounded_text(variable.value_at(part), 6) +
        (variable.unit.empty() ? "" : " " + variable.unit);
    }

    /** Why a design is not usable. */
    std::string reason_of_failure(const Design &design)
    {
      if (design.exit_state != "completed")
        return design.exit_state.substr(0, design.exit_state.find('\n'));
      return design.goals ? "its verdict is " + design.verdict
                          : "an objective or a constraint is no finite number";
    }
  } // namespace

  std::string
  line_of(const Scene &scene, const Goals &goals, const Design &design)
  {
    const std::vector<DesignVariable> &variables = scene.optimization.variables;
    std::string                        text      = name_of(design) + "  ";
    for (std::size_t v = 0; v < variables.size(); ++v)
      text += (v > 0 ? ", " : "") + short_name(scene.optimization, v) + " = " +
        value_text(variables[v], design.point[v]);
    if (!design.goals)
      return text + ": failed, " + reason_of_failure(design);
    text += ":";
    for (std::size_t i = 0; i < goals.objectives().size(); ++i)
      text += (i > 0 ? ", " : " ") + goals.objectives()[i].expression + " = " +
        rounded_text(design.goals->objectives[i], 6);
    for (std::size_t i = 0; i < goals.limits().size(); ++i)
      text += ", " + goals.limits()[i].expression + " = " +
        rounded_text(design.goals->limited[i], 6);
    return text + (design.is_usable() ? "" : "; " + design.verdict) +
      (design.is_reused ? "; from an earlier optimization" : "");
  }

  Gain gain_of(const OptimizationResult &result, const Goals &goals)
  {
    const auto gain = [&goals](const GoalValues &first,
                               const GoalValues &best) {
      return (goals.objectives()[0].is_maximized ? 1 : -1) *
        (best.objectives[0] - first.objectives[0]);
    };
    const double coarse = gain(*result.first.goals, *result.best.goals);
    if (!result.refined_first || !result.refined_best)
      return {coarse, {}};
    const double fine = gain(*result.refined_first, *result.refined_best);
    return {fine, std::abs(fine - coarse)};
  }

  std::vector<std::string> notes_on_signs(const Goals &goals)
  {
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < goals.limits().size(); ++i)
      if (goals.limits()[i].is_upper && goals.first().limited[i] < 0 &&
          goals.first().limits[i] > 0)
        notes.push_back(goals.limits()[i].text +
                        " is met by any size below "
                        "zero, as at the beginning. If the size is meant, "
                        "write abs(" +
                        goals.limits()[i].expression + ").");
    for (std::size_t i = 0; i < goals.objectives().size(); ++i)
      if (const Objective &objective = goals.objectives()[i];
          goals.first().objectives[i] < 0)
        notes.push_back(objective.text() + " begins below zero, so its size " +
                        (objective.is_maximized ? "falls" : "grows") +
                        ". If the size is meant, write abs(" +
                        objective.expression + ").");
    return notes;
  }

  namespace
  {
    Finding finding(const Verdict verdict, const std::string &text)
    {
      return {verdict, text, 0, ""};
    }

    void add_gain_finding(const OptimizationResult &result,
                          const Goals              &goals,
                          std::vector<Finding>     &findings)
    {
      if (result.best.point == result.first.point)
        {
          findings.push_back(finding(
            Verdict::doubtful,
            "No design is better than that of the scene. Give more "
            "Evaluations, wider bounds, other Starts or a global method."));
          return;
        }
      const Gain gain = gain_of(result, goals);
      // A first design beyond a constraint may have the better objective.
      if (goals.largest_excess(*result.first.goals) > 0 || !gain.error ||
          gain.value > *gain.error)
        return;
      findings.push_back(
        finding(Verdict::doubtful,
                "The gain, " + rounded_text(gain.value) +
                  ", is not larger than its error by mesh and time step, " +
                  rounded_text(*gain.error) +
                  ". Refine the mesh and the time step of the scene."));
    }
  } // namespace

  namespace
  {
    /**
     * Part of the gain that small changes of the variables may cost.
     * @tuned judgement
     */
    constexpr double tolerable_loss = 0.5;

    /** Adds a finding if designs near the best one lose its gain. */
    void add_fragility_finding(const Scene              &scene,
                               const OptimizationResult &result,
                               const Goals              &goals,
                               std::vector<Finding>     &findings)
    {
      const double  best  = goals.merit(*result.best.goals);
      const Design *worst = nullptr;
      for (const Design &design : result.neighbours)
        if (design.is_usable() &&
            (worst == nullptr ||
             goals.merit(*design.goals) > goals.merit(*worst->goals)))
          worst = &design;
      // A first design beyond a constraint shows no gain.
      const double gain = goals.meets_constraints(*result.first.goals)
        ? goals.merit(*result.first.goals) - best
        : std::abs(best);
      if (worst == nullptr ||
          goals.merit(*worst->goals) - best <= tolerable_loss * gain)
        return;
      findings.push_back(
        finding(Verdict::doubtful,
                "The best design is fragile: where a variable changes by at "
                "most " +
                  percentage_text(2 * scene.optimization.difference_step) +
                  " of its range, the objective becomes " +
                  rounded_text(worst->goals->objectives[0], 4) +
                  " and loses more than half of the gain. Choose variables or "
                  "an objective that vary smoothly."));
    }
  } // namespace

  namespace
  {
    /** The first warning of the run in @p folder. */
    std::string first_warning_in(const std::string &folder)
    {
      const Json        summary  = summary_in(folder);
      const Json        warnings = summary.value("warnings", Json::array());
      const std::string file     = "summary.json in " + folder;
      return warnings.empty()
        ? "see " + file + "."
        : warnings[0].value("text", "") + " (" + file + ")";
    }

    /** Adds a finding if nothing tells whether the search has come to its end.
     */
    void add_search_finding(const Scene              &scene,
                            const OptimizationResult &result,
                            std::vector<Finding>     &findings)
    {
      const OptimizationDefinition &optimization = scene.optimization;
      const SearchMethod            last =
        chosen_methods(optimization, !optimization.limits.empty()).back();
      if (last.is_global)
        findings.push_back(finding(
          Verdict::doubtful,
          "Method = " + last.name +
            " ends after its Evaluations, however near to the best design it "
            "is. Let a local method follow, e.g. Method = " +
            last.name + ", COBYLA."));
      else if (result.is_cut_short)
        findings.push_back(
          finding(Verdict::doubtful,
                  "A search ended after " +
                    std::to_string(optimization.n_evaluations) +
                    " designs, before its steps were small. Give more "
                    "Optimization/Evaluations; designs so far are kept."));
    }
  } // namespace

  std::vector<Finding> findings_of(const Scene              &scene,
                                   const OptimizationResult &result,
                                   const Goals              &goals)
  {
    std::vector<Finding> findings;
    if (!result.best.is_usable())
      findings.push_back(
        finding(Verdict::not_to_be_used,
                "No design has results that may be used: see verdict and "
                "exit_state in " +
                  design_table_file + "."));
    else if (!goals.meets_constraints(*result.best.goals))
      findings.push_back(finding(
        Verdict::not_to_be_used,
        "No design meets all constraints. The best one exceeds them by " +
          percentage_text(goals.largest_excess(*result.best.goals)) +
          " of a limit. Relax them, or widen the bounds."));
    else
      {
        add_gain_finding(result, goals, findings);
        if (result.best.point != result.first.point)
          add_fragility_finding(scene, result, goals, findings);
      }
    if (result.best.goals && result.best.verdict == name_of(Verdict::doubtful))
      findings.push_back(finding(Verdict::doubtful,
                                 "The run of the best design is doubtful "
                                 "itself: " +
                                   first_warning_in(result.best.folder)));
    if (const std::size_t n = result.n_failed())
      {
        const Design &failed =
          *std::find_if(result.designs.begin(),
                        result.designs.end(),
                        [](const Design &one) { return !one.is_usable(); });
        findings.push_back(finding(
          Verdict::doubtful,
          std::to_string(n) + " of " + std::to_string(result.designs.size()) +
            (n == 1 ? " designs has" : " designs have") +
            " no usable results, so the search knows nothing near them. The first is " +
            name_of(failed) + ": " + reason_of_failure(failed) +
            ". Choose bounds within which all designs run."));
      }
    add_search_finding(scene, result, findings);
    std::stable_sort(findings.begin(),
                     findings.end(),
                     [](const Finding &one, const Finding &other) {
                       return one.verdict > other.verdict;
                     });
    return findings;
  }

  namespace
  {
    /** Line on a goal from the first to the best design. */
    std::string goal_text(const std::string           &name,
                          const double                 first,
                          const double                 best,
                          const std::optional<double> &refined,
                          const std::string           &refinement)
    {
      std::string text = "    " + name + ": " + rounded_text(first, 6) +
        " -> " + rounded_text(best, 6);
      if (first != 0)
        text += " (" + std::string(best > first ? "+" : "") +
          percentage_text((best - first) / std::abs(first), 3) + ")";
      if (refined)
        text += "; " + rounded_text(*refined, 6) + " with " + refinement;
      return text + '\n';
    }

    /** Whether a variable lies at a bound, as far as the search tells. */
    std::string bound_text(const double part, const double nearness)
    {
      return part <= nearness  ? " (lower bound)"
        : part >= 1 - nearness ? " (upper bound)"
                               : "";
    }

    /** Usable designs within constraints that differ from the best one by less
     * than the error of its objective. */
    std::vector<const Design *> equal_designs(const OptimizationResult &result,
                                              const Goals              &goals,
                                              const double              error)
    {
      std::vector<const Design *> list;
      for (const Design &design : result.designs)
        if (design.is_usable() && goals.meets_constraints(*design.goals) &&
            std::abs(design.goals->objectives[0] -
                     result.best.goals->objectives[0]) <= error)
          list.push_back(&design);
      return list;
    }

    /** Ranges of the variables in designs that the error of the objective does
     * not tell apart. */
    std::string equal_designs_text(const Scene              &scene,
                                   const OptimizationResult &result,
                                   const Goals              &goals)
    {
      if (!result.refined_best)
        return "";
      const double error = std::abs(result.refined_best->objectives[0] -
                                    result.best.goals->objectives[0]);
      const auto   equal = equal_designs(result, goals, error);
      std::string  ranges;
      if (equal.size() < 2)
        return "";
      for (std::size_t v = 0; v < result.best.point.size(); ++v)
        {
          const auto ends =
            std::minmax_element(equal.begin(),
                                equal.end(),
                                [v](const Design *one, const Design *other) {
                                  return one->point[v] < other->point[v];
                                });
          const double least             = (*ends.first)->point[v],
                       most              = (*ends.second)->point[v];
          const DesignVariable &variable = scene.optimization.variables[v];
          if (most - least > scene.optimization.tolerance)
            ranges += "    " + variable.path + ": " +
              value_text(variable, least) + " to " +
              value_text(variable, most) + '\n';
        }
      if (ranges.empty())
        return "";
      return "  " + std::to_string(equal.size()) +
        " designs differ from the best by less than " + refinement_text(scene) +
        " change it, " + rounded_text(error) + ":\n" + ranges;
    }

    /** Elasticity with its error where that is not small. */
    std::string elasticity_text(const Sensitivity &sensitivity)
    {
      constexpr double small_part = 0.01;
      const double     error      = sensitivity.elasticity_error;
      if (!sensitivity.is_resolved())
        return "< " + rounded_text(error, 1);
      return rounded_text(sensitivity.elasticity) +
        (error > small_part * std::abs(sensitivity.elasticity)
           ? " +- " + rounded_text(error, 1)
           : "");
    }

    /** Rows of cells in columns. */
    std::string aligned(const std::vector<std::vector<std::string>> &rows)
    {
      std::vector<std::size_t> widths(rows.front().size());
      for (const auto &row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
          widths[i] = std::max(widths[i], row[i].size());
      std::ostringstream text;
      for (const auto &row : rows)
        {
          text << "    " << std::left << std::setw(widths[0]) << row[0]
               << std::right;
          for (std::size_t i = 1; i < row.size(); ++i)
            text << "  " << std::setw(widths[i]) << row[i];
          text << '\n';
        }
      return text.str();
    }

    std::string sensitivities_text(const Scene              &scene,
                                   const OptimizationResult &result)
    {
      std::vector<std::vector<std::string>> rows(1, {""});
      for (const Objective &objective : scene.optimization.objectives)
        rows[0].push_back(objective.expression);
      for (const ResultLimit &limit : scene.optimization.limits)
        rows[0].push_back(limit.expression);
      for (std::size_t v = 0; v < result.sensitivities.size(); ++v)
        if (const auto &found = result.sensitivities[v])
          {
            rows.push_back({scene.optimization.variables[v].path});
            for (const Sensitivity &one : found->objectives)
              rows.back().push_back(elasticity_text(one));
            for (const Sensitivity &one : found->limited)
              rows.back().push_back(elasticity_text(one));
          }
      return rows.size() == 1
        ? ""
        : "  Sensitivities there, % of the result per % of the variable\n" +
          aligned(rows);
    }
  } // namespace

  std::string closing_text(const Scene              &scene,
                           const OptimizationResult &result,
                           const Goals              &goals)
  {
    const Design      &best   = result.best;
    const std::string &folder = scene.output.directory;
    std::ostringstream text;
    text << "\nBest of " << result.designs.size()
         << (result.designs.size() == 1 ? " design, " : " designs, ")
         << name_of(best);
    if (const std::size_t n = result.n_failed())
      text << " (" << n << " without usable results)";
    text << '\n';
    for (std::size_t v = 0; v < best.point.size(); ++v)
      {
        const DesignVariable &variable = scene.optimization.variables[v];
        text << "    " << variable.path << ": "
             << value_text(variable, result.first.point[v]) << " -> "
             << value_text(variable, best.point[v])
             << bound_text(best.point[v], scene.optimization.tolerance) << '\n';
      }
    if (best.goals)
      {
        const std::string refinement = refinement_text(scene);
        const auto        refined    = [&result](const auto       &member,
                                       const std::size_t i) {
          return result.refined_best
                      ? std::optional<double>(((*result.refined_best).*member)[i])
                      : std::nullopt;
        };
        for (std::size_t i = 0; i < goals.objectives().size(); ++i)
          text << goal_text(goals.objectives()[i].text(),
                            result.first.goals->objectives[i],
                            best.goals->objectives[i],
                            refined(&GoalValues::objectives, i),
                            refinement);
        for (std::size_t i = 0; i < goals.limits().size(); ++i)
          text << goal_text(goals.limits()[i].text,
                            result.first.goals->limited[i],
                            best.goals->limited[i],
                            refined(&GoalValues::limited, i),
                            refinement);
        const Gain gain = gain_of(result, goals);
        if (!goals.meets_constraints(*result.first.goals))
          text << "  The values of the scene are beyond a constraint, so they "
                  "are no measure of the gain.\n";
        else if (gain.error)
          text << "  Gain " << rounded_text(gain.value, 4) << " +- "
               << rounded_text(*gain.error, 1) << ", with " << refinement
               << "; the error is the change by it\n";
        text << equal_designs_text(scene, result, goals)
             << sensitivities_text(scene, result);
      }
    if (!result.front.empty())
      text << "The front of both objectives, " << result.front.size()
           << " designs, is " << folder << '/' << front_table_file << '\n';
    text << "The best scene is " << folder << '/' << best_scene_file
         << ", the table of all designs " << folder << '/' << design_table_file;
    return text.str();
  }
} // namespace auxfem
