#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/strut_proximity.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>

// Pairs of struts with a common node: they come near each other by turning.

namespace auxfem
{
  double StrutProximity::turning(const unsigned int         axis,
                                 const std::vector<double> &u) const
  {
    const std::vector<int> &unknowns = curves.list()[axis].unknowns;
    const double *const     before   = turned_at.data() + first_of_axis[axis];
    std::array<double, 3 * (AxisCurve::max_degree + 1)> motion;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      motion[i] = u[unknowns[i]] - before[i];
    return curves.turning(axis, motion.data());
  }

  double StrutProximity::turning_allowed(const unsigned int axis) const
  {
    // Pairs that are near need not be looked at to know when they touch.
    constexpr double least_of_near = 0.01;
    double           least         = dealii::numbers::PI;
    for (const unsigned int i : connected_of_axis[axis])
      {
        const bool   is_first = curves.connected()[i][0] == axis;
        const double of_pair  = connected[i].turning_left[is_first ? 0 : 1];
        least                 = std::min(least,
                         connected[i].is_near ? std::max(of_pair, least_of_near)
                                                              : of_pair);
      }
    return least;
  }

  void StrutProximity::forget_turning()
  {
    // So little that every axis has turned by it.
    allowed_turning.assign(allowed_turning.size(), 0.);
    for (const AxisPair &pair : curves.connected())
      for (const unsigned int axis : pair)
        turning_due[axis] = 0;
  }

  void StrutProximity::remember_turning(const unsigned int         axis,
                                        const std::vector<double> &u)
  {
    const std::vector<int> &unknowns = curves.list()[axis].unknowns;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      turned_at[first_of_axis[axis] + i] = u[unknowns[i]];
  }

  double StrutProximity::earliest_turn(const unsigned int axis,
                                       const double       turned) const
  {
    return travelled +
      (allowed_turning[axis] - turned) / curves.largest_turning(axis, 1);
  }

  std::vector<unsigned int>
  StrutProximity::find_turned(const std::vector<double> &u)
  {
    std::vector<unsigned int> turned;
    for (unsigned int a = 0; a < turning_due.size(); ++a)
      if (travelled >= turning_due[a])
        {
          const double turning = this->turning(a, u);
          if (turning >= allowed_turning[a])
            turned.push_back(a);
          else
            turning_due[a] = earliest_turn(a, turning);
        }
    return turned;
  }

  std::vector<unsigned int>
  StrutProximity::connected_to(const std::vector<unsigned int> &turned) const
  {
    std::vector<unsigned int> pairs;
    for (const unsigned int axis : turned)
      {
        const auto of_axis = connected_of_axis[axis];
        pairs.insert(pairs.end(), of_axis.begin(), of_axis.end());
      }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  StrutProximity::Connected
  StrutProximity::look_at_connected(const AxisPair            &pair,
                                    const std::vector<double> &u) const
  {
    const AxisCurve one = curve(pair[0], u), other = curve(pair[1], u);
    const double    left = gap_of.turning_left(pair, one, other, near_part);
    const bool      are_apart = curves.are_neighbours(pair[0], pair[1]) &&
      gap_of.are_lines_at_rest(pair, one, other);
    Connected now;
    for (unsigned int k = 0; k < 2; ++k)
      now.turning_left[k] = left - turning(pair[k], u);
    now.is_near = left < small_rotation && !are_apart &&
      comes_near(pair, gap_of(pair, one, other), u, near_gap(pair));
    return now;
  }

  void StrutProximity::look_at_connected(const std::vector<unsigned int> &pairs,
                                         const std::vector<double>       &u)
  {
    const auto looks =
      shared_results(pairs.size(),
                     model.numbering.layout(),
                     [&](const std::size_t k) {
                       return look_at_connected(curves.connected()[pairs[k]],
                                                u);
                     });
    for (std::size_t k = 0; k < pairs.size(); ++k)
      connected[pairs[k]] = looks[k];
  }

  void StrutProximity::look_at_connected(const std::vector<double> &u)
  {
    const std::vector<unsigned int> turned = find_turned(u),
                                    pairs  = connected_to(turned);
    for (const unsigned int axis : turned)
      remember_turning(axis, u);
    look_at_connected(pairs, u);
    for (const unsigned int i : pairs)
      for (const unsigned int axis : curves.connected()[i])
        {
          allowed_turning[axis] = turning_allowed(axis);
          turning_due[axis]     = travelled;
        }
    for (const unsigned int axis : turned)
      turning_due[axis] = earliest_turn(axis, 0);
  }
} // namespace auxfem
