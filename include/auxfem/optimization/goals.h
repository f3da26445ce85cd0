#ifndef auxfem_optimization_goals_h
#define auxfem_optimization_goals_h

#include <auxfem/figures/derived_columns.h>
#include <auxfem/scene/scene.h>
#include <auxfem/study/scene_cases.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Values of objectives and constraints of a design. */
  struct GoalValues
  {
    std::vector<double> objectives; ///< as the user's expressions
    std::vector<double> limited;    ///< left sides of the constraints
    std::vector<double> limits;     ///< right sides of the constraints
  };

  /** Objectives and constraints as numbers to be made small. */
  class Goals
  {
  public:
    /**
     * Finds the results that the expressions of @p scene refer to among those
     * of its own design, by which it also scales. Throws InputError for a name
     * that is unknown or stands for several results, for a limit in another
     * unit than its result, for goals without results and for a value that is
     * no finite number.
     */
    Goals(const Scene &scene, const NamedResults &first);

    /** Values for these results; none if one of them is missing or not
     * finite. */
    std::optional<GoalValues> values(const NamedResults &results);

    /** Objective @p i over its size at the first design; small is good. */
    double merit(const GoalValues &values, unsigned int i = 0) const;

    /**
     * Excess over constraint @p i as a part of its limit; negative if it is
     * met.
     */
    double excess(const GoalValues &values, unsigned int i) const;

    /** Largest excess(); without constraints 0. */
    double largest_excess(const GoalValues &values) const;

    /** Whether all constraints are met up to their tolerance. */
    bool meets_constraints(const GoalValues &values) const
    {
      return largest_excess(values) <= definition.constraint_tolerance();
    }

    const std::vector<Objective> &objectives() const
    {
      return definition.objectives;
    }

    const std::vector<ResultLimit> &limits() const
    {
      return definition.limits;
    }

    /** Values of the first design. */
    const GoalValues &first() const
    {
      return first_values;
    }

  private:
    /** Size of constraint @p i. */
    double size_of_limit(unsigned int i) const;

    const OptimizationDefinition &definition;
    /** Paths of the results and names for them in expressions. */
    std::vector<std::pair<std::string, std::string>> names;
    std::optional<DerivedValues>                     expressions;
    GoalValues                                       first_values;
  };
} // namespace auxfem

#endif
