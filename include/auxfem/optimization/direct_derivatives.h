#ifndef auxfem_optimization_direct_derivatives_h
#define auxfem_optimization_direct_derivatives_h

#include <auxfem/optimization/sensitivities.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Goals of the designs at @p points near @p point, exact to first order in the
   * distance: their equilibria follow from those at @p point without further
   * factorizations, see NearbyRun; their frequencies from the modes there, see
   * nearby_eigenvalues(). None unless the analysis of @p scene is statics with
   * has_independent_equilibria(), effective properties or modes, and its
   * results have all goals. Throws ComputationError if the run at @p point
   * fails. Collective.
   */
  std::optional<std::vector<std::optional<GoalValues>>>
  nearby_goals(const Scene                    &scene,
               const DesignPoint              &point,
               const std::vector<DesignPoint> &points,
               Goals                          &goals,
               MPI_Comm                        communicator);

  /**
   * Difference step of nearby_goals(), as a part of the ranges.
   * @tuned balances the second order, in which stiff struts count much, and
   *   round-off of double precision
   */
  constexpr double direct_step = 1e-5;

  /**
   * Differences at @p point of nearby_goals() over @p multiple of direct_step,
   * which have no error of an iteration; where these are not known those of
   * runs
   * over @p multiple of @p step. Collective.
   */
  Derivatives derivatives_at(DesignRuns        &runs,
                             const DesignPoint &point,
                             double             step,
                             unsigned int       multiple = 1);
} // namespace auxfem

#endif
