#include <auxfem/equations/strut_contact_points.h>

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
    std::map<AxisPair, FacingStrut> by_axis_and_strut;
    const auto                      add = [&](const unsigned int axis,
                         const unsigned int other,
                         const unsigned int pair) {
      const unsigned int strut = curves.list()[other].strut;
      FacingStrut       &facing = by_axis_and_strut[{{axis, strut}}];
      facing.axis               = axis;
      facing.strut              = strut;
      facing.targets.push_back({other, pair});
    };
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        add(pairs[i][0], pairs[i][1], i);
        if (pairs[i][0] != pairs[i][1])
          add(pairs[i][1], pairs[i][0], i);
      }
    std::vector<FacingStrut> all;
    for (auto &[key, facing] : by_axis_and_strut)
      all.push_back(std::move(facing));
    return all;
  }

  unsigned int StrutContactPoints::n_points(const unsigned int axis) const
  {
    /**
     * Distance of contact points in space over half a thickness.
     * @tuned judgement: crossing struts touch along less than a thickness
     */
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
    const auto     look = [&](const FacingStrut::Target   &target,
                          const std::array<double, 2> &part) {
      const NearestPoint found =
        nearest_point(now.at(target.axis), point, part[0], part[1]);
      if (found.distance < result.point.distance)
        result = {target, found};
    };
    for (const FacingStrut::Target &target : facing.targets)
      if (curves.list()[facing.axis].strut == facing.strut)
        for (const auto &part :
             curves.parts_apart(facing.axis, parameter, target.axis))
          look(target, part);
      else
        look(target, {{0., 1.}});
    return result;
  }

  void
  StrutContactPoints::find_touching(const FacingStrut          &facing,
                                    const NearCurves           &now,
                                    const unsigned int          begin,
                                    const unsigned int          end,
                                    std::vector<TouchingPoint> &points) const
  {
    // Distances change by no more than the way along the axis, here with 10 %
    // of stretch.
    constexpr double     stretch = 1.1;
    const unsigned int   middle  = (begin + end) / 2;
    const double         at      = parameter(facing.axis, middle);
    const NearestOfStrut found =
      nearest(facing, now, now.at(facing.axis).at(at), at);
    const double left = found.point.distance -
      curves.thickness(facing.axis, facing.targets.front().axis);
    if (left < 0)
      points.push_back({middle, found});
    const double spacing =
      stretch * curves.list()[facing.axis].length / (n_points(facing.axis) - 1);
    const auto skipped =
      static_cast<unsigned int>(std::min(std::max(left, 0.) / spacing, 1e6));
    if (middle > begin + skipped)
      find_touching(facing, now, begin, middle - 1 - skipped, points);
    if (middle + skipped < end)
      find_touching(facing, now, middle + 1 + skipped, end, points);
  }

  std::vector<TouchingPoint>
  StrutContactPoints::touching(const FacingStrut &facing,
                               const NearCurves  &now) const
  {
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
          find_touching(facing, now, begin, end, points);
      }
    std::sort(points.begin(),
              points.end(),
              [](const TouchingPoint &one, const TouchingPoint &other) {
                return one.point < other.point;
              });
    return points;
  }
} // namespace auxfem
