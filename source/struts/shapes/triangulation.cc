#include <auxfem/struts/shapes/triangulation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace auxfem
{
  namespace
  {
    using Triangles = std::vector<std::array<unsigned int, 3>>;

    /** Growth of the distance of points on a side with that from its ends. */
    constexpr double point_growth = 0.5;

    /** Angle beyond a straight one from which a corner is re-entrant (rad);
     * chords of arcs turn by less. */
    constexpr double reentrant_angle = 0.3;

    /** Distance of @p p from the side from @p a to @p b (m). */
    double distance_from_side(const dealii::Point<2> &p,
                              const dealii::Point<2> &a,
                              const dealii::Point<2> &b)
    {
      const auto   along = b - a;
      const double part =
        std::clamp((p - a) * along / along.norm_square(), 0., 1.);
      return p.distance(a + part * along);
    }

    /** Distance of a corner from the nearest side that does not end there (m).
     */
    double width_at(const Outline &outline, const dealii::Point<2> &corner)
    {
      double width = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < outline.size(); ++i)
        {
          const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
          if (a != corner && b != corner)
            width = std::min(width, distance_from_side(corner, a, b));
        }
      return width;
    }

    /** A side between two corners, at which the section has given widths. */
    struct Side
    {
      dealii::Point<2> a, b;
      double           width_a, width_b;

      /** Appends points between two parts of the side by halving. */
      void divide(const double begin, const double end, Outline &points) const
      {
        const double middle = (begin + end) / 2, length = a.distance(b);
        const double spacing =
          std::min(width_a + point_growth * middle * length,
                   width_b + point_growth * (1 - middle) * length);
        if ((end - begin) * length <= spacing)
          return;
        divide(begin, middle, points);
        points.push_back(a + middle * (b - a));
        divide(middle, end, points);
      }
    };

    Outline with_points_on_sides(const Outline &outline)
    {
      std::vector<double> widths;
      for (const dealii::Point<2> &corner : outline)
        widths.push_back(width_at(outline, corner));
      Outline result;
      for (std::size_t i = 0; i < outline.size(); ++i)
        {
          const std::size_t next = (i + 1) % outline.size();
          // A side that is passed twice gets the same points both times.
          const auto is_before = [](const auto &one, const auto &other) {
            return one[0] < other[0] ||
              (one[0] == other[0] && one[1] < other[1]);
          };
          const bool        forwards = is_before(outline[i], outline[next]);
          const std::size_t a = forwards ? i : next, b = forwards ? next : i;
          Outline           points;
          Side{outline[a], outline[b], widths[a], widths[b]}.divide(0,
                                                                    1,
                                                                    points);
          if (!forwards)
            std::reverse(points.begin(), points.end());
          result.push_back(outline[i]);
          result.insert(result.end(), points.begin(), points.end());
        }
      return result;
    }

    /** Whether no other corner lies in the triangle at corner @p i. */
    bool is_ear(const Outline                   &points,
                const std::vector<unsigned int> &corners,
                const std::size_t                i)
    {
      const std::size_t n = corners.size();
      const auto &a = points[corners[(i + n - 1) % n]], &b = points[corners[i]],
                 &c = points[corners[(i + 1) % n]];
      if (!(twice_area(a, b, c) > 0))
        return false;
      return std::none_of(corners.begin(),
                          corners.end(),
                          [&](const unsigned int corner) {
                            const auto &p = points[corner];
                            return p != a && p != b && p != c &&
                              twice_area(a, b, p) >= 0 &&
                              twice_area(b, c, p) >= 0 &&
                              twice_area(c, a, p) >= 0;
                          });
    }

    /** Triangles of the polygon through @p corners, numbers of points. */
    Triangles cut_ears(const Outline &points, std::vector<unsigned int> corners)
    {
      Triangles triangles;
      while (corners.size() > 3)
        {
          const std::size_t n = corners.size();
          std::size_t       i = 0;
          while (i + 1 < n && !is_ear(points, corners, i))
            ++i;
          triangles.push_back(
            {{corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]}});
          corners.erase(corners.begin() + i);
        }
      triangles.push_back({{corners[0], corners[1], corners[2]}});
      return triangles;
    }

    /** Whether @p d lies within the circle through a triangle, by more than
     * round-off: the angles at c and d above the side a - b exceed pi. */
    bool is_in_circle(const dealii::Point<2> &a,
                      const dealii::Point<2> &b,
                      const dealii::Point<2> &c,
                      const dealii::Point<2> &d)
    {
      const auto   ca = a - c, cb = b - c, da = a - d, db = b - d;
      const double sine_of_sum =
        twice_area(a, b, c) * (da * db) - twice_area(a, b, d) * (ca * cb);
      return sine_of_sum <
        -1e-10 * ca.norm() * cb.norm() * da.norm() * db.norm();
    }

    /** Flips the first side that violates Delaunay's condition, if any. */
    bool flip_one(const Outline &points, Triangles &triangles)
    {
      std::map<std::pair<unsigned int, unsigned int>,
               std::pair<std::size_t, unsigned int>>
        sides;
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (unsigned int k = 0; k < 3; ++k)
          sides[{triangles[t][k], triangles[t][(k + 1) % 3]}] = {t, k};
      for (const auto &[side, place] : sides)
        {
          const auto other = sides.find({side.second, side.first});
          if (other == sides.end())
            continue;
          auto &one            = triangles[place.first],
               &two            = triangles[other->second.first];
          const unsigned int c = one[(place.second + 2) % 3],
                             d = two[(other->second.second + 2) % 3];
          if (!is_in_circle(points[side.first],
                            points[side.second],
                            points[c],
                            points[d]))
            continue;
          one = {{c, side.first, d}};
          two = {{d, side.second, c}};
          return true;
        }
      return false;
    }

    /** Angle inside the section at the corner @p b after @p a and before @p c
     * (rad). */
    double interior_angle(const dealii::Point<2> &a,
                          const dealii::Point<2> &b,
                          const dealii::Point<2> &c)
    {
      const double angle = std::atan2(twice_area(b, c, a), (c - b) * (a - b));
      return angle < 0 ? angle + 2 * dealii::numbers::PI : angle;
    }

    /** Corners at which a hole is joined to the outer polygon appear twice; the
     * side that joins them divides their angle. */
    std::vector<dealii::Point<2>> reentrant_corners_of(const Outline &outline)
    {
      std::vector<dealii::Point<2>> corners;
      const std::size_t             n = outline.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          double angle = 0;
          for (std::size_t k = 0; k < n; ++k)
            if (outline[k] == outline[i])
              angle += interior_angle(outline[(k + n - 1) % n],
                                      outline[k],
                                      outline[(k + 1) % n]);
          if (angle > dealii::numbers::PI + reentrant_angle)
            corners.push_back(outline[i]);
        }
      return corners;
    }
  } // namespace

  TriangulatedSection triangulate(const Outline &outline)
  {
    TriangulatedSection       section;
    std::vector<unsigned int> corners;
    for (const dealii::Point<2> &point : with_points_on_sides(outline))
      {
        const auto known =
          std::find(section.points.begin(), section.points.end(), point);
        corners.push_back(known - section.points.begin());
        if (known == section.points.end())
          section.points.push_back(point);
      }
    section.triangles = cut_ears(section.points, corners);
    // Round-off could flip sides of tiny triangles back and forth.
    const std::size_t most_flips =
      section.points.size() * section.points.size();
    for (std::size_t n = 0;
         n < most_flips && flip_one(section.points, section.triangles);
         ++n)
      ;
    section.reentrant_corners = reentrant_corners_of(outline);
    return section;
  }
} // namespace auxfem
