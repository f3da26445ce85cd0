#include <auxfem/joints/effects/relative_angles.h>
#include <auxfem/joints/effects/rotational_springs.h>
#include <auxfem/time/schemes/static.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Second minus first of @p values at two unknowns. */
    double difference(const std::array<int, 2> &rows, const Vector &values)
    {
      return values[rows[1]] - (rows[0] >= 0 ? values[rows[0]] : 0.);
    }

    /** Sets the rate in @p motion where it is a difference of angles.
     * @param turn_before in the step before; only called if there is one */
    template <class TurnBefore>
    bool set_difference_rate(const Evaluation &evaluation,
                             const TurnBefore &turn_before,
                             ConnectorMotion  &motion)
    {
      const double turn = motion.extension - motion.previous_extension;
      if (evaluation.kind == Evaluation::Kind::discrete_gradient)
        motion.rate = turn / evaluation.dt;
      else if (evaluation.kind == Evaluation::Kind::static_step)
        {
          const BackwardDifference backward(evaluation.from, evaluation.dt);
          motion.rate = backward.now * turn;
          if (evaluation.from.before)
            motion.rate -= backward.before * turn_before();
        }
      else
        return false;
      return true;
    }
  } // namespace

  ConnectorMotion PlaneAngles::motion(const unsigned int i,
                                      const Evaluation  &evaluation) const
  {
    const Rows     &rows = all_rows[i];
    const State    &from = evaluation.from, &to = evaluation.to;
    ConnectorMotion motion{difference(rows, to.displacement),
                           0,
                           difference(rows, from.displacement),
                           evaluation.dt};
    const auto      turn_before = [&] {
      return motion.previous_extension -
        difference(rows, from.before->displacement);
    };
    if (!set_difference_rate(evaluation, turn_before, motion) && to.velocity)
      motion.rate = rate(i, to);
    return motion;
  }

  double PlaneAngles::rate(const unsigned int i, const State &state) const
  {
    return difference(all_rows[i], *state.velocity);
  }

  PlaneAngles::Directions
  PlaneAngles::directions(const unsigned int i,
                          const Evaluation  &evaluation) const
  {
    const double factor = evaluation.kind == Evaluation::Kind::discrete_gradient
      ? mean_moment_factor(all_rows[i], evaluation)
      : 1;
    return {{-factor, factor}};
  }

  PlaneAngles::Directions
  PlaneAngles::derivatives(const unsigned int /*i*/,
                           const Evaluation & /*evaluation*/) const
  {
    return {{-1, 1}};
  }

  AxisAngles::AxisAngles(const DofNumbering          &numbering,
                         const bool                   large_rotation,
                         const std::string           &name,
                         const std::vector<AxisPair> &definitions)
    : numbering(numbering)
    , rotations(numbering)
    , is_large(large_rotation)
    , name(name)
  {
    for (const AxisPair &definition : definitions)
      {
        Rows rows;
        std::copy_n(definition.base.begin(), 3, rows.begin());
        std::copy_n(definition.end.begin(), 3, rows.begin() + 3);
        all_rows.push_back(rows);
        const SpaceTensor frame =
          section_frame(definition.axis, default_reference(definition.axis));
        Pair pair{definition.axis, {}, definition.number};
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int k = 0; k < 2; ++k)
            pair.across[k][c] = frame[c][1 + k];
        pairs.push_back(pair);
      }
  }

  void AxisAngles::register_in(StateLayout &layout)
  {
    std::vector<unsigned int> numbers;
    for (const Pair &pair : pairs)
      numbers.push_back(pair.number);
    first_angle = layout.history.keep("angles of " + name, numbers, 2);
  }

  Quaternion AxisAngles::rotation(const unsigned int i,
                                  const unsigned int side,
                                  const State       &state) const
  {
    const int spin = all_rows[i][3 * side];
    return is_large && spin >= 0
      ? state.rotations[numbering.rotations().with(spin)]
      : Quaternion();
  }

  AxisAngles::Arms AxisAngles::arms(const unsigned int i,
                                    const State       &state) const
  {
    const Quaternion base = rotation(i, 0, state);
    return {rotated(rotation(i, 1, state), pairs[i].across[0]),
            {rotated(base, pairs[i].across[0]),
             rotated(base, pairs[i].across[1])}};
  }

  SpaceVector AxisAngles::axis(const unsigned int i, const State &state) const
  {
    return rotated(rotation(i, 0, state), pairs[i].axis);
  }

  double AxisAngles::angle(const unsigned int i,
                           const State       &state,
                           const double       nearest) const
  {
    using dealii::numbers::PI;
    const Rows &rows = all_rows[i];
    if (!is_large)
      {
        const double *u = state.displacement.data();
        return pairs[i].axis *
          (vector_at(u, &rows[3]) -
           (rows[0] < 0 ? SpaceVector() : vector_at(u, &rows[0])));
      }
    const Arms   now = arms(i, state);
    const double angle =
      std::atan2(now.base[1] * now.end, now.base[0] * now.end);
    return angle + 2 * PI * std::round((nearest - angle) / (2 * PI));
  }

  ConnectorMotion AxisAngles::motion(const unsigned int i,
                                     const Evaluation  &evaluation) const
  {
    const double   *before = &evaluation.from.history[first_angle + 2 * i];
    ConnectorMotion motion{angle(i, evaluation.to, before[0]),
                           0,
                           before[0],
                           evaluation.dt};
    const double    turn_before = before[1];
    if (!set_difference_rate(
          evaluation,
          [turn_before] { return turn_before; },
          motion) &&
        evaluation.to.velocity)
      motion.rate = rate(i, evaluation.to);
    double *now = &evaluation.to.history[first_angle + 2 * i];
    now[1]      = motion.extension - motion.previous_extension;
    now[0]      = motion.extension;
    return motion;
  }

  double AxisAngles::rate(const unsigned int i, const State &state) const
  {
    const Directions derivatives = directions(axis(i, state));
    double           rate        = 0;
    for (unsigned int r = 0; r < n_rows; ++r)
      if (all_rows[i][r] >= 0)
        rate += derivatives[r] * rotations.spatial_rate(state, all_rows[i][r]);
    return rate;
  }

  AxisAngles::Directions AxisAngles::directions(const SpaceVector &axis)
  {
    return {{-axis[0], -axis[1], -axis[2], axis[0], axis[1], axis[2]}};
  }

  AxisAngles::Directions
  AxisAngles::directions(const unsigned int i,
                         const Evaluation  &evaluation) const
  {
    if (!is_large || evaluation.kind != Evaluation::Kind::discrete_gradient)
      return directions(axis(i, evaluation.to));
    const Arms start = arms(i, evaluation.from), stop = arms(i, evaluation.to);
    const SpaceVector end = (start.end + stop.end) / 2;
    double            components[2];
    SpaceVector       normals[2];
    for (unsigned int k = 0; k < 2; ++k)
      {
        components[k] =
          (start.base[k] * start.end + stop.base[k] * stop.end) / 2;
        normals[k] =
          dealii::cross_product_3d(end, (start.base[k] + stop.base[k]) / 2);
      }
    const double *before = &evaluation.from.history[first_angle + 2 * i];
    const double  turn   = angle(i, evaluation.to, before[0]) - before[0];
    return directions(
      (components[0] * normals[1] - components[1] * normals[0]) / sinc(turn));
  }

  AxisAngles::Directions
  AxisAngles::derivatives(const unsigned int i,
                          const Evaluation  &evaluation) const
  {
    return directions(axis(i, evaluation.to));
  }

  void AxisAngles::add_turning(const unsigned int i,
                               const Evaluation  &evaluation,
                               const double       moment,
                               double (&block)[n_rows * n_rows]) const
  {
    if (!is_large || all_rows[i][0] < 0)
      return;
    // The axis turns with the base: theta_1 x P_1 a.
    const SpaceTensor turning =
      (evaluation.kind == Evaluation::Kind::discrete_gradient ? -moment / 2
                                                              : -moment) *
      cross_product_tensor(axis(i, evaluation.to));
    for (unsigned int r = 0; r < n_rows; ++r)
      for (unsigned int c = 0; c < 3; ++c)
        block[n_rows * r + c] += (r < 3 ? -1 : 1) * turning[r % 3][c];
  }
} // namespace auxfem
