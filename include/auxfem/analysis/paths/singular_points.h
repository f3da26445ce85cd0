#ifndef auxfem_analysis_paths_singular_points_h
#define auxfem_analysis_paths_singular_points_h

#include <auxfem/analysis/paths/path_stepper.h>
#include <auxfem/output/recorder.h>

#include <vector>

namespace auxfem
{
  /** A point at which the stiffness is singular, on the path. */
  struct LocatedPoint
  {
    PathPoint     point;
    SingularPoint singular;
  };

  /**
   * The singular points that a step along the tangent of @p from to @p to, at
   * the distance @p length (m), has passed, in their order: limit points, where
   * the load factor turns round, and bifurcations, where the number of negative
   * eigenvalues of the stiffness changes without that, or, where that is not
   * known, the sign of its determinant. Each is enclosed by
   * further steps from @p from (Alefeld, Potra and Shi 1995, ACM Transactions on
   * Mathematical Software 21, 327). Collective.
   */
  std::vector<LocatedPoint> find_singular_points(PathStepper     &stepper,
                                                 const PathPoint &from,
                                                 const PathPoint &to,
                                                 double           length);
} // namespace auxfem

#endif
