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

  /**
   * Derivatives at @p point with respect to the part of the range of each
   * variable, by central differences of length @p step on either side; at a
   * bound by one-sided ones of second order. None where a run has failed.
   * Collective.
   */
  std::vector<std::optional<GoalDerivatives>>
  derivatives_by_differences(DesignRuns        &runs,
                             const DesignPoint &point,
                             double             step);

  /** Sensitivity of a goal to a variable. */
  struct Sensitivity
  {
    /** Derivative per unit of the variable (in the unit of its bounds). */
    double derivative;
    /** Estimated error of the derivative, by two difference steps. */
    double error;
    /** Relative change of the goal over that of the variable. */
    double elasticity;

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
