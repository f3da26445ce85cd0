#include <auxfem/connectors/effects/connector_lines.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/schemes/static.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Unknowns and geometry at rest of a pair. */
    ConnectorEnds ends_of(const ConnectorDefinition &definition,
                          const JointPair           &pair,
                          const Lattice             &lattice,
                          const DofNumbering        &numbering)
    {
      using Geometry = ConnectorDefinition::Geometry;
      ConnectorEnds ends;
      ends.first_joint  = pair.first;
      ends.second_joint = pair.second;
      ends.cell         = pair.cell;
      for (unsigned int i = 0; i < 6; ++i)
        {
          const unsigned int joint = i < 3 ? pair.first : pair.second;
          ends.unknowns[i] =
            joint == invalid_index ? -1 : numbering.joint_unknown(joint, i % 3);
        }
      ends.owned       = numbering.layout().is_owned(ends.unknowns[0]);
      ends.span        = pair.second == invalid_index
               ? definition.ground_offset
               : lattice.joints[pair.second] - lattice.joints[pair.first];
      ends.rest_length = ends.span.norm();
      if (ends.rest_length == 0 && definition.geometry == Geometry::line)
        throw InputError(
          definition.path + ": the connector at joint " +
          std::to_string(pair.first) +
          " has length zero, so its direction is undefined. Set `Geometry = "
          "direction` with a `Direction`, or a `Ground offset`.");
      ends.extension_at_rest = definition.extension_at_rest(ends.rest_length);
      ends.direction         = definition.geometry == Geometry::direction
                ? definition.direction
                : ends.span / ends.rest_length;
      return ends;
    }
  } // namespace

  dealii::Tensor<1, 3> ConnectorEnds::difference(const double *values) const
  {
    dealii::Tensor<1, 3> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = (unknowns[3 + c] >= 0 ? values[unknowns[3 + c]] : 0.) -
        (unknowns[c] >= 0 ? values[unknowns[c]] : 0.);
    return result;
  }

  ConnectorLines::ConnectorLines(const ConnectorDefinition    &definition,
                                 const std::vector<JointPair> &pairs,
                                 const Lattice                &lattice,
                                 const DofNumbering           &numbering,
                                 const bool                    large_rotation)
    : follow_ends(definition.geometry == ConnectorDefinition::Geometry::line &&
                  large_rotation)
  {
    for (unsigned int number = 0; number < pairs.size(); ++number)
      {
        ConnectorEnds connector =
          ends_of(definition, pairs[number], lattice, numbering);
        connector.number = number;
        if (std::any_of(connector.unknowns.begin(),
                        connector.unknowns.end(),
                        [&](const int u) {
                          return numbering.layout().is_owned(u);
                        }))
          ends.push_back(connector);
      }
  }

  double ConnectorLines::extension(const ConnectorEnds &ends,
                                   const Vector        &displacement) const
  {
    const dealii::Tensor<1, 3> du = ends.difference(displacement.data());
    if (!follow_ends)
      return ends.extension_at_rest + ends.direction * du;
    // L^2 - L0^2 = du.(2 span + du) avoids the cancellation of L - L0.
    return ends.extension_at_rest +
      du * (2. * ends.span + du) / ((ends.span + du).norm() + ends.rest_length);
  }

  bool ConnectorLines::ends_coincide(const ConnectorEnds &ends,
                                     const double         length) const
  {
    // The direction of a shorter line is round-off.
    return follow_ends && length <= round_off * ends.rest_length;
  }

  std::string
  ConnectorLines::nonfinite_reason(const std::string      &group,
                                   const double            time,
                                   const ConnectorResults &results) const
  {
    for (unsigned int i = 0; i < ends.size(); ++i)
      if (ends_coincide(ends[i], results.current_length[i]))
        {
          const unsigned int second = ends[i].second_joint;
          std::ostringstream text;
          text << "the ends of the connector \"" << group << "\" between joint "
               << ends[i].first_joint << " and "
               << (second == invalid_index ? "the ground"
                                           : "joint " + std::to_string(second))
               << " meet at t = " << time
               << " s, so the direction of its force is undefined";
          return text.str();
        }
    return "";
  }

  ShortestConnector ConnectorLines::shortest(const Evaluation       &step,
                                             const ConnectorResults &results,
                                             const double least) const
  {
    ShortestConnector shortest{least, invalid_index};
    if (!follow_ends)
      return shortest;
    for (unsigned int i = 0; i < ends.size(); ++i)
      {
        if (!ends[i].owned)
          continue;
        // A line that reverses has passed through zero length.
        const double product = ends[i].line(step.from.displacement) *
          ends[i].line(step.to.displacement);
        const double length_ratio =
          product < 0 ? 0. : results.current_length[i] / ends[i].rest_length;
        if (length_ratio < shortest.length_ratio)
          shortest = {length_ratio, ends[i].first_joint};
      }
    return shortest;
  }

  void ConnectorLines::find_motion(const Evaluation &evaluation,
                                   ConnectorResults &results) const
  {
    const State &from = evaluation.from, &to = evaluation.to;
    for (unsigned int i = 0; i < ends.size(); ++i)
      {
        const ConnectorEnds       &connector = ends[i];
        const dealii::Tensor<1, 3> line      = connector.line(to.displacement);
        dealii::Tensor<1, 3>      &direction = results.direction[i];
        double                    &length    = results.current_length[i];
        ConnectorMotion           &motion    = results.motion[i];
        motion.previous_extension = extension(connector, from.displacement);
        motion.extension          = extension(connector, to.displacement);
        motion.dt                 = evaluation.dt;
        length                    = line.norm();
        direction                 = connector.direction;
        if (follow_ends)
          direction = line / length;
        // This direction times the relative motion is exactly the extension in
        // the step, (L1^2 - L0^2) / (L0 + L1).
        if (follow_ends &&
            evaluation.kind == Evaluation::Kind::discrete_gradient)
          {
            const dealii::Tensor<1, 3> before =
              connector.line(from.displacement);
            direction = (before + line) / (before.norm() + length);
          }
        if (ends_coincide(connector, length))
          for (unsigned int c = 0; c < 3; ++c)
            direction[c] = std::numeric_limits<double>::quiet_NaN();
        if (to.velocity)
          results.velocity_difference[i] =
            connector.difference(to.velocity->data());
        motion.rate = rate(i, evaluation, results);
      }
  }

  dealii::Tensor<2, 3>
  ConnectorLines::tangent(const unsigned int      i,
                          const Evaluation       &evaluation,
                          const TangentFactors   &factors,
                          const ConnectorResults &results) const
  {
    const ConnectorResponse &response = results.response[i];
    const auto              &n        = results.direction[i];
    const double             along    = factors.stiffness * response.stiffness +
      factors.damping * response.damping;
    dealii::Tensor<2, 3> by_motion = dealii::outer_product(along * n, n);
    if (!follow_ends)
      return by_motion;
    // The force and the rate change direction as the line rotates.
    const double rotating = factors.stiffness / results.current_length[i];
    by_motion += rotating * response.force * normal_projector(n, n);
    if (evaluation.kind != Evaluation::Kind::static_step)
      by_motion += dealii::outer_product(rotating * response.damping * n,
                                         results.velocity_difference[i] -
                                           results.motion[i].rate * n);
    return by_motion;
  }

  dealii::Tensor<2, 3>
  ConnectorLines::mean_tangent(const unsigned int      i,
                               const Evaluation       &evaluation,
                               const ConnectorResults &results) const
  {
    const ConnectorResponse    &response = results.response[i];
    const dealii::Tensor<1, 3> &e        = results.direction[i];
    if (!follow_ends)
      return dealii::outer_product(response.stiffness * e, e);
    const dealii::Tensor<1, 3> now =
      ends[i].line(evaluation.to.displacement) / results.current_length[i];
    const double length_before =
      ends[i].line(evaluation.from.displacement).norm();
    return dealii::outer_product(response.stiffness * e, now) +
      response.force / (length_before + results.current_length[i]) *
      normal_projector(e, now);
  }

  double ConnectorLines::rate(const unsigned int      i,
                              const Evaluation       &evaluation,
                              const ConnectorResults &results) const
  {
    const ConnectorMotion &motion = results.motion[i];
    const double increment = motion.extension - motion.previous_extension;
    if (evaluation.kind == Evaluation::Kind::discrete_gradient)
      return increment / evaluation.dt;
    if (evaluation.kind != Evaluation::Kind::static_step)
      return results.direction[i] * results.velocity_difference[i];
    // Without inertia, velocities are differences over steps in which the line
    // rotates; differences of the extension exclude the rotation.
    const BackwardDifference difference_in(evaluation.from, evaluation.dt);
    double                   rate = difference_in.now * increment;
    if (const auto &before = evaluation.from.before)
      rate -= difference_in.before *
        (motion.previous_extension - extension(ends[i], before->displacement));
    return rate;
  }

  double ConnectorLines::rate_at(const ConnectorEnds &ends,
                                 const State         &state) const
  {
    const dealii::Tensor<1, 3> line = ends.line(state.displacement);
    return (follow_ends ? line / line.norm() : ends.direction) *
      ends.difference(state.velocity->data());
  }
} // namespace auxfem
