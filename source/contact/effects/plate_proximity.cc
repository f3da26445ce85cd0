#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/plate_proximity.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

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
  PlateContactPoints::touchable_parts(const unsigned int a,
                                      const AxisCurve   &curve) const
  {
    if (!is_rigid_arc(a))
      return {{curve, std::max(curve.degree, axes[a].order)}};
    std::vector<ControlPolygon> ends(2);
    for (const unsigned int end : {0, 1})
      ends[end].points[0] = curve.at(end);
    return ends;
  }

  std::vector<ContactQuadraturePoint> PlateContactPoints::quadrature_points(
    const unsigned int            a,
    const PlateSide              &side,
    const std::vector<AxisCurve> &curves) const
  {
    // Exact on planes for struts of order 6, whose energy and tangent have
    // three times the degree.
    static const dealii::QGauss<1>      rule(11);
    const ContactAxis                  &axis   = axes[a];
    const bool                          is_arc = is_rigid_arc(a);
    std::vector<ContactQuadraturePoint> points;
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

  namespace
  {
    using Vector3 = dealii::Tensor<1, 3>;

    /** Local numbers of unknowns. */
    std::vector<int> here(const std::vector<int> &globals,
                          const UnknownLayout    &layout)
    {
      std::vector<int> locals;
      for (const int global : globals)
        locals.push_back(layout.local(global));
      return locals;
    }
  } // namespace

  PlateProximity::PlateProximity(const LatticeModel &model,
                                 const StrutCurves  &curves)
    : model(model)
    , curves(curves)
    , axes(curves.list())
    , points_of_axes(model, axes)
    , allowed_part(model.plan.scene.contact.largest_penetration)
    , step_length(model.plan.simulated.inertia ? model.plan.time.step : 0.)
    , dimension(model.lattice.dimension)
  {
    const UnknownLayout                &layout      = model.numbering.layout();
    const std::vector<PlateDefinition> &definitions = model.plan.scene.plates;
    for (unsigned int i = 0; i < definitions.size(); ++i)
      {
        const GlobalNumbers::MotionNumbers &joint_numbers =
          model.numbering.global().joints[model.lattice.joint_of_plate(i)];
        all_plates.push_back(
          {&definitions[i],
           model.lattice.joints[model.lattice.joint_of_plate(i)],
           std::vector<int>(joint_numbers.begin(),
                            joint_numbers.begin() + dimension)});
      }
    for (const ContactAxis &axis : axes)
      {
        thickest = std::max(thickest, axis.half_thickness);
        owned_unknowns.push_back(axis.is_owned ? here(axis.unknowns, layout)
                                               : std::vector<int>());
      }
    for (const auto &unknowns : owned_unknowns)
      displacements.insert(displacements.end(),
                           unknowns.begin(),
                           unknowns.end());
    for (const Plate &plate : all_plates)
      for (const int global : plate.unknowns)
        if (const int unknown = layout.local(global); layout.is_owned(unknown))
          displacements.push_back(unknown);
    std::sort(displacements.begin(), displacements.end());
    displacements.erase(std::unique(displacements.begin(), displacements.end()),
                        displacements.end());
  }

  void PlateProximity::refuse_bad_plates() const
  {
    refuse_struts_without_thickness();
    refuse_plates_in_struts();
  }

  void PlateProximity::refuse_struts_without_thickness() const
  {
    for (const ContactAxis &axis : axes)
      if (axis.stiffness == 0)
        throw InputError(
          "Plates: strut " + std::to_string(axis.strut) +
          " has no thickness that could touch a plate, since its section is "
          "given by its stiffnesses, or it is rigid and there is no section. "
          "Give the section by its shape (`Shape = rectangle`, `circle`, "
          "`tube`), or remove the plates.");
  }

  void PlateProximity::refuse_plates_in_struts() const
  {
    // Touching at rest within round-off is allowed.
    for (const Plate &plate : all_plates)
      {
        const ContactAxis *deepest = nullptr;
        double             depth   = 0;
        for (const ContactAxis &axis : axes)
          if (const double here =
                depth_at_rest(&axis - axes.data(),
                              plate,
                              input_precision *
                                (axis.half_thickness + thickest));
              here > depth)
            {
              deepest = &axis;
              depth   = here;
            }
        if (deepest == nullptr)
          continue;
        std::ostringstream message;
        message << plate.definition->path << ": at rest strut "
                << deepest->strut << " reaches " << depth
                << " m into it, half its thickness (" << deepest->half_thickness
                << " m) included, and no strut deeper. Move the plate by its "
                   "Position, or turn its Normal round if the lattice lies "
                   "behind it.";
        throw InputError(message.str());
      }
  }

  double PlateProximity::depth_at_rest(const unsigned int axis,
                                       const Plate       &plate,
                                       const double       tolerance) const
  {
    const RigidSurface &surface = *plate.definition->surface;
    AxisCurve           curve   = curves.at_rest(axis);
    curve.coefficients[0] -= plate.position;
    const ControlPolygon polygon(curve, curve.degree);
    const double         half = axes[axis].half_thickness;
    if (surface.level(polygon, polygon, half - tolerance).is_nowhere_negative())
      return 0;
    const auto distance = [&](const double parameter) {
      return surface.distance(curve.at(parameter));
    };
    const std::vector<double> parameters =
      parameters_between_levels(surface, {polygon}, {half - tolerance});
    double least = std::min(distance(0), distance(1));
    for (std::size_t i = 1; i < parameters.size(); ++i)
      {
        constexpr int half_the_digits = 26;
        least =
          std::min(least,
                   boost::math::tools::brent_find_minima(distance,
                                                         parameters[i - 1],
                                                         parameters[i],
                                                         half_the_digits)
                     .second);
      }
    return least < half - tolerance ? half - least : 0;
  }

  std::vector<Vector3> PlateProximity::plate_values(const Vector &values) const
  {
    const UnknownLayout &layout = model.numbering.layout();
    std::vector<double>  mine(3 * all_plates.size(), 0.);
    for (unsigned int i = 0; i < all_plates.size(); ++i)
      for (unsigned int c = 0; c < dimension; ++c)
        if (const int u = layout.local(all_plates[i].unknowns[c]);
            layout.is_owned(u))
          mine[3 * i + c] = values[u];
    const std::vector<double> all = layout.sum(mine);
    std::vector<Vector3>      result;
    for (unsigned int i = 0; i < all_plates.size(); ++i)
      result.push_back(Vector3({all[3 * i], all[3 * i + 1], all[3 * i + 2]}));
    return result;
  }

  double PlateProximity::least_gap(const PlatePair &pair,
                                   const Vector    &displacement,
                                   const Vector3   &plate_displacement) const
  {
    const ContactAxis     &axis = axes[pair.axis];
    std::array<Vector3, 2> ends = {{axis.ends[0], axis.ends[1]}};
    for (unsigned int end = 0; end < 2; ++end)
      for (unsigned int c = 0; c < dimension; ++c)
        ends[end][c] +=
          displacement[owned_unknowns[pair.axis][end * dimension + c]];
    // Every point lies within half the length of the midpoint of the ends; 10 %
    // allow for uneven stretch.
    const double reach =
      0.55 * std::max(axis.length, (ends[1] - ends[0]).norm());
    const Plate &plate = all_plates[pair.plate];
    return plate.definition->surface->distance(
             (ends[0] + ends[1]) / 2 - plate.position - plate_displacement) -
      reach - axis.half_thickness;
  }

  double PlateProximity::largest_motion(const unsigned int a,
                                        const Vector      &increment,
                                        const Vector3 &plate_displacement) const
  {
    const std::vector<int> &unknowns = owned_unknowns[a];
    double                  largest  = 0;
    for (std::size_t node = 0; node < unknowns.size(); node += dimension)
      {
        double square = 0;
        for (unsigned int c = 0; c < dimension; ++c)
          square +=
            std::pow(increment[unknowns[node + c]] - plate_displacement[c], 2);
        largest = std::max(largest, square);
      }
    return std::sqrt(largest);
  }

  double PlateProximity::largest_displacement(const Vector &values) const
  {
    double largest = 0;
    for (const int unknown : displacements)
      largest = std::max(largest, std::abs(values[unknown]));
    return std::sqrt(dimension) * largest;
  }

  double PlateProximity::largest_displacement(const Vector &values,
                                              const Vector &from) const
  {
    double largest = 0;
    for (const int unknown : displacements)
      largest = std::max(largest, std::abs(values[unknown] - from[unknown]));
    return std::sqrt(dimension) * largest;
  }

  bool PlateProximity::are_clear(const Vector &now,
                                 const double  further,
                                 const double  margin) const
  {
    if (!near_pairs.empty() || !last_search)
      return false;
    // least_gap() changes by at most 3.1 times the largest motion of nodes and
    // plates.
    constexpr double most = 4;
    const double     motion =
      largest_displacement(now, last_search->displacement) + further;
    return last_search->clearance >
      margin + most * model.numbering.layout().largest(motion);
  }

  std::optional<Vector>
  PlateProximity::motion_of_step(const State &accepted) const
  {
    std::optional<Vector> motion;
    if (step_length > 0)
      {
        motion = *accepted.velocity;
        scale(step_length, *motion);
      }
    else if (accepted.before)
      {
        motion = accepted.displacement;
        add_multiple(-1, accepted.before->displacement, *motion);
      }
    return motion;
  }

  std::vector<PlatePair> PlateProximity::find_near(const State &accepted)
  {
    // Two steps of lookahead and hysteresis keep pairs stable, since each
    // change rebuilds the matrix pattern.
    constexpr double            lookahead = 2, hysteresis = 2;
    const std::optional<Vector> motion = motion_of_step(accepted);
    const std::vector<Vector3>  places = plate_values(accepted.displacement),
                               motions = motion
      ? plate_values(*motion)
      : std::vector<Vector3>(all_plates.size());
    std::vector<PlatePair> mine;
    double                 clearance = std::numeric_limits<double>::infinity();
    for (unsigned int a = 0; a < axes.size(); ++a)
      if (axes[a].is_owned && !curves.is_removed(a))
        for (unsigned int p = 0; p < all_plates.size(); ++p)
          {
            double margin = least_margin();
            if (motion)
              margin += lookahead * largest_motion(a, *motion, motions[p]);
            if (std::binary_search(near_pairs.begin(),
                                   near_pairs.end(),
                                   PlatePair{a, p}))
              margin *= hysteresis;
            const double gap =
              least_gap({a, p}, accepted.displacement, places[p]);
            clearance = std::min(clearance, gap);
            if (gap < margin)
              mine.push_back({a, p});
          }
    const UnknownLayout &layout = model.numbering.layout();
    last_search = Search{accepted.displacement, -layout.largest(-clearance)};
    if (layout.n_ranks() == 1)
      return mine;
    std::vector<PlatePair> all = gather_over_ranks(mine, layout.communicator());
    std::sort(all.begin(), all.end());
    return all;
  }

  bool PlateProximity::follow(const State &accepted)
  {
    const double next_motion = step_length > 0
      ? step_length * largest_displacement(*accepted.velocity)
      : accepted.before ? largest_displacement(accepted.displacement,
                                               accepted.before->displacement)
                        : 0;
    if (are_clear(accepted.displacement, next_motion, least_margin()))
      return false;
    std::vector<PlatePair> now = find_near(accepted);
    if (now == near_pairs)
      return false;
    near_pairs = std::move(now);
    return true;
  }

  bool PlateProximity::restart(const State &accepted)
  {
    const std::vector<PlatePair> before = std::exchange(near_pairs, {});
    last_search.reset();
    near_pairs = find_near(accepted);
    return near_pairs != before;
  }

  std::optional<PlateProximity::Depth>
  PlateProximity::first_excessive_penetration(const Evaluation &step) const
  {
    if (are_clear(step.to.displacement,
                  largest_displacement(step.to.displacement,
                                       step.from.displacement),
                  0))
      return {};
    Vector increment = step.to.displacement;
    add_multiple(-1, step.from.displacement, increment);
    const std::vector<Vector3> places  = plate_values(step.to.displacement),
                               motions = plate_values(increment);
    for (unsigned int a = 0; a < axes.size(); ++a)
      if (axes[a].is_owned)
        for (unsigned int p = 0; p < all_plates.size(); ++p)
          // Between its nodes an axis may move farther than they do.
          if (least_gap({a, p}, step.to.displacement, places[p]) <
              2 * largest_motion(a, increment, motions[p]))
            if (const auto found = excessive_penetration({a, p},
                                                         step,
                                                         places[p] - motions[p],
                                                         places[p]))
              return found;
    return {};
  }

  std::optional<PlateProximity::Depth>
  PlateProximity::excessive_penetration(const PlatePair  &pair,
                                        const Evaluation &step,
                                        const Vector3    &before,
                                        const Vector3    &now) const
  {
    const ContactAxis &axis  = axes[pair.axis];
    const Plate       &plate = all_plates[pair.plate];
    const bool         is_coupled =
      std::binary_search(near_pairs.begin(), near_pairs.end(), pair);
    const double allowed =
      is_coupled ? allowed_part * thickness(pair.axis) : 0.;
    const auto curve_at = [&](const State   &state,
                              const Vector3 &plate_displacement) {
      AxisCurve curve = curves.curve(pair.axis,
                                     owned_unknowns[pair.axis].data(),
                                     state.displacement.data());
      curve.coefficients[0] -= plate.position + plate_displacement;
      return curve;
    };
    const AxisCurve from = curve_at(step.from, before),
                    to   = curve_at(step.to, now);
    const auto starts    = points_of_axes.touchable_parts(pair.axis, from),
               ends      = points_of_axes.touchable_parts(pair.axis, to);
    for (std::size_t i = 0; i < starts.size(); ++i)
      if (const auto found = find_passage(*plate.definition->surface,
                                          starts[i],
                                          ends[i],
                                          axis.half_thickness - allowed))
        {
          // A polygon of degree 0 is an end point, so i is its parameter.
          const double  parameter = starts[i].degree > 0 ? found->parameter : i;
          const Vector3 place =
            (1 - found->path_fraction) * from.at(parameter) +
            found->path_fraction * to.at(parameter);
          return Depth{axis.strut,
                       pair.plate,
                       axis.half_thickness -
                         plate.definition->surface->distance(place),
                       is_coupled};
        }
    return {};
  }
} // namespace auxfem
