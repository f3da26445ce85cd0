#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/contact/effects/strut_proximity.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>

// Pairs of axes with a common node, which approach each other by rotation.

namespace auxfem
{
  double StrutProximity::axis_rotation(const unsigned int         axis,
                                       const std::vector<double> &u) const
  {
    const std::vector<int> &unknowns = curves.list()[axis].unknowns;
    const double *const     before =
      reference_displacements.data() + first_of_axis[axis];
    std::array<double, 3 * (AxisCurve::max_degree + 1)> motion;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      motion[i] = u[unknowns[i]] - before[i];
    return curves.axis_rotation(axis, motion.data());
  }

  double StrutProximity::compute_allowed_rotation(const unsigned int axis) const
  {
    // Near pairs are checked anyway, so a larger rotation is allowed.
    constexpr double least_of_near = 0.01;
    double           least         = dealii::numbers::PI;
    for (const unsigned int i : connected_of_axis[axis])
      {
        const bool   is_first = curves.connected()[i][0] == axis;
        const double margin   = connected[i].rotation_margin[is_first ? 0 : 1];
        least                 = std::min(least,
                         connected[i].is_near ? std::max(margin, least_of_near)
                                                              : margin);
      }
    return least;
  }

  void StrutProximity::invalidate_rotations()
  {
    // A zero allowance makes every axis due.
    allowed_rotation.assign(allowed_rotation.size(), 0.);
    for (const AxisPair &pair : curves.connected())
      for (const unsigned int axis : pair)
        rotation_due[axis] = 0;
  }

  void StrutProximity::store_reference(const unsigned int         axis,
                                       const std::vector<double> &u)
  {
    const std::vector<int> &unknowns = curves.list()[axis].unknowns;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      reference_displacements[first_of_axis[axis] + i] = u[unknowns[i]];
  }

  double StrutProximity::earliest_rotation_check(const unsigned int axis,
                                                 const double turned) const
  {
    return total_motion +
      (allowed_rotation[axis] - turned) / curves.largest_axis_rotation(axis, 1);
  }

  std::vector<unsigned int>
  StrutProximity::find_rotated_axes(const std::vector<double> &u)
  {
    std::vector<unsigned int> turned;
    for (unsigned int a = 0; a < rotation_due.size(); ++a)
      if (total_motion >= rotation_due[a])
        {
          const double axis_rotation = this->axis_rotation(a, u);
          if (axis_rotation >= allowed_rotation[a])
            turned.push_back(a);
          else
            rotation_due[a] = earliest_rotation_check(a, axis_rotation);
        }
    return turned;
  }

  std::vector<unsigned int> StrutProximity::pairs_connected_to(
    const std::vector<unsigned int> &turned) const
  {
    std::vector<unsigned int> pairs;
    for (const unsigned int axis : turned)
      {
        const auto axis_pairs = connected_of_axis[axis];
        pairs.insert(pairs.end(), axis_pairs.begin(), axis_pairs.end());
      }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  StrutProximity::ConnectedPair
  StrutProximity::check_connected_pairs(const AxisPair            &pair,
                                        const std::vector<double> &u) const
  {
    const AxisCurve one = curve(pair[0], u), other = curve(pair[1], u);
    const double    margin =
      gap_of.rotation_margin(pair, one, other, near_gap_fraction);
    const bool are_apart = curves.are_neighbours(pair[0], pair[1]) &&
      gap_of.are_lines_at_rest(pair, one, other);
    ConnectedPair now;
    for (unsigned int k = 0; k < 2; ++k)
      now.rotation_margin[k] = margin - axis_rotation(pair[k], u);
    now.is_near = margin < small_rotation && !are_apart &&
      is_approaching(pair, gap_of(pair, one, other), u, near_gap(pair));
    return now;
  }

  void
  StrutProximity::check_connected_pairs(const std::vector<unsigned int> &pairs,
                                        const std::vector<double>       &u)
  {
    const auto checks = shared_results(
      pairs.size(),
      model.numbering.layout(),
      [&](const std::size_t k) {
        return check_connected_pairs(curves.connected()[pairs[k]], u);
      });
    for (std::size_t k = 0; k < pairs.size(); ++k)
      connected[pairs[k]] = checks[k];
  }

  void StrutProximity::check_connected_pairs(const std::vector<double> &u)
  {
    const std::vector<unsigned int> turned = find_rotated_axes(u),
                                    pairs  = pairs_connected_to(turned);
    for (const unsigned int axis : turned)
      store_reference(axis, u);
    check_connected_pairs(pairs, u);
    for (const unsigned int i : pairs)
      for (const unsigned int axis : curves.connected()[i])
        {
          allowed_rotation[axis] = compute_allowed_rotation(axis);
          rotation_due[axis]     = total_motion;
        }
    for (const unsigned int axis : turned)
      rotation_due[axis] = earliest_rotation_check(axis, 0);
  }
} // namespace auxfem
