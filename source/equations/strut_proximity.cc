#include <auxfem/equations/strut_proximity.h>
#include <auxfem/mesh/segment.h>

#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    using Curve      = AxisCurve;
    using CurvePoint = AxisCurve::Vector;
    using CurveLine  = std::vector<CurvePoint>;

    const std::string travel_record     = "contact of struts: travel",
                      pairs_record      = "contact of struts: pairs in reach",
                      neighbours_record = "contact of struts: near neighbours",
                      references_record = "contact of struts: references",
                      degrees_record    = "contact of struts: their degrees",
                      looked_record     = "contact of struts: last look",
                      last_record       = "contact of struts: last step";

    /** A record of any length, which may be nothing. */
    void keep_list(const std::string         &name,
                   const std::vector<double> &values,
                   Records                   &records)
    {
      std::vector<double> list = {double(values.size())};
      list.insert(list.end(), values.begin(), values.end());
      records.keep(name, list);
    }

    std::vector<double> kept_list(const std::string &name,
                                  const Records     &records)
    {
      std::vector<double> list =
        records.values(name, records.values_per_item(name));
      list.erase(list.begin());
      return list;
    }

    /** How far a pair is near before it touches, of half its thickness. */
    constexpr double near_part = 0.3;

    /** By which the tangents of an element turn before its neighbours are
     * looked at again (rad). */
    constexpr double turn_between_looks = 0.03;

    /** Points of a curve between two parameters, and by how much it is away
     * from the lines between them at most, about (m). */
    double line_of(const Curve &curve,
                   const double begin,
                   const double end,
                   CurveLine   &line)
    {
      const unsigned int n       = curve.degree == 1 ? 1 : curve.degree + 1;
      double             sagitta = 0;
      line.clear();
      for (unsigned int i = 0; i <= n; ++i)
        {
          line.push_back(curve.at(begin + (end - begin) * i / n));
          if (i > 0 && n > 1)
            {
              const CurvePoint middle =
                curve.at(begin + (end - begin) * (i - 0.5) / n);
              sagitta = std::max(sagitta,
                                 (middle - (line[i - 1] + line[i]) / 2).norm());
            }
        }
      return sagitta;
    }

    /** A part of a curve, seen as the line between its ends. */
    struct CurvePart
    {
      CurvePart(const Curve &curve, const double begin, const double end)
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

      const Curve *curve;
      double       begin, end;
      Segment      chord;
      double       away = 0; ///< of the curve from the chord, at most (m)
    };

    /** Lowers @p least to the distance of two parts of curves (m), or to less by
     * at most @p tolerance. */
    void lower_to_distance(const CurvePart &one,
                           const CurvePart &other,
                           const double     tolerance,
                           double          &least)
    {
      const double away  = one.away + other.away,
                   bound = distance(one.chord, other.chord) - away;
      if (bound >= least)
        return;
      // What is far is known well enough.
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

    /** Largest distance between points of two curves at one parameter (m). */
    double largest_distance(const Curve &one, const Curve &other)
    {
      const unsigned int n       = 2 * std::max(one.degree, other.degree);
      double             largest = 0;
      for (unsigned int i = 0; i <= n; ++i)
        largest =
          std::max(largest,
                   (one.at(double(i) / n) - other.at(double(i) / n)).norm());
      return largest;
    }

    /** The curve at a @p part of the way from one to another. */
    Curve between(const Curve &from, const Curve &to, const double part)
    {
      Curve result  = from;
      result.degree = std::max(from.degree, to.degree);
      for (unsigned int k = 0; k <= result.degree; ++k)
        result.coefficients[k] =
          (1 - part) * from.coefficients[k] + part * to.coefficients[k];
      return result;
    }
  } // namespace

  StrutProximity::StrutProximity(const LatticeModel &model,
                                 const StrutCurves  &curves)
    : model(model)
    , curves(curves)
    , reach(model.mean_strut_length / 4)
    , pairs_of_axis(curves.list().size())
    , neighbour_is_near(curves.neighbours().size(), false)
  {
    thinnest = std::numeric_limits<double>::infinity();
    for (unsigned int a = 0; a < curves.list().size(); ++a)
      {
        const double h = curves.list()[a].half_thickness;
        thickest       = std::max(thickest, h);
        if (h > 0)
          thinnest = std::min(thinnest, h);
        references.push_back(curves.at_rest(a));
      }
    for (unsigned int i = 0; i < curves.neighbours().size(); ++i)
      for (const unsigned int axis : curves.neighbours()[i])
        pairs_of_axis[axis].push_back(i);
  }

  double StrutProximity::margin(const AxisPair &pair) const
  {
    constexpr double steps = 4;
    return near_part * curves.thickness(pair[0], pair[1]) + steps * step_travel;
  }

  double StrutProximity::motion(const std::vector<double> &from,
                                const std::vector<double> &to) const
  {
    double square = 0;
    for (const ContactAxis &axis : curves.list())
      for (std::size_t i = 0; i < axis.unknowns.size();
           i += model.lattice.dimension)
        {
          double of_node = 0;
          for (unsigned int c = 0; c < model.lattice.dimension; ++c)
            of_node +=
              std::pow(to[axis.unknowns[i + c]] - from[axis.unknowns[i + c]],
                       2);
          square = std::max(square, of_node);
        }
    return std::sqrt(square);
  }

  double StrutProximity::gap_of_ranges(const AxisPair  &pair,
                                       const AxisCurve &one,
                                       const AxisCurve &other) const
  {
    // Of what is allowed to a pair that is near this is little.
    constexpr double digits    = 0.02;
    const double     thickness = curves.thickness(pair[0], pair[1]);
    double           least     = std::numeric_limits<double>::infinity();
    const auto look = [&](const CurvePart &first, const CurvePart &second) {
      lower_to_distance(first, second, digits * thickness, least);
    };
    for (const auto &range : curves.free_ranges(pair[0], pair[1]))
      look(CurvePart(one, range[0], range[1]), CurvePart(other, 0, 1));
    for (const auto &range : curves.free_ranges(pair[1], pair[0]))
      look(CurvePart(one, 0, 1), CurvePart(other, range[0], range[1]));
    return least - thickness;
  }

  double StrutProximity::gap_of_strut(const AxisPair  &pair,
                                      const AxisCurve &one,
                                      const AxisCurve &other) const
  {
    constexpr unsigned int n     = 16;
    double                 least = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i <= n; ++i)
      for (const auto &part :
           curves.parts_apart(pair[0], double(i) / n, pair[1]))
        least =
          std::min(least,
                   nearest_point(other, one.at(double(i) / n), part[0], part[1])
                     .distance);
    return least - curves.thickness(pair[0], pair[1]);
  }

  double StrutProximity::gap(const AxisPair  &pair,
                             const AxisCurve &one,
                             const AxisCurve &other) const
  {
    return curves.list()[pair[0]].strut == curves.list()[pair[1]].strut
      ? gap_of_strut(pair, one, other)
      : gap_of_ranges(pair, one, other);
  }

  double StrutProximity::gap(const AxisPair            &pair,
                             const std::vector<double> &u) const
  {
    return gap(pair, curve(pair[0], u), curve(pair[1], u));
  }

  std::vector<AxisPair>
  StrutProximity::pairs_in_boxes(const std::vector<double> &from,
                                 const std::vector<double> &to,
                                 const double               margin) const
  {
    std::vector<dealii::BoundingBox<3>> boxes;
    CurveLine                           line;
    for (unsigned int a = 0; a < curves.list().size(); ++a)
      {
        std::vector<dealii::Point<3>> points;
        double                        away = 0;
        for (const std::vector<double> *u : {&from, &to})
          {
            away = std::max(away, line_of(curve(a, *u), 0, 1, line));
            for (const CurvePoint &point : line)
              points.emplace_back(point);
          }
        boxes.emplace_back(points);
        boxes.back().extend(away + curves.list()[a].half_thickness + margin);
      }
    const auto            tree = dealii::pack_rtree_of_indices(boxes);
    std::vector<AxisPair> pairs;
    for (unsigned int a = 0; a < boxes.size(); ++a)
      tree.query(boost::geometry::index::intersects(boxes[a]),
                 boost::make_function_output_iterator([&](const std::size_t b) {
                   if (b > a && !curves.are_neighbours(a, b) &&
                       !curves.never_touch(a, b))
                     pairs.push_back({{a, static_cast<unsigned int>(b)}});
                 }));
    return pairs;
  }

  void StrutProximity::find_pairs_in_reach(const std::vector<double> &u)
  {
    in_reach.clear();
    for (const AxisPair &pair : pairs_in_boxes(u, u, reach / 2))
      in_reach.push_back({pair, 0., false});
    // What is not among them is more than the reach apart; half of it is left
    // for one step.
    list_due = travelled + reach / 4;
  }

  void StrutProximity::look_at_pairs(const std::vector<double> &u)
  {
    for (Reach &pair : in_reach)
      {
        if (travelled < pair.due && !pair.is_near)
          continue;
        const double left = gap(pair.pair, u) - margin(pair.pair);
        pair.is_near      = left < 0;
        pair.due          = travelled + std::max(left, 0.) / 2;
      }
  }

  bool StrutProximity::has_turned(const unsigned int axis,
                                  const AxisCurve   &now) const
  {
    const double allowed =
      std::pow(turn_between_looks * curves.list()[axis].length, 2);
    AxisCurve change = references[axis];
    change.degree    = std::max(now.degree, change.degree);
    for (unsigned int k = 1; k <= change.degree; ++k)
      change.coefficients[k] -= now.coefficients[k];
    for (unsigned int i = 0; i <= change.degree; ++i)
      if (change.tangent(double(i) / change.degree).norm_square() > allowed)
        return true;
    return false;
  }

  double StrutProximity::unseen_motion() const
  {
    // Twice this is half of what is left between pairs that are not near.
    return near_part * thinnest / 2;
  }

  std::vector<unsigned int>
  StrutProximity::turned_axes(const std::vector<double> &u) const
  {
    std::vector<unsigned int> turned;
    for (unsigned int a = 0; a < references.size(); ++a)
      if (!pairs_of_axis[a].empty() && has_turned(a, curve(a, u)))
        turned.push_back(a);
    return turned;
  }

  std::vector<unsigned int>
  StrutProximity::neighbours_of(const std::vector<unsigned int> &turned) const
  {
    std::vector<unsigned int> pairs;
    for (const unsigned int axis : turned)
      pairs.insert(pairs.end(),
                   pairs_of_axis[axis].begin(),
                   pairs_of_axis[axis].end());
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  void StrutProximity::look_at_neighbours(const std::vector<double> &u)
  {
    // Until they are looked at again their turning may close the gap by this
    // part of their distance from the joint, where that is some thicknesses.
    constexpr double                closing = 6 * turn_between_looks;
    const std::vector<unsigned int> turned  = turned_axes(u);
    for (const unsigned int i : neighbours_of(turned))
      {
        const AxisPair &pair = curves.neighbours()[i];
        neighbour_is_near[i] = gap(pair, u) <
          margin(pair) + closing * curves.thickness(pair[0], pair[1]);
      }
    for (const unsigned int axis : turned)
      references[axis] = curve(axis, u);
  }

  bool StrutProximity::collect_near()
  {
    std::vector<AxisPair> now;
    for (const Reach &pair : in_reach)
      if (pair.is_near)
        now.push_back(pair.pair);
    for (unsigned int i = 0; i < neighbour_is_near.size(); ++i)
      if (neighbour_is_near[i])
        now.push_back(curves.neighbours()[i]);
    std::sort(now.begin(), now.end());
    if (now == near_pairs)
      return false;
    near_pairs = std::move(now);
    return true;
  }

  bool StrutProximity::follow(const std::vector<double> &u)
  {
    if (!(thickest > 0))
      return false;
    const bool is_first = looked.empty();
    if (is_first)
      looked = last = std::vector<double>(u.size(), 0.);
    step_travel        = is_first ? 0. : motion(last, u);
    last               = u;
    const double since = motion(looked, u);
    if (!is_first && since < unseen_motion())
      return false;
    travelled += since;
    looked = u;
    if (is_first || travelled >= list_due)
      find_pairs_in_reach(u);
    look_at_pairs(u);
    look_at_neighbours(u);
    return collect_near();
  }

  std::vector<double>
  StrutProximity::by_axis(const std::vector<double> &values) const
  {
    std::vector<double> result;
    if (!values.empty())
      for (const ContactAxis &axis : curves.list())
        for (const int number : axis.unknowns)
          result.push_back(values[number]);
    return result;
  }

  std::vector<double>
  StrutProximity::by_number(const std::vector<double> &values) const
  {
    if (values.empty())
      return {};
    std::vector<double> result(model.numbering.layout().n_global(), 0.);
    std::size_t         next = 0;
    for (const ContactAxis &axis : curves.list())
      for (const int number : axis.unknowns)
        result[number] = values[next++];
    return result;
  }

  void StrutProximity::save(Records &records) const
  {
    std::vector<double> pairs, neighbours, turned;
    for (const Reach &pair : in_reach)
      for (const double value : {double(pair.pair[0]),
                                 double(pair.pair[1]),
                                 pair.due,
                                 double(pair.is_near)})
        pairs.push_back(value);
    for (unsigned int i = 0; i < neighbour_is_near.size(); ++i)
      neighbours.push_back(neighbour_is_near[i]);
    for (const AxisCurve &curve : references)
      for (unsigned int k = 0; k <= curve.degree; ++k)
        for (unsigned int c = 0; c < model.lattice.dimension; ++c)
          turned.push_back(curve.coefficients[k][c]);
    std::vector<double> degrees;
    for (const AxisCurve &curve : references)
      degrees.push_back(curve.degree);
    records.keep(travel_record,
                 {travelled, step_travel, list_due, double(looked.size())});
    keep_list(pairs_record, pairs, records);
    keep_list(neighbours_record, neighbours, records);
    keep_list(references_record, turned, records);
    keep_list(degrees_record, degrees, records);
    keep_list(looked_record, by_axis(looked), records);
    keep_list(last_record, by_axis(last), records);
  }

  void StrutProximity::resume(const Records &records)
  {
    const std::vector<double> travel = records.values(travel_record, 4);
    travelled                        = travel[0];
    step_travel                      = travel[1];
    list_due                         = travel[2];
    const std::vector<double> pairs  = kept_list(pairs_record, records);
    in_reach.clear();
    for (std::size_t i = 0; i + 3 < pairs.size(); i += 4)
      in_reach.push_back({{{static_cast<unsigned int>(pairs[i]),
                            static_cast<unsigned int>(pairs[i + 1])}},
                          pairs[i + 2],
                          pairs[i + 3] != 0});
    const std::vector<double> neighbours =
                                kept_list(neighbours_record, records),
                              degrees = kept_list(degrees_record, records),
                              turned  = kept_list(references_record, records);
    for (unsigned int i = 0; i < neighbour_is_near.size(); ++i)
      neighbour_is_near[i] = neighbours[i] != 0;
    std::size_t next = 0;
    for (unsigned int a = 0; a < references.size(); ++a)
      {
        references[a].degree = degrees[a];
        for (unsigned int k = 0; k <= references[a].degree; ++k)
          for (unsigned int c = 0; c < model.lattice.dimension; ++c)
            references[a].coefficients[k][c] = turned[next++];
      }
    looked = by_number(kept_list(looked_record, records));
    last   = by_number(kept_list(last_record, records));
    near_pairs.clear();
    collect_near();
  }

  bool StrutProximity::comes_too_near(const AxisPair            &pair,
                                      const std::vector<double> &from,
                                      const std::vector<double> &to,
                                      const double               least) const
  {
    constexpr unsigned int         most_looks = 40;
    constexpr double               digits     = 1e-3;
    const std::array<AxisCurve, 2> start      = {{curve(pair[0], from),
                                                  curve(pair[1], from)}},
                                   end        = {
                                            {curve(pair[0], to), curve(pair[1], to)}};
    double largest = 0;
    for (unsigned int i = 0; i < 2; ++i)
      largest += largest_distance(start[i], end[i]);
    double left = gap(pair, end[0], end[1]) - least;
    if (left < 0)
      return true;
    // From the end back to the start, which was accepted: no more of a gap can
    // be lost on a part of the way than there is motion in it.
    double part = 1;
    for (unsigned int look = 0; look < most_looks; ++look)
      {
        part -= left / std::max(largest, left);
        if (part <= digits)
          return false;
        left = gap(pair,
                   between(start[0], end[0], part),
                   between(start[1], end[1], part)) -
          least;
        if (left <= digits * curves.thickness(pair[0], pair[1]))
          return left < 0 || look > most_looks / 2;
      }
    return false;
  }

  std::optional<AxisPair>
  StrutProximity::first_too_near(const std::vector<double> &from,
                                 const std::vector<double> &to,
                                 const double               allowed) const
  {
    // Without a state to start from nothing is known.
    if (!(thickest > 0) || looked.empty())
      return {};
    for (const AxisPair &pair : near_pairs)
      if (comes_too_near(pair,
                         from,
                         to,
                         -allowed * curves.thickness(pair[0], pair[1])))
        return pair;
    const double since = motion(looked, to);
    if (since < unseen_motion())
      return {};
    const auto is_bad = [&](const AxisPair &pair) {
      return !std::binary_search(near_pairs.begin(), near_pairs.end(), pair) &&
        comes_too_near(pair, from, to, 0.);
    };
    if (travelled + since >= list_due + reach / 4)
      {
        for (const AxisPair &pair : pairs_in_boxes(from, to, 0.))
          if (is_bad(pair))
            return pair;
      }
    else
      for (const Reach &pair : in_reach)
        if (travelled + since >= pair.due && is_bad(pair.pair))
          return pair.pair;
    for (const unsigned int i : neighbours_of(turned_axes(to)))
      if (is_bad(curves.neighbours()[i]))
        return curves.neighbours()[i];
    return {};
  }
} // namespace auxfem
