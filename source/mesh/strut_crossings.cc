#include <auxfem/mesh/position_function.h>
#include <auxfem/mesh/strut_crossings.h>
#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <optional>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Number of chords that stand for an arc. */
    constexpr unsigned int n_chords = 16;

    /** Distance over the length of the shorter strut at which axes meet. */
    constexpr double meeting_distance = 1e-6;

    using Points = std::vector<dealii::Point<3>>;

    Points polyline(const Lattice &lattice, const Strut &strut)
    {
      Points points = {lattice.joints[strut.joints[0]],
                       lattice.joints[strut.joints[1]]};
      if (strut.sagitta == 0)
        return points;
      points.assign(n_chords + 1, {});
      dealii::Tensor<1, 3> tangent;
      for (unsigned int i = 0; i <= n_chords; ++i)
        lattice.axis(strut, double(i) / n_chords, points[i], tangent);
      return points;
    }

    /** Part of a strut at its ends where it may touch others. */
    constexpr double end_part = 1e-3;

    class Crossings
    {
    public:
      explicit Crossings(const Lattice &lattice) : lattice(lattice)
      {
        lines.reserve(lattice.struts.size());
        for (const Strut &strut : lattice.struts)
          lines.push_back(polyline(lattice, strut));
      }

      /** Calls @p visit with the numbers of struts whose axes meet, and a point
       * where they do. */
      template <class Visit>
      void for_each(const Visit &visit) const
      {
        std::vector<dealii::BoundingBox<3>> boxes;
        boxes.reserve(lines.size());
        for (unsigned int i = 0; i < lines.size(); ++i)
          {
            boxes.emplace_back(lines[i]);
            boxes.back().extend(meeting_distance *
                                lattice.length(lattice.struts[i]));
          }
        const auto tree = dealii::pack_rtree_of_indices(boxes);
        for (unsigned int a = 0; a < boxes.size(); ++a)
          tree.query(boost::geometry::index::intersects(boxes[a]),
                     boost::make_function_output_iterator(
                       [&](const std::size_t b) {
                         // Rigid rods may slide along struts.
                         if (b <= a || lattice.struts[a].is_rigid() ||
                             lattice.struts[b].is_rigid())
                           return;
                         if (const auto point = meeting_point(a, b))
                           visit(a, b, *point);
                       }));
      }

    private:
      std::optional<dealii::Point<3>> meeting_point(const unsigned int a,
                                                    const unsigned int b) const
      {
        if (are_equal(a, b))
          return lattice.centroid(lattice.struts[a]);
        for (const auto &[one, other] : {std::make_pair(a, b), {b, a}})
          for (const dealii::Point<3> &end :
               {lines[one].front(), lines[one].back()})
            if (meeting(tolerance(a, b), {end, end}, lines[other]))
              return end;
        const Points &line = lines[a];
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
          if (const auto fractions =
                meeting(tolerance(a, b), {line[i], line[i + 1]}, lines[b]);
              fractions && !is_end((*fractions)[0], i, line))
            return line[i] + (*fractions)[0] * (line[i + 1] - line[i]);
        return std::nullopt;
      }

      /** Distance (m) at which two struts meet. */
      double tolerance(const unsigned int a, const unsigned int b) const
      {
        return meeting_distance *
          std::min(lattice.length(lattice.struts[a]),
                   lattice.length(lattice.struts[b]));
      }

      /** Whether two struts have the same ends and the same middle. */
      bool are_equal(const unsigned int a, const unsigned int b) const
      {
        const Strut &one = lattice.struts[a], &other = lattice.struts[b];
        return std::minmax(one.joints[0], one.joints[1]) ==
          std::minmax(other.joints[0], other.joints[1]) &&
          lattice.centroid(one).distance(lattice.centroid(other)) <=
          tolerance(a, b);
      }

      /** Place on @p segment, and on a segment of @p line, where it comes within
       * @p tolerance of the line other than at its ends. */
      static std::optional<std::array<double, 2>>
      meeting(const double   tolerance,
              const Segment &segment,
              const Points  &line)
      {
        for (std::size_t j = 0; j + 1 < line.size(); ++j)
          {
            const NearestPoints nearest =
              nearest_points(segment, {line[j], line[j + 1]});
            if (nearest.distance <= tolerance &&
                !is_end(nearest.fractions[1], j, line))
              return nearest.fractions;
          }
        return std::nullopt;
      }

      /** Whether the fraction @p at of segment @p i is an end of @p line. */
      static bool
      is_end(const double at, const std::size_t i, const Points &line)
      {
        return (i == 0 && at < end_part) ||
          (i + 2 == line.size() && at > 1 - end_part);
      }

      const Lattice      &lattice;
      std::vector<Points> lines;
    };
  } // namespace

  void refuse_crossing_struts(const Lattice &lattice)
  {
    std::ostringstream text;
    unsigned int       n = 0;
    Crossings(lattice).for_each([&](const unsigned int      a,
                                    const unsigned int      b,
                                    const dealii::Point<3> &point) {
      if (n++ == 0)
        text << "Lattice: struts " << a << " and " << b << " meet at "
             << position_text(point, lattice.dimension)
             << " without a common joint there";
    });
    if (n > 1)
      text << ", and so do " << n - 1 << " more pairs";
    if (n > 0)
      throw InputError(
        text.str() +
        ".\nWalls that cross or lie on each other would not feel each other. "
        "Change the cell so that they do not meet, or give them a joint; if "
        "they lie side by side, set Lattice/Struts may cross = true.");
  }
} // namespace auxfem
