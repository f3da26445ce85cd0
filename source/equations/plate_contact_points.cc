#include <auxfem/equations/plate_contact_points.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace auxfem
{
  PlateContactPoints::PlateContactPoints(const LatticeModel             &model,
                                         const std::vector<ContactAxis> &axes)
    : model(model)
    , axes(axes)
  {}

  bool PlateContactPoints::is_rigid_arc(const unsigned int axis) const
  {
    const Strut &strut = model.lattice.struts[axes[axis].strut];
    return strut.is_rigid() && strut.sagitta != 0;
  }

  std::vector<ControlPolygon>
  PlateContactPoints::touchable(const unsigned int a,
                                const AxisCurve   &curve) const
  {
    if (!is_rigid_arc(a))
      return {{curve, std::max(curve.degree, axes[a].order)}};
    std::vector<ControlPolygon> ends(2);
    for (const unsigned int end : {0, 1})
      ends[end].points[0] = curve.at(end);
    return ends;
  }

  std::vector<PressingPoint>
  PlateContactPoints::pressing(const unsigned int            a,
                               const PlateSide              &side,
                               const std::vector<AxisCurve> &curves) const
  {
    // Exact on planes for struts of order 6: energy and tangent have three
    // times its degree there.
    static const dealii::QGauss<1> rule(11);
    const ContactAxis             &axis   = axes[a];
    const bool                     is_arc = is_rigid_arc(a);
    std::vector<PressingPoint>     points;
    for (const unsigned int end : {0, 1})
      if (const double length =
            ((end == 0 ? axis.begin == 0 : axis.end == 1) ? axis.half_thickness
                                                          : 0.) +
            (is_arc ? axis.length / 2 : 0.);
          length > 0)
        points.push_back({double(end), length});
    if (is_arc)
      return points;

    unsigned int degree = axis.order;
    for (const AxisCurve &curve : curves)
      degree = std::max(degree, curve.degree);
    std::vector<ControlPolygon> polygons;
    for (const AxisCurve &curve : curves)
      polygons.emplace_back(curve, degree);
    if (std::all_of(polygons.begin(),
                    polygons.end(),
                    [&](const ControlPolygon &polygon) {
                      return side.surface
                        .level(polygon, polygon, side.half_thickness)
                        .is_nowhere_negative();
                    }))
      return {};
    const std::vector<double> parameters =
      parameters_between_levels(side.surface,
                                polygons,
                                {side.half_thickness,
                                 side.half_thickness - side.smoothing});
    for (std::size_t i = 1; i < parameters.size(); ++i)
      {
        const double begin = parameters[i - 1], part = parameters[i] - begin;
        if (part > 0 &&
            std::any_of(curves.begin(),
                        curves.end(),
                        [&](const AxisCurve &curve) {
                          return side.surface.distance(curve.at(
                                   begin + part / 2)) < side.half_thickness;
                        }))
          for (unsigned int q = 0; q < rule.size(); ++q)
            points.push_back({begin + part * rule.point(q)[0],
                              part * rule.weight(q) * axis.length});
      }
    return points;
  }
} // namespace auxfem
