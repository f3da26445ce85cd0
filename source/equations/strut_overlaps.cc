#include <auxfem/algebra/shared_work.h>
#include <auxfem/equations/strut_gap.h>
#include <auxfem/equations/strut_overlaps.h>

#include <deal.II/numerics/rtree.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace auxfem
{
  namespace
  {
    /** Those of a part and behind it that meet the box around the part. */
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
    // Around lines along the curve, which it is away from by so much about.
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
    // By more than this, of half the sum of the thicknesses, they pass.
    constexpr double passing = 0.5, digits = 0.01;

    // Over the thickness.
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
          const auto [one, other] =
            std::minmax(curves.list()[near[i][0]].strut,
                        curves.list()[near[i][1]].strut);
          double &known =
            least.try_emplace({{one, other}}, distances[i]).first->second;
          known = std::min(known, distances[i]);
        }
    std::vector<StrutOverlap> overlaps;
    for (const auto &[pair, part] : least)
      overlaps.push_back({pair, part < passing});
    return overlaps;
  }
} // namespace auxfem
