#ifndef auxfem_contact_surface_approach_h
#define auxfem_contact_surface_approach_h

#include <auxfem/contact/rigid_surface.h>

#include <optional>

namespace auxfem
{
  /** A parameter of a curve, and a part of its way from one place to another.
   */
  struct CurvePassage
  {
    double parameter, way;
  };

  /** Sorted parameters from 0 to 1 between which the distances of a curve from
   * a
   * surface lie on one side of each of @p levels (m).
   * @param curves of one degree; all of them count */
  std::vector<double>
  parameters_between_levels(const RigidSurface                &surface,
                            const std::vector<ControlPolygon> &curves,
                            const std::vector<double>         &levels);

  /** Where a curve comes nearer to a surface than @p distance (m) on the
   * straight way from @p from to @p to, if anywhere; subdivision of polynomials
   * with bounds finds it, however short it is.
   * @param from, to of one degree */
  std::optional<CurvePassage> find_passage(const RigidSurface   &surface,
                                           const ControlPolygon &from,
                                           const ControlPolygon &to,
                                           double                distance);
} // namespace auxfem

#endif
