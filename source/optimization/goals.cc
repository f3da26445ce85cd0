#include <auxfem/figures/figure_table.h>
#include <auxfem/optimization/goals.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace auxfem
{
  namespace
  {
    DerivedColumn column_of(const Scene       &scene,
                            const std::string &path,
                            const std::string &expression)
    {
      return {"", expression, "", scene.context.constants, path};
    }

    DerivedColumn column_of(const Scene &scene, const Objective &objective)
    {
      return column_of(scene, "Optimization/Objective", objective.expression);
    }

    /** Both sides of @p limit. */
    std::array<DerivedColumn, 2> columns_of(const Scene       &scene,
                                            const ResultLimit &limit)
    {
      const std::string path = "Optimization/Constraints";
      return {{column_of(scene, path, limit.expression),
               column_of(scene, path, limit.limit)}};
    }

    /** Expressions of all goals: objectives, then both sides of constraints. */
    std::vector<DerivedColumn> expressions_of(const Scene &scene)
    {
      std::vector<DerivedColumn> expressions;
      for (const Objective &objective : scene.optimization.objectives)
        expressions.push_back(column_of(scene, objective));
      for (const ResultLimit &limit : scene.optimization.limits)
        for (const DerivedColumn &side : columns_of(scene, limit))
          expressions.push_back(side);
      return expressions;
    }

    std::vector<std::string> paths_of(const NamedResults &results)
    {
      std::vector<std::string> paths;
      for (const auto &[path, value] : results)
        paths.push_back(path);
      return paths;
    }

    std::vector<std::string>
    second_of(const std::vector<std::pair<std::string, std::string>> &pairs)
    {
      std::vector<std::string> list;
      for (const auto &pair : pairs)
        list.push_back(pair.second);
      return list;
    }
  } // namespace

  namespace
  {
    bool ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
        text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    /** Throws InputError for a word in the expression of @p column that is none
     * of @p names, which are @p paths of results and ends of them. */
    void require_results(const DerivedColumn            &column,
                         const std::vector<std::string> &names,
                         const std::vector<std::string> &paths)
    {
      for (const std::string &word : names_in(column, names).unknown)
        {
          std::vector<std::string> alike;
          std::copy_if(paths.begin(),
                       paths.end(),
                       std::back_inserter(alike),
                       [&word](const std::string &path) {
                         return ends_with(path, "." + word);
                       });
          const std::string beginning =
            column.path + " = " + column.expression + ": ";
          if (!alike.empty())
            throw InputError(beginning + "several results end in \"" + word +
                             "\". Write more of the path of one of them: " +
                             joined(alike, 10));
          throw InputError(beginning + "this run has no number \"" + word +
                           "\" in its results" + did_you_mean(word, names) +
                           "\n  Results: " + joined(paths, 60));
        }
    }

    /** SI unit of the result at @p path as far as its name tells; else empty.
     */
    std::string unit_of_result(const std::string &path)
    {
      static const std::vector<std::pair<std::string, std::string>> endings = {
        {"_metre", "m"},
        {"_kilogram", "kg"},
        {"_hertz", "Hz"},
        {"_joule", "J"},
        {"_newton", "N"},
        {"_pascal", "Pa"},
        {"_radian", "rad"}};
      for (const std::string &part :
           dealii::Utilities::split_string_list(path, '.'))
        for (const auto &[ending, unit] : endings)
          if (ends_with(part, ending))
            return unit;
      const std::string last = path.substr(path.rfind('.') + 1);
      for (const BodyFigure &figure : body_figure_columns())
        if (figure.column.name == last)
          return figure.column.unit;
      return "";
    }

    /** Throws InputError if @p limit bounds a single result and does not have
     * its unit. */
    void require_unit(const ResultLimit                        &limit,
                      const std::map<std::string, std::size_t> &positions,
                      const std::vector<std::string>           &paths)
    {
      std::string name = limit.expression;
      if (name.compare(0, 4, "abs(") == 0 && name.back() == ')')
        name = dealii::Utilities::trim(name.substr(4, name.size() - 5));
      const auto found = positions.find(name);
      if (limit.unit.empty() || found == positions.end())
        return;
      const std::string unit = unit_of_result(paths[found->second]);
      if (!unit.empty() &&
          parse_unit(unit).dimension != parse_unit(limit.unit).dimension)
        throw InputError("Optimization/Constraints = " + limit.text + ": " +
                         name + " is in " + unit + ", its limit in " +
                         limit.unit + ". Give a limit in a unit that fits");
    }
  } // namespace

  namespace
  {
    /** Throws InputError for an objective or a constraint that depends on none
     * of the results @p names. */
    void require_dependence(const Scene                    &scene,
                            const std::vector<std::string> &names)
    {
      const auto depends = [&names](const DerivedColumn &column) {
        return !names_in(column, names).known.empty();
      };
      for (const Objective &objective : scene.optimization.objectives)
        if (!depends(column_of(scene, objective)))
          throw InputError("Optimization/Objective = " + objective.text() +
                           ": it depends on no result, so no design is better "
                           "than another. Name a result of the run, e.g. "
                           "minimize mass_kilogram");
      for (const ResultLimit &limit : scene.optimization.limits)
        {
          const std::array<DerivedColumn, 2> sides = columns_of(scene, limit);
          if (!depends(sides[0]) && !depends(sides[1]))
            throw InputError("Optimization/Constraints = " + limit.text +
                             ": it depends on no result, so it limits no "
                             "design. Name a result of the run, e.g. "
                             "mass_kilogram <= 20 g; variables are limited by "
                             "their bounds");
        }
    }
  } // namespace

  Goals::Goals(const Scene &scene, const NamedResults &first)
    : definition(scene.optimization)
  {
    const std::vector<std::string> paths     = paths_of(first);
    const auto                     positions = names_of_results(paths);
    for (const auto &[name, position] : positions)
      names.emplace_back(paths[position], name);
    const std::vector<std::string>   known       = second_of(names);
    const std::vector<DerivedColumn> definitions = expressions_of(scene);
    for (const DerivedColumn &column : definitions)
      require_results(column, known, paths);
    require_dependence(scene, known);
    for (const ResultLimit &limit : limits())
      require_unit(limit, positions, paths);
    expressions.emplace(definitions, known);
    const std::optional<GoalValues> found = values(first);
    if (!found)
      throw InputError(
        "Optimization: with the values of the scene, an objective "
        "or a constraint is no finite number. Choose results "
        "that this run has");
    first_values = *found;
  }

  std::optional<GoalValues> Goals::values(const NamedResults &results)
  {
    const std::map<std::string, double> by_path(results.begin(), results.end());
    std::vector<double>                 row;
    for (const auto &[path, name] : names)
      {
        const auto found = by_path.find(path);
        // A result that no expression needs may be missing.
        row.push_back(found == by_path.end() ? std::nan("") : found->second);
      }
    const std::size_t n_results = row.size();
    expressions->append_to(row);
    if (!std::all_of(row.begin() + n_results,
                     row.end(),
                     [](const double value) { return std::isfinite(value); }))
      return {};
    GoalValues values;
    auto       value = row.begin() + n_results;
    for (std::size_t i = 0; i < objectives().size(); ++i)
      values.objectives.push_back(*value++);
    for (std::size_t i = 0; i < limits().size(); ++i)
      {
        values.limited.push_back(*value++);
        values.limits.push_back(*value++);
      }
    return values;
  }

  namespace
  {
    double size_or_one(const double value)
    {
      return value == 0 ? 1 : std::abs(value);
    }
  } // namespace

  double Goals::merit(const GoalValues &values, const unsigned int i) const
  {
    return (objectives()[i].is_maximized ? -1 : 1) * values.objectives[i] /
      size_or_one(first_values.objectives[i]);
  }

  double Goals::size_of_limit(const unsigned int i) const
  {
    return size_or_one(first_values.limits[i] != 0 ? first_values.limits[i]
                                                   : first_values.limited[i]);
  }

  double Goals::excess(const GoalValues &values, const unsigned int i) const
  {
    return (limits()[i].is_upper ? 1 : -1) *
      (values.limited[i] - values.limits[i]) / size_of_limit(i);
  }

  double Goals::largest_excess(const GoalValues &values) const
  {
    double largest = 0;
    for (unsigned int i = 0; i < limits().size(); ++i)
      largest =
        i == 0 ? excess(values, i) : std::max(largest, excess(values, i));
    return largest;
  }
} // namespace auxfem
