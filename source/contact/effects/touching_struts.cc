#include <auxfem/contact/effects/touching_struts.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  StrutContactPoints::StrutContactPoints(const StrutCurves &curves,
                                         const unsigned int dimension)
    : curves(curves)
    , dimension(dimension)
  {
    for (const ContactAxis &axis : curves.list())
      thickest = std::max(thickest, axis.half_thickness);
  }

  std::vector<FacingStrut>
  StrutContactPoints::facing_struts(const std::vector<AxisPair> &pairs) const
  {
    std::map<AxisPair, FacingStrut> by_axis_and_line;
    const auto                      add = [&](const unsigned int axis,
                         const unsigned int other,
                         const unsigned int pair) {
      const unsigned int line = curves.list()[other].line;
      FacingStrut       &facing = by_axis_and_line[{{axis, line}}];
      facing.axis               = axis;
      facing.line               = line;
      facing.targets.push_back({other, pair});
    };
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        add(pairs[i][0], pairs[i][1], i);
        if (pairs[i][0] != pairs[i][1])
          add(pairs[i][1], pairs[i][0], i);
      }
    std::vector<FacingStrut> all;
    for (auto &[key, facing] : by_axis_and_line)
      all.push_back(std::move(facing));
    return all;
  }

  unsigned int StrutContactPoints::n_points(const unsigned int axis) const
  {
    /** Spacing of contact points in space over half a thickness.
     * @tuned judgement: crossing struts touch along less than a thickness */
    constexpr double       spacing_in_space = 0.25;
    constexpr unsigned int most             = 10000;
    const double           h = curves.list()[axis].half_thickness > 0
                ? curves.list()[axis].half_thickness
                : thickest;
    const double           n = std::ceil(curves.list()[axis].length /
                               (h * (dimension == 2 ? 1 : spacing_in_space)));
    return 1 + std::clamp<double>(n, 4, most);
  }

  double StrutContactPoints::weight(const unsigned int a,
                                    const unsigned int point) const
  {
    const ContactAxis &axis = curves.list()[a];
    const unsigned int n    = n_points(a);
    if (point > 0 && point + 1 < n)
      return axis.length / (n - 1);
    const bool is_end_of_strut = point == 0 ? axis.begin == 0 : axis.end == 1;
    return axis.length / (2 * (n - 1)) +
      (is_end_of_strut ? axis.half_thickness : 0.);
  }

  NearestOfStrut StrutContactPoints::nearest(const FacingStrut          &facing,
                                             const NearCurves           &now,
                                             const dealii::Tensor<1, 3> &point,
                                             const double parameter) const
  {
    NearestOfStrut result{{0, 0},
                          {0, std::numeric_limits<double>::infinity(), false}};
    const auto     update = [&](const FacingStrut::Target   &target,
                            const std::array<double, 2> &part) {
      const NearestPoint found =
        nearest_point(now.at(target.axis), point, part[0], part[1]);
      if (found.distance < result.point.distance)
        result = {target, found};
    };
    for (const FacingStrut::Target &target : facing.targets)
      if (curves.list()[facing.axis].line == facing.line)
        for (const auto &part :
             curves.self_contact_ranges(facing.axis, parameter, target.axis))
          update(target, part);
      else
        update(target, {{0., 1.}});
    return result;
  }

  void
  StrutContactPoints::find_touching(const FacingStrut              &facing,
                                    const NearCurves               &now,
                                    const std::vector<CurveChords> &chords,
                                    const unsigned int              begin,
                                    const unsigned int              end,
                                    std::vector<TouchingPoint> &points) const
  {
    // Distances change by at most the arc length; 10 % allow for stretch.
    constexpr double           stretch = 1.1;
    const unsigned int         middle  = (begin + end) / 2;
    const double               at      = parameter(facing.axis, middle);
    const dealii::Tensor<1, 3> point   = now.at(facing.axis).at(at);
    double distance = std::numeric_limits<double>::infinity();
    for (const CurveChords &target : chords)
      distance = std::min(distance, target.least_distance(point));
    const double thickness =
      curves.thickness(facing.axis, facing.targets.front().axis);
    if (distance < thickness)
      {
        const NearestOfStrut found = nearest(facing, now, point, at);
        distance                   = found.point.distance;
        if (distance < thickness)
          points.push_back({middle, found});
      }
    const double gap = distance - thickness;
    const double spacing =
      stretch * curves.list()[facing.axis].length / (n_points(facing.axis) - 1);
    const auto skipped =
      static_cast<unsigned int>(std::min(std::max(gap, 0.) / spacing, 1e6));
    if (middle > begin + skipped)
      find_touching(facing, now, chords, begin, middle - 1 - skipped, points);
    if (middle + skipped < end)
      find_touching(facing, now, chords, middle + 1 + skipped, end, points);
  }

  std::vector<TouchingPoint>
  StrutContactPoints::touching(const FacingStrut &facing,
                               const NearCurves  &now) const
  {
    std::vector<CurveChords> chords;
    for (const FacingStrut::Target &target : facing.targets)
      chords.emplace_back(now.at(target.axis));
    std::vector<TouchingPoint> points;
    const unsigned int         last = n_points(facing.axis) - 1;
    for (const auto &range :
         curves.free_ranges(facing.axis, facing.targets.front().axis))
      {
        const auto begin = static_cast<unsigned int>(
                     std::ceil(range[0] * last - 1e-9)),
                   end = static_cast<unsigned int>(
                     std::floor(range[1] * last + 1e-9));
        if (begin <= end)
          find_touching(facing, now, chords, begin, end, points);
      }
    std::sort(points.begin(),
              points.end(),
              [](const TouchingPoint &one, const TouchingPoint &other) {
                return one.point < other.point;
              });
    return points;
  }

  namespace
  {
    /** Largest number of nodes of an axis and axes of the mean deformation. */
    constexpr unsigned int max_nodes = AxisCurve::max_degree + 4;

    /** Adds @p factor times the product of two vectors to a square block. */
    void add_product(const double               factor,
                     const std::vector<double> &rows,
                     const std::vector<double> &columns,
                     std::vector<double>       &block)
    {
      const std::size_t n = rows.size();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          block[i * n + j] += factor * rows[i] * columns[j];
    }

    dealii::Tensor<1, 3> unit(const unsigned int direction)
    {
      dealii::Tensor<1, 3> result;
      result[direction] = 1;
      return result;
    }
  } // namespace

  StrutTouchMotion::StrutTouchMotion(const StrutCurves      &curves,
                                     const unsigned int      dimension,
                                     const StrutTouch       &touch,
                                     const AxisPair         &pair,
                                     const std::vector<int> &unknowns)
    : curves(curves)
    , dimension(dimension)
    , touch(touch)
    , pair(pair)
    , unknowns(unknowns)
  {}

  unsigned int StrutTouchMotion::first_of(const unsigned int axis) const
  {
    return axis == pair[0] ? 0 : curves.list()[pair[0]].n_nodes() * dimension;
  }

  template <class Add>
  void StrutTouchMotion::for_each_share(const double opposite,
                                        const Add   &add) const
  {
    double     values[max_nodes];
    const auto add_axis = [&](const unsigned int axis,
                              const double       parameter,
                              const double       sign) {
      curves.shape(axis, parameter, values);
      const unsigned int begin = first_of(axis);
      for (unsigned int node = 0; node < curves.list()[axis].n_nodes(); ++node)
        add(begin + node * dimension, sign * values[node]);
    };
    add_axis(touch.axis, touch.parameter, 1.);
    add_axis(touch.other, opposite, -1.);
  }

  dealii::Tensor<1, 3> StrutTouchMotion::difference(const Vector &values) const
  {
    dealii::Tensor<1, 3> result;
    for_each_share(touch.opposites.back().parameter,
                   [&](const unsigned int first, const double share) {
                     for (unsigned int c = 0; c < dimension; ++c)
                       result[c] += share * values[unknowns[first + c]];
                   });
    return result;
  }

  dealii::Tensor<1, 3>
  StrutTouchMotion::difference_slope(const Vector &values) const
  {
    double shapes[max_nodes], slopes[max_nodes];
    curves.shape(touch.other, touch.opposites.back().parameter, shapes, slopes);
    const unsigned int   begin = first_of(touch.other);
    dealii::Tensor<1, 3> result;
    for (unsigned int node = 0; node < curves.list()[touch.other].n_nodes();
         ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        result[c] -=
          slopes[node] * values[unknowns[begin + node * dimension + c]];
    return result;
  }

  void StrutTouchMotion::add_force(const double                opposite,
                                   const dealii::Tensor<1, 3> &force,
                                   double *const               forces) const
  {
    for_each_share(opposite, [&](const unsigned int first, const double share) {
      for (unsigned int c = 0; c < dimension; ++c)
        forces[unknowns[first + c]] += share * force[c];
    });
  }

  std::vector<double>
  StrutTouchMotion::gradient(const double                opposite,
                             const dealii::Tensor<1, 3> &vector) const
  {
    std::vector<double> result(unknowns.size(), 0.);
    for_each_share(opposite, [&](const unsigned int first, const double share) {
      for (unsigned int c = 0; c < dimension; ++c)
        result[first + c] += share * vector[c];
    });
    return result;
  }

  std::vector<double>
  StrutTouchMotion::tangent_gradient(const dealii::Tensor<1, 3> &vector) const
  {
    std::vector<double> result(unknowns.size(), 0.);
    double              values[max_nodes], slopes[max_nodes];
    curves.shape(touch.other, touch.opposites.back().parameter, values, slopes);
    const unsigned int begin = first_of(touch.other);
    for (unsigned int node = 0; node < curves.list()[touch.other].n_nodes();
         ++node)
      for (unsigned int c = 0; c < dimension; ++c)
        result[begin + node * dimension + c] += slopes[node] * vector[c];
    return result;
  }

  std::vector<double>
  StrutTouchMotion::nearest_change(const AxisCurve &other) const
  {
    const StrutTouch::Opposite &last     = touch.opposites.back();
    const dealii::Tensor<1, 3>  tangent  = other.tangent(last.parameter);
    const double                distance = touch.distance;
    const double                growth =
      tangent * tangent / distance - last.normal * other.bend(last.parameter);
    std::vector<double>       change = tangent_gradient(last.normal);
    const std::vector<double> along  = gradient(last.parameter, tangent);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] = (change[i] + along[i] / distance) / growth;
    return change;
  }

  void StrutTouchMotion::add_instant_block(const AxisCurve     &other,
                                           const double         by_position,
                                           std::vector<double> &block) const
  {
    const StrutTouch::Opposite &opposite = touch.opposites.back();
    const dealii::Tensor<1, 3> &n        = opposite.normal;
    const double at = opposite.parameter, distance = opposite.length;
    const std::vector<double> normal_gradient = gradient(at, n);
    add_product(by_position * (touch.slope + touch.force / distance),
                normal_gradient,
                normal_gradient,
                block);
    for (unsigned int c = 0; c < dimension; ++c)
      {
        const std::vector<double> along = gradient(at, unit(c));
        add_product(-by_position * touch.force / distance, along, along, block);
      }
    if (!touch.is_inside)
      return;
    // The nearest point slides along the other axis.
    const std::vector<double>  nearest_gradient = nearest_change(other);
    const dealii::Tensor<1, 3> tangent          = other.tangent(at);
    add_product(by_position * touch.force *
                  (tangent * tangent / distance - n * other.bend(at)),
                nearest_gradient,
                nearest_gradient,
                block);
  }

  void StrutTouchMotion::add_mean_block(std::vector<double> &block) const
  {
    const StrutTouch::Opposite &last = touch.opposites.back();
    const std::vector<double>   depth_gradient =
      gradient(last.parameter, last.normal);
    const double part = 1. / touch.opposites.size();
    for (const StrutTouch::Opposite &opposite : touch.opposites)
      {
        const std::vector<double> direction_gradient =
          gradient(opposite.parameter, opposite.direction);
        add_product(part * touch.slope,
                    direction_gradient,
                    depth_gradient,
                    block);
        const double direction_stiffness =
          -part * touch.force / opposite.length;
        for (unsigned int c = 0; c < dimension; ++c)
          {
            const std::vector<double> along =
              gradient(opposite.parameter, unit(c));
            add_product(direction_stiffness, along, along, block);
          }
        add_product(-direction_stiffness,
                    direction_gradient,
                    gradient(opposite.parameter, opposite.normal),
                    block);
      }
  }

  void StrutTouchMotion::add_friction_block(const CoulombFriction &friction,
                                            const AxisCurve       &other,
                                            const Evaluation      &evaluation,
                                            const TangentFactors  &factors,
                                            std::vector<double>   &block) const
  {
    const StrutTouch::Opposite &last   = touch.opposites.back();
    const dealii::Tensor<1, 3> &n      = last.normal;
    const FrictionChange        change = friction.change(touch.friction, n);
    const auto                  across = change.by_normal / touch.distance;
    std::vector<double>         nearest_gradient;
    dealii::Tensor<1, 3>        by_nearest;
    if (touch.is_inside)
      {
        nearest_gradient = nearest_change(other);
        by_nearest       = factors.stiffness *
          (change.by_velocity *
             sliding_velocity(evaluation,
                              [&](const Vector &u) {
                                return difference_slope(u);
                              }) -
           across * other.tangent(last.parameter));
        // The point of application moves too.
        add_product(factors.stiffness,
                    tangent_gradient(touch.friction.force),
                    nearest_gradient,
                    block);
      }
    for (unsigned int c = 0; c < dimension; ++c)
      {
        dealii::Tensor<1, 3> by_motion =
          factors.damping * change.by_velocity[c] +
          factors.stiffness *
            (across[c] - (across[c] * n) * n -
             touch.slope * change.by_pressure[c] * n);
        std::vector<double> force_gradient =
          gradient(last.parameter, by_motion);
        for (std::size_t i = 0; i < nearest_gradient.size(); ++i)
          force_gradient[i] += by_nearest[c] * nearest_gradient[i];
        add_product(1.,
                    gradient(last.parameter, unit(c)),
                    force_gradient,
                    block);
      }
  }
} // namespace auxfem
