#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/strut_gap.h>
#include <auxfem/mesh/strut_geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace auxfem
{
  namespace
  {
    /** A part of a curve, approximated by its chord. */
    struct CurvePart
    {
      CurvePart(const AxisCurve &curve, const double begin, const double end)
        : curve(&curve)
        , begin(begin)
        , end(end)
        , chord{dealii::Point<3>(curve.at(begin)),
                dealii::Point<3>(curve.at(end))}
      {
        constexpr double safety = 1.1;
        if (curve.degree > 1)
          for (const double at : {0.25, 0.5, 0.75})
            away = std::max(away,
                            safety *
                              (curve.at(begin + at * (end - begin)) -
                               ((1 - at) * chord.begin + at * chord.end))
                                .norm());
      }

      std::array<CurvePart, 2> halves() const
      {
        const double middle = (begin + end) / 2;
        return {
          {CurvePart(*curve, begin, middle), CurvePart(*curve, middle, end)}};
      }

      const AxisCurve *curve;
      double           begin, end;
      Segment          chord;
      double           away = 0; ///< of the curve from the chord, at most (m)
    };

    /** Lowers @p least to a lower bound of the distance of two curve parts (m),
     * within @p tolerance. */
    void lower_to_distance(const CurvePart &one,
                           const CurvePart &other,
                           const double     tolerance,
                           double          &least)
    {
      const double away  = one.away + other.away,
                   bound = distance(one.chord, other.chord) - away;
      if (bound >= least)
        return;
      // Distant parts need no further subdivision.
      if (away <= std::max(tolerance, 0.05 * bound))
        {
          least = bound;
          return;
        }
      if (one.away >= other.away)
        for (const CurvePart &half : one.halves())
          lower_to_distance(half, other, tolerance, least);
      else
        for (const CurvePart &half : other.halves())
          lower_to_distance(one, half, tolerance, least);
    }

    /** Smallest cosine between the tangents of two elements of a strut and
     * their common chord. */
    double least_lean_cosine(const AxisCurve &one, const AxisCurve &other)
    {
      const AxisCurve::Vector chord = other.at(1) - one.at(0);
      double                  least = 1;
      for (const AxisCurve *curve : {&one, &other})
        for (unsigned int i = 0; i <= curve->degree; ++i)
          {
            const AxisCurve::Vector tangent =
              curve->tangent(double(i) / curve->degree);
            const double product = tangent * chord,
                         norms   = tangent.norm() * chord.norm();
            least = std::min(least, norms > 0 ? product / norms : -1.);
          }
      return least;
    }

    /** Rotation margin of two elements of one strut (rad). */
    double rotation_margin_within_strut(const AxisCurve &one,
                                        const AxisCurve &other,
                                        const double     least)
    {
      // The chord rotates with the tangents.
      constexpr double safety = 2;
      const double     lean =
                     std::acos(std::max(-1., least_lean_cosine(one, other))),
                   most =
                     std::acos(std::min(1., (1 + least) / dealii::numbers::PI));
      return std::max((most - lean) / safety, 0.);
    }

    /** Safety factor of the rotation at which connected axes become near. */
    constexpr double rotation_safety_factor = 1.5;

    using Curves = std::array<AxisCurve, 2>;

    /** Upper bound of the relative motion of points of two curves (m). */
    double relative_motion(const Curves &from, const Curves &to)
    {
      // Common motion is no relative motion.
      AxisCurve::Vector common;
      for (unsigned int i = 0; i < 2; ++i)
        common += (to[i].at(0.5) - from[i].at(0.5)) / 2;
      double sum = 0;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int n = 2 * std::max(from[i].degree, to[i].degree);
          double             largest = 0;
          for (unsigned int k = 0; k <= n; ++k)
            {
              const double at = double(k) / n;
              largest =
                std::max(largest,
                         (to[i].at(at) - from[i].at(at) - common).norm());
            }
          sum += largest;
        }
      return sum;
    }

    /** Curve at a fraction @p part of the path. */
    AxisCurve
    between(const AxisCurve &from, const AxisCurve &to, const double part)
    {
      AxisCurve result = from;
      result.degree    = std::max(from.degree, to.degree);
      for (unsigned int k = 0; k <= result.degree; ++k)
        result.coefficients[k] =
          (1 - part) * from.coefficients[k] + part * to.coefficients[k];
      return result;
    }
  } // namespace

  double
  distance(const AxisCurve &one, const AxisCurve &other, const double tolerance)
  {
    double least = std::numeric_limits<double>::infinity();
    lower_to_distance(CurvePart(one, 0, 1),
                      CurvePart(other, 0, 1),
                      tolerance,
                      least);
    return least;
  }

  StrutGap::StrutGap(const StrutCurves &curves) : curves(curves)
  {}

  double StrutGap::operator()(const AxisPair  &pair,
                              const AxisCurve &one,
                              const AxisCurve &other) const
  {
    return curves.list()[pair[0]].line == curves.list()[pair[1]].line
      ? gap_within_strut(pair, one, other)
      : gap_between_struts(pair, one, other);
  }

  double StrutGap::gap_between_struts(const AxisPair  &pair,
                                      const AxisCurve &one,
                                      const AxisCurve &other) const
  {
    // Small against the allowed penetration of a near pair.
    constexpr double digits    = 0.02;
    const double     thickness = curves.thickness(pair[0], pair[1]);
    double           least     = std::numeric_limits<double>::infinity();
    const auto check = [&](const CurvePart &first, const CurvePart &second) {
      lower_to_distance(first, second, digits * thickness, least);
    };
    for (const auto &range : curves.free_ranges(pair[0], pair[1]))
      check(CurvePart(one, range[0], range[1]), CurvePart(other, 0, 1));
    for (const auto &range : curves.free_ranges(pair[1], pair[0]))
      check(CurvePart(one, 0, 1), CurvePart(other, range[0], range[1]));
    return least - thickness;
  }

  double StrutGap::gap_within_strut(const AxisPair  &pair,
                                    const AxisCurve &one,
                                    const AxisCurve &other) const
  {
    const double thickness = curves.thickness(pair[0], pair[1]);
    if (pair[1] > pair[0] + 1)
      {
        // Separated elements are usually far apart as a whole.
        const double apart = distance(one, other, thickness);
        if (apart > 2 * thickness)
          return apart - thickness;
      }
    // For small inclinations the distance of points is at least the cosine
    // times their arc length.
    else if (const double apart =
               least_lean_cosine(one, other) * dealii::numbers::PI;
             apart > 1)
      return (apart - 1) * thickness;
    constexpr unsigned int n     = 16;
    double                 least = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i <= n; ++i)
      for (const auto &part :
           curves.self_contact_ranges(pair[0], double(i) / n, pair[1]))
        least =
          std::min(least,
                   nearest_point(other, one.at(double(i) / n), part[0], part[1])
                     .distance);
    return least - thickness;
  }

  bool StrutGap::is_line_at_rest(const unsigned int axis,
                                 const AxisCurve   &curve) const
  {
    if (curve.degree > 1)
      return false;
    const AxisCurve rest = curves.at_rest(axis);
    return rest.degree == 1 && curve.coefficients[0] == rest.coefficients[0] &&
      curve.coefficients[1] == rest.coefficients[1];
  }

  double StrutGap::rotation_margin(const AxisPair  &pair,
                                   const AxisCurve &one,
                                   const AxisCurve &other,
                                   const double     least) const
  {
    if (curves.list()[pair[0]].line == curves.list()[pair[1]].line)
      return rotation_margin_within_strut(one, other, least);
    if (are_lines_at_rest(pair, one, other))
      if (const double margin = rotation_margin_at_rest(pair, least);
          margin > 0)
        return margin;
    constexpr unsigned int n = 4;
    const double apart       = (1 + least) * curves.thickness(pair[0], pair[1]);
    double       margin      = dealii::numbers::PI;
    const auto   check       = [&](const unsigned int first,
                           const AxisCurve   &axis,
                           const AxisCurve   &opposite,
                           const CommonNode  &node) {
      const double length          = curves.list()[pair[first]].length,
                   opposite_length = curves.list()[pair[1 - first]].length;
      for (const auto &range : curves.free_ranges(pair[first], pair[1 - first]))
        for (unsigned int i = 0; i <= n; ++i)
          {
            const double       at = range[0] + (range[1] - range[0]) * i / n;
            const NearestPoint nearest = nearest_point(opposite, axis.at(at));
            const double       arm = std::abs(at - node.end[first]) * length +
              std::abs(nearest.parameter - node.end[1 - first]) *
                opposite_length;
            margin = std::min(margin,
                              (nearest.distance - apart) /
                                (rotation_safety_factor * arm));
          }
    };
    for (const CommonNode &node : curves.common_nodes(pair[0], pair[1]))
      {
        check(0, one, other, node);
        check(1, other, one, node);
      }
    return std::max(margin, 0.);
  }

  double StrutGap::rotation_margin_at_rest(const AxisPair &pair,
                                           const double    least) const
  {
    const double apart  = (1 + least) * curves.thickness(pair[0], pair[1]);
    double       margin = dealii::numbers::PI;
    for (const CommonNode &node : curves.common_nodes(pair[0], pair[1]))
      {
        AxisCurve::Vector lines[2];
        for (unsigned int i = 0; i < 2; ++i)
          {
            const AxisCurve::Vector line = curves.at_rest(pair[i]).tangent(0);
            lines[i] = (node.end[i] > 0 ? -1. : 1.) / line.norm() * line;
          }
        // Distance of mutually nearest points over their arc length to the
        // node.
        const double cosine   = std::max(lines[0] * lines[1], 0.),
                     distance = std::sqrt((1 - cosine) / (1 + cosine));
        margin =
          std::min(margin,
                   distance *
                     (1 - apart / curves.free_distance(pair[0], pair[1])) /
                     rotation_safety_factor);
      }
    return margin;
  }

  bool StrutGap::falls_below(const AxisPair                 &pair,
                             const std::array<AxisCurve, 2> &from,
                             const std::array<AxisCurve, 2> &to,
                             const double                    least) const
  {
    constexpr unsigned int max_checks = 40;
    constexpr double       start = 1e-3, digits = 0.05;
    const double           largest = relative_motion(from, to);
    double                 margin  = (*this)(pair, to[0], to[1]) - least;
    if (margin < 0)
      return true;
    // Larger than the error of gaps, so an accepted position is not reported
    // again.
    const double slack = digits * curves.thickness(pair[0], pair[1]);
    // Conservative advancement from the end to the accepted start: a gap
    // shrinks by no more than the relative motion.
    double part = 1;
    for (unsigned int i = 0; i < max_checks; ++i)
      {
        part -= (margin + slack) / std::max(largest, margin + slack);
        if (part <= start)
          return false;
        margin = (*this)(pair,
                         between(from[0], to[0], part),
                         between(from[1], to[1], part)) -
          least;
        // The iteration approaches the limit from above and never reaches it.
        if (margin <= -slack / 2)
          return true;
      }
    // Connected axes stay near for any motion.
    return !curves.are_neighbours(pair[0], pair[1]);
  }

  namespace
  {
    /** Boxes from the part onwards that intersect the bounding box of the
     * part. */
    std::vector<unsigned int>
    boxes_near(const std::vector<dealii::BoundingBox<3>> &boxes,
               const std::array<std::size_t, 2>          &part)
    {
      std::vector<unsigned int> near;
      if (part[0] == part[1])
        return near;
      dealii::BoundingBox<3> around = boxes[part[0]];
      for (std::size_t a = part[0]; a < part[1]; ++a)
        around.merge_with(boxes[a]);
      for (std::size_t b = part[0]; b < boxes.size(); ++b)
        if (boost::geometry::intersects(around, boxes[b]))
          near.push_back(b);
      return near;
    }
  } // namespace

  std::vector<AxisPair>
  pairs_that_meet(const std::vector<dealii::BoundingBox<3>> &boxes,
                  const std::array<std::size_t, 2>          &part)
  {
    const std::vector<unsigned int>     others = boxes_near(boxes, part);
    std::vector<dealii::BoundingBox<3>> boxes_of_others;
    for (const unsigned int b : others)
      boxes_of_others.push_back(boxes[b]);
    const auto            tree = dealii::pack_rtree_of_indices(boxes_of_others);
    std::vector<AxisPair> pairs;
    for (unsigned int a = part[0]; a < part[1]; ++a)
      tree.query(boost::geometry::index::intersects(boxes[a]),
                 boost::make_function_output_iterator([&](const std::size_t i) {
                   if (others[i] > a)
                     pairs.push_back({{a, others[i]}});
                 }));
    return pairs;
  }

  dealii::BoundingBox<3> box_around(const AxisCurve &curve, const double margin)
  {
    // Box of chords, extended by the deviation of the curve from them.
    const unsigned int n    = curve.degree == 1 ? 1 : curve.degree + 1;
    double             away = 0;
    dealii::Point<3>   before(curve.at(0)), least = before, most = before;
    for (unsigned int i = 1; i <= n; ++i)
      {
        const dealii::Point<3> now(curve.at(double(i) / n));
        for (unsigned int d = 0; d < 3; ++d)
          {
            least[d] = std::min(least[d], now[d]);
            most[d]  = std::max(most[d], now[d]);
          }
        if (n > 1)
          {
            const AxisCurve::Vector middle = (before + now) / 2;
            away = std::max(away, (curve.at((i - 0.5) / n) - middle).norm());
          }
        before = now;
      }
    dealii::BoundingBox<3> box({least, most});
    box.extend(away + margin);
    return box;
  }

  std::vector<StrutOverlap> find_overlaps(const StrutCurves           &curves,
                                          const std::vector<AxisPair> &near,
                                          const UnknownLayout         &layout)
  {
    // Struts closer than this, over half the sum of their thicknesses, pass
    // each other.
    constexpr double passing = 0.5, digits = 0.01;

    // Distances over the thickness.
    const std::vector<double> distances =
      shared_results(near.size(), layout, [&](const std::size_t i) {
        const auto [a, b] = near[i];
        if (curves.are_neighbours(a, b) || curves.never_touch(a, b))
          return std::numeric_limits<double>::infinity();
        const double thickness = curves.thickness(a, b);
        return distance(curves.at_rest(a),
                        curves.at_rest(b),
                        digits * thickness) /
          thickness;
      });
    std::map<std::array<unsigned int, 2>, double> least;
    for (std::size_t i = 0; i < near.size(); ++i)
      if (distances[i] < 1 - digits)
        {
          const auto [one, other] = std::minmax(curves.list()[near[i][0]].line,
                                                curves.list()[near[i][1]].line);
          double &known =
            least.try_emplace({{one, other}}, distances[i]).first->second;
          known = std::min(known, distances[i]);
        }
    std::vector<StrutOverlap> overlaps;
    for (const auto &[pair, part] : least)
      {
        const auto strut_of = [&](const unsigned int line) {
          return curves.list()[curves.axes_of(line)[0]].strut;
        };
        overlaps.push_back(
          {{{strut_of(pair[0]), strut_of(pair[1])}}, pair, part < passing});
      }
    return overlaps;
  }
} // namespace auxfem
