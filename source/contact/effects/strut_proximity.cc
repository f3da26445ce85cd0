#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/strut_proximity.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Number of checks within which an approaching pair would touch to count
     * as near.
     * @tuned judgement */
    constexpr double n_lookahead_checks = 4;

    /** Largest motion of a point of an axis over that of its nodes. */
    constexpr double motion_safety_factor = 2;
  } // namespace

  StrutProximity::StrutProximity(const LatticeModel &model,
                                 const StrutCurves  &curves)
    : model(model)
    , curves(curves)
    , gap_of(curves)
    , search_distance(model.mean_strut_length / 4)
    , connected_of_axis(curves.list().size(),
                        [&curves](const auto &add) {
                          const std::vector<AxisPair> &pairs =
                            curves.connected();
                          for (unsigned int i = 0; i < pairs.size(); ++i)
                            for (const unsigned int axis : pairs[i])
                              add(axis, i);
                        })
    , connected(curves.connected().size())
    , allowed_rotation(curves.list().size(), 0.)
    , rotation_due(curves.list().size(),
                   std::numeric_limits<double>::infinity())
  {
    thinnest             = std::numeric_limits<double>::infinity();
    std::size_t n_values = 0;
    for (const ContactAxis &axis : curves.list())
      {
        thickest = std::max(thickest, axis.half_thickness);
        if (axis.half_thickness > 0)
          thinnest = std::min(thinnest, axis.half_thickness);
        first_of_axis.push_back(n_values);
        n_values += axis.unknowns.size();
      }
    reference_displacements.assign(n_values, 0.);
    find_nodes();
    invalidate_rotations();
    find_near_at_rest();
  }

  void StrutProximity::find_near_at_rest()
  {
    std::vector<dealii::BoundingBox<3>> boxes;
    boxes.reserve(curves.list().size());
    for (unsigned int a = 0; a < curves.list().size(); ++a)
      boxes.push_back(
        box_around(curves.at_rest(a),
                   curves.list()[a].half_thickness + search_distance / 2));
    std::vector<AxisPair> pairs = pairs_in(boxes);
    overlaps_at_rest = find_overlaps(curves, pairs, model.numbering.layout());
    for (const StrutOverlap &overlap : overlaps_at_rest)
      if (overlap.is_passing)
        passing.insert(overlap.lines);
    pairs.erase(std::remove_if(pairs.begin(),
                               pairs.end(),
                               [this](const AxisPair &pair) {
                                 return never_touch(pair);
                               }),
                pairs.end());
    set_candidate_pairs(pairs);
  }

  void StrutProximity::find_nodes()
  {
    const unsigned int dimension = model.lattice.dimension;
    std::vector<bool>  is_known(model.numbering.layout().n_global(), false);
    for (const ContactAxis &axis : curves.list())
      for (unsigned int i = 0; i < axis.n_nodes(); ++i)
        {
          const auto         first = axis.unknowns.begin() + i * dimension;
          std::array<int, 3> node{};
          std::copy_n(first, dimension, node.begin());
          if (i > axis.order)
            {
              const unsigned int d = i - axis.order - 1;
              mean_axes.resize(dimension);
              mean_axes[d].node = node;
              mean_axes[d].factor =
                std::max(mean_axes[d].factor, std::abs(axis.axis_factors[d]));
            }
          else if (!is_known[*first])
            {
              is_known[*first] = true;
              nodes.push_back(node);
            }
        }
    nodes.shrink_to_fit();
  }

  double StrutProximity::relative_motion(const AxisPair            &pair,
                                         const std::vector<double> &from,
                                         const std::vector<double> &to) const
  {
    const unsigned int    dimension = model.lattice.dimension;
    std::array<double, 3> least, most;
    least.fill(std::numeric_limits<double>::infinity());
    most.fill(-least[0]);
    for (const unsigned int a : pair)
      {
        const ContactAxis &axis = curves.list()[a];
        const auto way_of = [&](const unsigned int node, const unsigned int c) {
          const int unknown = axis.unknowns[node * dimension + c];
          return to[unknown] - from[unknown];
        };
        for (unsigned int c = 0; c < dimension; ++c)
          {
            double as_whole = 0;
            for (unsigned int d = 0; d < axis.axis_factors.size(); ++d)
              as_whole += axis.axis_factors[d] * way_of(axis.order + 1 + d, c);
            for (unsigned int node = 0; node <= axis.order; ++node)
              {
                const double way = way_of(node, c) + as_whole;
                least[c]         = std::min(least[c], way);
                most[c]          = std::max(most[c], way);
              }
          }
      }
    double square = 0;
    for (unsigned int c = 0; c < dimension; ++c)
      square += std::pow(most[c] - least[c], 2);
    return std::sqrt(square);
  }

  double StrutProximity::near_gap(const AxisPair &pair) const
  {
    return near_gap_fraction * curves.thickness(pair[0], pair[1]);
  }

  bool StrutProximity::is_approaching(const AxisPair            &pair,
                                      const double               gap,
                                      const std::vector<double> &u,
                                      const double               least) const
  {
    // Nodal motion excludes most pairs without computing a second gap.
    if (gap <= least)
      return true;
    return gap <= least +
        n_lookahead_checks * relative_motion(pair, checked_displacements, u) &&
      gap <= least +
        n_lookahead_checks * (this->gap(pair, checked_displacements) - gap);
  }

  template <unsigned int dimension>
  double StrutProximity::largest_motion(const std::vector<double> &from,
                                        const std::vector<double> &to) const
  {
    const auto square_of_way = [&](const std::array<int, 3> &node) {
      double square = 0;
      for (unsigned int c = 0; c < dimension; ++c)
        square += (to[node[c]] - from[node[c]]) * (to[node[c]] - from[node[c]]);
      return square;
    };
    double largest = 0;
    for (const std::array<int, 3> &node : nodes)
      largest = std::max(largest, square_of_way(node));
    double way = std::sqrt(largest);
    for (const MeanAxis &axis : mean_axes)
      way += axis.factor * std::sqrt(square_of_way(axis.node));
    return way;
  }

  double StrutProximity::motion(const std::vector<double> &from,
                                const std::vector<double> &to) const
  {
    return model.lattice.dimension == 2 ? largest_motion<2>(from, to)
                                        : largest_motion<3>(from, to);
  }

  double StrutProximity::motion(const unsigned int         axis,
                                const std::vector<double> &from,
                                const std::vector<double> &to) const
  {
    // A copy rotates as its original.
    const ContactAxis &contact_axis = curves.list()[axis];
    const std::size_t  n_values =
      (contact_axis.order + 1) * std::size_t(model.lattice.dimension);
    double square = 0;
    for (std::size_t i = 0; i < n_values; ++i)
      {
        const int number = contact_axis.unknowns[i];
        square += (to[number] - from[number]) * (to[number] - from[number]);
      }
    return std::sqrt(square);
  }

  std::vector<AxisPair>
  StrutProximity::pairs_in_boxes(const std::vector<double> &from,
                                 const std::vector<double> &to,
                                 const double               margin) const
  {
    std::vector<dealii::BoundingBox<3>> boxes;
    boxes.reserve(curves.list().size());
    for (unsigned int a = 0; a < curves.list().size(); ++a)
      {
        const double around = curves.list()[a].half_thickness + margin;
        boxes.push_back(box_around(curve(a, to), around));
        if (&from != &to)
          boxes.back().merge_with(box_around(curve(a, from), around));
      }
    return pairs_in(boxes);
  }

  std::vector<AxisPair> StrutProximity::pairs_in(
    const std::vector<dealii::BoundingBox<3>> &boxes) const
  {
    const UnknownLayout      &layout = model.numbering.layout();
    std::vector<unsigned int> axes;
    for (const AxisPair &pair :
         pairs_that_meet(boxes, share_of_rank(layout, boxes.size())))
      if (curves.common_nodes(pair[0], pair[1]).empty() && !never_touch(pair))
        axes.insert(axes.end(), pair.begin(), pair.end());
    axes = gather_over_ranks(axes, layout.communicator());
    std::vector<AxisPair> pairs;
    for (std::size_t i = 0; i < axes.size(); i += 2)
      pairs.push_back({{axes[i], axes[i + 1]}});
    return pairs;
  }

  bool StrutProximity::never_touch(const AxisPair &pair) const
  {
    const auto lines =
      std::minmax(curves.list()[pair[0]].line, curves.list()[pair[1]].line);
    return curves.never_touch(pair[0], pair[1]) ||
      passing.count({{lines.first, lines.second}}) > 0;
  }

  void StrutProximity::set_candidate_pairs(const std::vector<AxisPair> &pairs)
  {
    candidate_pairs.clear();
    for (const AxisPair &pair : pairs)
      candidate_pairs.push_back({pair, 0., false});
    // Other pairs are farther apart than the search distance and approach by
    // twice the nodal motion; a quarter remains for one step.
    list_update_due = total_motion + 3 * search_distance / 8;
  }

  void StrutProximity::check_candidate_pairs(const std::vector<double> &u)
  {
    struct PairCheck
    {
      double due;
      bool   is_near;
    };
    std::vector<unsigned int> due_pairs;
    for (unsigned int i = 0; i < candidate_pairs.size(); ++i)
      if (total_motion >= candidate_pairs[i].due || candidate_pairs[i].is_near)
        due_pairs.push_back(i);
    const auto checks = shared_results(
      due_pairs.size(),
      model.numbering.layout(),
      [&](const std::size_t k) {
        const AxisPair &pair = candidate_pairs[due_pairs[k]].pair;
        const double    gap = this->gap(pair, u), least = near_gap(pair);
        return PairCheck{total_motion + std::max(gap - least, 0.) / 2,
                         is_approaching(pair, gap, u, least)};
      });
    for (std::size_t k = 0; k < checks.size(); ++k)
      {
        candidate_pairs[due_pairs[k]].due     = checks[k].due;
        candidate_pairs[due_pairs[k]].is_near = checks[k].is_near;
      }
  }

  double StrutProximity::unchecked_motion() const
  {
    // Pairs that are not near may lose nine tenths of their gap.
    return 0.9 * near_gap_fraction * thinnest / 2;
  }

  bool StrutProximity::collect_near(const std::vector<double> &u)
  {
    std::vector<AxisPair> now;
    for (const CandidatePair &pair : candidate_pairs)
      if (pair.is_near)
        now.push_back(pair.pair);
    for (unsigned int i = 0; i < connected.size(); ++i)
      if (const AxisPair &pair = curves.connected()[i];
          connected[i].is_near && !never_touch(pair))
        now.push_back(pair);
    std::sort(now.begin(), now.end());
    near_gaps.clear();
    for (const AxisPair &pair : now)
      near_gaps.push_back(gap(pair, u));
    if (now == near_pairs)
      return false;
    near_pairs = std::move(now);
    return true;
  }

  bool StrutProximity::any_rank_has_contact_candidates(
    const std::vector<double> &u) const
  {
    for (std::size_t i = 0; i < near_pairs.size(); ++i)
      if (is_approaching(near_pairs[i],
                         near_gaps[i],
                         u,
                         2 * unchecked_motion()))
        return true;
    return false;
  }

  double StrutProximity::largest_motion_to(const std::vector<double> &u) const
  {
    if (!(thickest > 0))
      return 0;
    // Before the first check the reference is the state at rest.
    return checked_displacements.empty()
      ? motion(std::vector<double>(u.size(), 0.), u)
      : motion(checked_displacements, u);
  }

  bool StrutProximity::follow(const std::vector<double> &u, const double way)
  {
    if (!(thickest > 0))
      return false;
    const bool is_first = checked_displacements.empty();
    if (is_first)
      checked_displacements = std::vector<double>(u.size(), 0.);
    else if (way < unchecked_motion())
      return false;
    total_motion += way;
    if (total_motion >= list_update_due)
      set_candidate_pairs(pairs_in_boxes(u, u, search_distance / 2));
    return update_near_pairs(u);
  }

  bool StrutProximity::update_near_pairs(const std::vector<double> &u)
  {
    check_candidate_pairs(u);
    check_connected_pairs(u);
    const bool has_changed = collect_near(u);
    is_contact_imminent    = any_rank_has_contact_candidates(u);
    checked_displacements  = u;
    return has_changed;
  }

  bool StrutProximity::restart(const std::vector<double> &u)
  {
    if (!(thickest > 0))
      return false;
    total_motion          = 0;
    checked_displacements = u;
    connected.assign(connected.size(), {});
    invalidate_rotations();
    set_candidate_pairs(pairs_in_boxes(u, u, search_distance / 2));
    return update_near_pairs(u);
  }

  bool StrutProximity::gap_falls_below(const AxisPair            &pair,
                                       const std::vector<double> &from,
                                       const std::vector<double> &to,
                                       const double               least) const
  {
    return gap_of.falls_below(pair,
                              {{curve(pair[0], from), curve(pair[1], from)}},
                              {{curve(pair[0], to), curve(pair[1], to)}},
                              least);
  }

  std::optional<AxisPair>
  StrutProximity::first_excessive_approach(const std::vector<double> &from,
                                           const std::vector<double> &to,
                                           const double               allowed,
                                           const double               way) const
  {
    // Nothing is known before the first check.
    if (!(thickest > 0) || checked_displacements.empty())
      return {};
    for (std::size_t i = 0; i < near_pairs.size(); ++i)
      {
        const AxisPair &pair  = near_pairs[i];
        const double    least = -allowed * curves.thickness(pair[0], pair[1]);
        // A distance changes by at most the relative motion of nodes.
        if (near_gaps[i] - least < motion_safety_factor *
                std::max(relative_motion(pair, checked_displacements, from),
                         relative_motion(pair, checked_displacements, to)) &&
            gap_falls_below(pair, from, to, least))
          return pair;
      }
    if (way < unchecked_motion())
      return {};
    const auto is_bad = [&](const AxisPair &pair) {
      return !never_touch(pair) &&
        !std::binary_search(near_pairs.begin(), near_pairs.end(), pair) &&
        gap_falls_below(pair, from, to, 0.);
    };
    if (total_motion + way >= list_update_due + search_distance / 8)
      {
        for (const AxisPair &pair : pairs_in_boxes(from, to, 0.))
          if (is_bad(pair))
            return pair;
      }
    else
      for (const CandidatePair &pair : candidate_pairs)
        if (total_motion + way >= pair.due && is_bad(pair.pair))
          return pair.pair;
    for (unsigned int axis = 0; axis < rotation_due.size(); ++axis)
      if (total_motion + way >= rotation_due[axis] &&
          motion(axis, checked_displacements, to) >= unchecked_motion() &&
          axis_rotation(axis, to) >= allowed_rotation[axis])
        for (const unsigned int i : connected_of_axis[axis])
          if (is_bad(curves.connected()[i]))
            return curves.connected()[i];
    return {};
  }

  std::optional<std::array<unsigned int, 2>>
  FirstContactDetector::find(const State &from, const State &to)
  {
    const UnknownLayout &layout = model.numbering.layout();
    if (!is_following)
      proximity.follow(by_global_number(from.displacement, layout, gathered));
    is_following = true;
    const std::vector<double> &end =
      by_global_number(to.displacement, layout, gathered);
    const double way = proximity.largest_motion_to(end);
    const auto   found =
      proximity.first_excessive_approach(proximity.last_checked_displacements(),
                                         end,
                                         /*allowed=*/0,
                                         way);
    proximity.follow(end, way);
    if (!found)
      return {};
    const std::vector<ContactAxis> &axes = curves.list();
    return {{{axes[(*found)[0]].strut, axes[(*found)[1]].strut}}};
  }
} // namespace auxfem
