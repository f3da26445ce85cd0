#ifndef auxfem_analysis_paths_singular_points_h
#define auxfem_analysis_paths_singular_points_h

#include <auxfem/analysis/paths/path_stepper.h>
#include <auxfem/output/recorder.h>

#include <vector>

namespace auxfem
{
  /** A point on the path with singular stiffness. */
  struct LocatedPoint
  {
    PathPoint     point;
    SingularPoint singular;
  };

  /**
   * Finds the singular points between @p from and @p to, which a step of @p
   * length (m) connects, in their order. At a limit point the load factor has
   * an extremum. At a bifurcation the number of negative eigenvalues changes,
   * or the sign of the determinant if that number is unknown. Each is bracketed
   * by further steps from @p from (Alefeld, Potra and Shi 1995, ACM
   * Transactions on Mathematical Software 21, 327). Collective.
   */
  std::vector<LocatedPoint> find_singular_points(PathStepper     &stepper,
                                                 const PathPoint &from,
                                                 const PathPoint &to,
                                                 double           length);
} // namespace auxfem

#endif
