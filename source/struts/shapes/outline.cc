#include <auxfem/struts/shapes/outline.h>
#include <auxfem/struts/shapes/saint_venant.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;
    using Point2 = dealii::Point<2>;

    /** Chords for a quarter of a circle. */
    constexpr unsigned int chords_per_quarter = 8;

    /** Product of inertia over the sum of both moments below which it is
     * round-off. */
    constexpr double inertia_round_off = 1e-10;

    Point2 next_corner(const Outline &outline, const unsigned int i)
    {
      return outline[(i + 1) % outline.size()];
    }

    /** Whether @p p lies on the side from @p a to @p b, with which it is
     * collinear. */
    bool is_between(const Point2 &a, const Point2 &b, const Point2 &p)
    {
      return (p - a) * (p - b) <= 0;
    }

    /** Whether two sides have a common point. */
    bool
    meet(const Point2 &a, const Point2 &b, const Point2 &c, const Point2 &d)
    {
      const double at_c = twice_area(a, b, c), at_d = twice_area(a, b, d),
                   at_a = twice_area(c, d, a), at_b = twice_area(c, d, b);
      return (at_c * at_d < 0 && at_a * at_b < 0) ||
        (at_c == 0 && is_between(a, b, c)) ||
        (at_d == 0 && is_between(a, b, d)) ||
        (at_a == 0 && is_between(c, d, a)) ||
        (at_b == 0 && is_between(c, d, b));
    }

    /** Whether the sides @p a - @p b and @p b - @p c lie on each other. */
    bool fold(const Point2 &a, const Point2 &b, const Point2 &c)
    {
      return twice_area(a, b, c) == 0 && (a - b) * (c - b) > 0;
    }

    /** Area and moments of a polygon about the drawn axes, by Green's theorem.
     */
    struct PolygonMoments
    {
      double area = 0, y = 0, z = 0, yy = 0, zz = 0, yz = 0;

      explicit PolygonMoments(const Outline &outline)
      {
        for (unsigned int i = 0; i < outline.size(); ++i)
          {
            const Point2 a = outline[i], b = next_corner(outline, i);
            const double w = a[0] * b[1] - a[1] * b[0];
            area += w / 2;
            y += w * (a[0] + b[0]) / 6;
            z += w * (a[1] + b[1]) / 6;
            yy += w * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 12;
            zz += w * (a[1] * a[1] + a[1] * b[1] + b[1] * b[1]) / 12;
            yz += w *
              (a[0] * b[1] + 2 * a[0] * a[1] + 2 * b[0] * b[1] + b[0] * a[1]) /
              24;
          }
      }
    };

    /** Angle to the principal axes next to the drawn ones (rad). */
    double principal_angle_of(const PolygonMoments &moments)
    {
      if (std::abs(moments.yz) < inertia_round_off * (moments.yy + moments.zz))
        return 0;
      const double difference = moments.yy - moments.zz;
      const double angle =
        std::atan2(difference < 0 ? -2 * moments.yz : 2 * moments.yz,
                   std::abs(difference)) /
        2;
      // With equal moments round-off decides between both ends of the range.
      return angle < -(1 - inertia_round_off) * PI / 4 ? angle + PI / 2 : angle;
    }

    /** Moves the origin to the centroid. */
    void center(Outline &outline)
    {
      // Twice, since the moments of an outline far from the origin cancel.
      for (unsigned int repetition = 0; repetition < 2; ++repetition)
        {
          const PolygonMoments moments(outline);
          for (Point2 &corner : outline)
            corner -= Point2(moments.y, moments.z) / moments.area;
        }
    }

    /** Coordinates in axes turned by @p angle (rad). */
    void turn(Outline &outline, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      for (Point2 &corner : outline)
        corner = {c * corner[0] + s * corner[1], c * corner[1] - s * corner[0]};
    }

    /** Corners of the convex hull (Andrew's monotone chain). */
    std::vector<Point2> convex_hull(Outline points)
    {
      const auto is_before = [](const Point2 &a, const Point2 &b) {
        return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
      };
      std::sort(points.begin(), points.end(), is_before);
      std::vector<Point2> hull;
      for (unsigned int half = 0; half < 2; ++half)
        {
          const std::size_t begin = hull.size();
          for (const Point2 &point : points)
            {
              while (hull.size() >= begin + 2 &&
                     twice_area(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
              hull.push_back(point);
            }
          hull.pop_back();
          std::reverse(points.begin(), points.end());
        }
      return hull;
    }

    /** Half the extent along an axis (m). */
    double half_extent(const Outline &outline, const unsigned int axis)
    {
      const auto [least, most] =
        std::minmax_element(outline.begin(),
                            outline.end(),
                            [axis](const Point2 &a, const Point2 &b) {
                              return a[axis] < b[axis];
                            });
      return ((*most)[axis] - (*least)[axis]) / 2;
    }

    /** Appends an arc from the direction @p incoming, by the angle @p turn,
     * around a sharp corner. Points between its ends lie further out than the
     * arc, so that chords enclose its area. */
    void append_arc(const Point2               &corner,
                    const double                radius,
                    const dealii::Tensor<1, 2> &incoming,
                    const double                turn,
                    Outline                    &outline)
    {
      const double n =
        std::max(3., std::ceil(std::abs(turn) / (PI / 2) * chords_per_quarter));
      const double step = std::abs(turn) / n;
      const double stretch =
        (std::sqrt(1 + (n - 2) * n * step / std::sin(step)) - 1) / (n - 2);
      const dealii::Tensor<1, 2> inward = std::copysign(radius, turn) *
        dealii::Tensor<1, 2>({-incoming[1], incoming[0]});
      const Point2 center =
        corner - radius * std::tan(std::abs(turn) / 2) * incoming + inward;
      for (unsigned int k = 0; k <= n; ++k)
        {
          const Point2 point = center +
            (k == 0 || k == n ? 1. : stretch) *
              (radius * std::sin(k * step) * incoming -
               std::cos(k * step) * inward);
          // Two arcs may meet in the middle of a side.
          if (outline.empty() || outline.back().distance(point) > 1e-9 * radius)
            outline.push_back(point);
        }
    }
  } // namespace

  double twice_area(const dealii::Point<2> &a,
                    const dealii::Point<2> &b,
                    const dealii::Point<2> &c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  namespace
  {
    /** Without corners at their predecessor but for round-off, as where arcs
     * take up a whole side. */
    Outline without_repetitions(const Outline &outline)
    {
      double size = 0;
      for (const Point2 &corner : outline)
        size = std::max(size, corner.distance(outline.front()));
      Outline result;
      for (std::size_t i = 0; i < outline.size(); ++i)
        if (outline[i].distance(next_corner(outline, i)) > 1e-12 * size)
          result.push_back(outline[i]);
      return result;
    }
  } // namespace

  Outline rounded_outline(const std::vector<RoundedCorner> &corners)
  {
    Outline           outline;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const RoundedCorner &before = corners[(i + n - 1) % n],
                            &corner = corners[i], &after = corners[(i + 1) % n];
        const Point2 at(corner.y, corner.z);
        if (corner.radius == 0)
          {
            outline.push_back(at);
            continue;
          }
        auto incoming = at - Point2(before.y, before.z),
             outgoing = Point2(after.y, after.z) - at;
        incoming /= incoming.norm();
        outgoing /= outgoing.norm();
        const double sine =
          incoming[0] * outgoing[1] - incoming[1] * outgoing[0];
        append_arc(at,
                   corner.radius,
                   incoming,
                   std::atan2(sine, incoming * outgoing),
                   outline);
      }
    return without_repetitions(outline);
  }

  double signed_area(const Outline &outline)
  {
    return PolygonMoments(outline).area;
  }

  std::optional<std::pair<unsigned int, unsigned int>>
  crossing_sides(const Outline &outline)
  {
    const unsigned int n = outline.size();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i + 1; j < n; ++j)
        {
          const Point2 &a = outline[i], &c = outline[j];
          const Point2 b = next_corner(outline, i), d = next_corner(outline, j);
          if (j == i + 1           ? fold(a, b, d)
                : (j + 1) % n == i ? fold(c, a, b)
                                   : meet(a, b, c, d))
            return {{i, j}};
        }
    return std::nullopt;
  }

  CrossSection section_in_outline(Outline outline)
  {
    CrossSection section;
    center(outline);
    section.principal_angle = principal_angle_of(PolygonMoments(outline));
    turn(outline, section.principal_angle);
    const PolygonMoments moments(outline);
    section.area            = moments.area;
    section.second_moment_2 = moments.zz;
    section.second_moment_3 = moments.yy;
    const SaintVenantConstants constants =
      solve_saint_venant(triangulate(outline));
    section.torsion_constant = constants.torsion_constant;
    section.shear_area_2     = constants.shear_areas[0];
    section.shear_area_3     = constants.shear_areas[1];
    section.half_thicknesses = {
      {half_extent(outline, 1), half_extent(outline, 0)}};
    section.radius       = section.half_thicknesses[1];
    section.outer_fibres = convex_hull(outline);
    section.make_stress_points =
      [points = std::make_shared<const std::vector<StressPoint>>(
         constants.stress_points)](unsigned int) {
        return StressPoints{*points, false};
      };
    return section;
  }
} // namespace auxfem
