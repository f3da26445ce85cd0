#ifndef auxfem_optimization_sensitivities_h
#define auxfem_optimization_sensitivities_h

#include <auxfem/optimization/design_runs.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /** Derivatives of objectives and left sides of constraints with respect to
   * one variable. */
  struct GoalDerivatives
  {
    std::vector<double> objectives, limited, limits;
  };

  /** Derivatives by variable; none where a design has no results. */
  using Derivatives = std::vector<std::optional<GoalDerivatives>>;

  /** Differences with respect to the part of the range of each variable:
   * central ones, at a bound one-sided ones of second order. */
  class DifferenceFormulas
  {
  public:
    /** Differences at @p point over @p step on either side. */
    DifferenceFormulas(const DesignPoint &point, double step);

    /** Points whose values the differences need. */
    const std::vector<DesignPoint> &points() const
    {
      return point_list;
    }

    /** The differences of @p values, one for each of points(). */
    Derivatives
    differences(const std::vector<std::optional<GoalValues>> &values) const;

  private:
    /** Weights of the points of one variable. */
    std::vector<std::vector<double>> weights;
    std::vector<DesignPoint>         point_list;
  };

  /** Differences at @p point of the goals of runs. Collective. */
  Derivatives
  derivatives_by_runs(DesignRuns &runs, const DesignPoint &point, double step);

  /** Sensitivity of a goal to a variable. */
  struct Sensitivity
  {
    /** Derivative per unit of the variable (in the unit of its bounds). */
    double derivative;
    /** Estimated error of the derivative, by two difference steps. */
    double error;
    /** Relative change of the goal over that of the variable, and its error. */
    double elasticity, elasticity_error;

    /** Whether the derivative is larger than its error. */
    bool is_resolved() const;
  };

  /** Sensitivities of all goals to one variable. */
  struct VariableSensitivities
  {
    std::vector<Sensitivity> objectives, limited;
  };

  /** Sensitivities at @p design to each variable; none where runs have failed.
   * Collective. */
  std::vector<std::optional<VariableSensitivities>>
  sensitivities_at(DesignRuns                   &runs,
                   const OptimizationDefinition &optimization,
                   const Design                 &design);
} // namespace auxfem

#endif
