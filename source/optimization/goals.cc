#include <auxfem/optimization/goals.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace auxfem
{
  namespace
  {
    /** Expressions of all goals: objectives, then both sides of constraints. */
    std::vector<DerivedColumn> expressions_of(const Scene &scene)
    {
      std::vector<DerivedColumn> expressions;
      const auto                 add = [&](const std::string &path,
                           const std::string &expression) {
        expressions.push_back({"goal " + std::to_string(expressions.size() + 1),
                               expression,
                               "",
                               scene.context.constants,
                               path});
      };
      for (const Objective &objective : scene.optimization.objectives)
        add("Optimization/Objective", objective.expression);
      for (const ResultLimit &limit : scene.optimization.limits)
        {
          add("Optimization/Constraints", limit.expression);
          add("Optimization/Constraints", limit.limit);
        }
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

  Goals::Goals(const Scene &scene, const NamedResults &first)
    : definition(scene.optimization)
  {
    const std::vector<std::string>   paths       = paths_of(first);
    const std::vector<DerivedColumn> definitions = expressions_of(scene);
    for (const auto &[name, position] : names_of_results(paths))
      names.emplace_back(paths[position], name);
    // Messages list whole paths before their ends.
    std::stable_partition(names.begin(), names.end(), [](const auto &one) {
      return one.first == one.second;
    });
    expressions.emplace(definitions, second_of(names));
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
