#include <auxfem/parameters/errors.h>
#include <auxfem/system/effects/connector_forces.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  ConnectorForces::ConnectorForces(const ConnectorDefinition    &definition,
                                   const std::vector<JointPair> &pairs,
                                   const Lattice                &lattice,
                                   const DofNumbering           &numbering,
                                   const bool                    large_rotation,
                                   StateLayout                  &layout)
    : group_name(definition.name)
    , law(definition.law)
    , follows_line(definition.geometry == ConnectorDefinition::Geometry::line &&
                   large_rotation)
    , ground_offset(definition.ground_offset)
    , lattice(lattice)
    , first_history(layout.n_history)
    , first_dissipated(layout.n_dissipated)
  {
    for (const JointPair &pair : pairs)
      {
        Ends ends;
        ends.first_joint  = pair.first;
        ends.second_joint = pair.second;
        ends.cell         = pair.cell;
        bool is_touched   = false;
        for (unsigned int i = 0; i < 6; ++i)
          {
            const unsigned int joint = i < 3 ? pair.first : pair.second;
            ends.unknowns[i]         = joint == invalid_index
                      ? -1
                      : numbering.joint_unknown(joint, i % 3);
            is_touched = is_touched || numbering.is_owned(ends.unknowns[i]);
          }
        ends.counted     = numbering.is_owned(ends.unknowns[0]);
        ends.span        = pair.second == invalid_index
                 ? ground_offset
                 : lattice.joints[pair.second] - lattice.joints[pair.first];
        ends.rest_length = ends.span.norm();
        if (ends.rest_length == 0 &&
            definition.geometry == ConnectorDefinition::Geometry::line)
          throw InputError(
            definition.path + ": the connector at joint " +
            std::to_string(pair.first) +
            " has length zero, so no line leads along it. Give `Geometry = "
            "direction` with a `Direction`, or a `Ground offset`.");
        if (!is_touched)
          continue;
        if (ends.counted)
          counted.push_back(connectors.size());
        connectors.push_back(ends);
        direction.push_back(definition.geometry ==
                                ConnectorDefinition::Geometry::direction
                              ? definition.direction
                              : ends.span / ends.rest_length);
      }
    const unsigned int n = connectors.size();
    motion.resize(n);
    response.resize(n);
    velocity_difference.resize(n);
    current_length.resize(n);
    stored.resize(n, 0.);
    layout.n_history += n * law->n_history();
    if (law->is_viscous())
      {
        layout.n_dissipated += n;
        layout.velocity = true;
      }
  }

  bool ConnectorForces::is_linear() const
  {
    return !follows_line;
  }

  void ConnectorForces::register_blocks(TangentMatrix &matrix)
  {
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const std::size_t block =
          matrix.register_block(connectors[i].unknowns.data(), 6);
        if (i == 0)
          first_block = block;
      }
  }

  bool ConnectorForces::differences_extension(const State &state,
                                              const double dt)
  {
    return !state.acceleration && dt > 0;
  }

  void ConnectorForces::evaluate_motion(const State &state, const double dt)
  {
    const double *u = state.displacement.Values();
    const double *v = state.velocity ? state.velocity->Values() : nullptr;
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const Ends &ends       = connectors[i];
        const auto  difference = [&ends](const double *x) {
          dealii::Tensor<1, 3> result;
          for (unsigned int c = 0; c < 3; ++c)
            result[c] =
              (ends.unknowns[3 + c] >= 0 ? x[ends.unknowns[3 + c]] : 0.) -
              (ends.unknowns[c] >= 0 ? x[ends.unknowns[c]] : 0.);
          return result;
        };
        const dealii::Tensor<1, 3> du = difference(u);
        if (follows_line)
          {
            const dealii::Tensor<1, 3> line = ends.span + du;
            current_length[i]               = line.norm();
            direction[i]                    = line / current_length[i];
            // L^2 - L0^2 = du.(2 span + du): no difference of nearly equal
            // lengths.
            motion[i].extension = du * (2. * ends.span + du) /
              (current_length[i] + ends.rest_length);
          }
        else
          motion[i].extension = direction[i] * du;
        if (v != nullptr)
          velocity_difference[i] = difference(v);
        // Without inertia a velocity is a difference over a step in which the
        // line turns; that of the extension does not see the turn.
        motion[i].rate = differences_extension(state, dt)
          ? (motion[i].extension - motion[i].previous_extension) / dt
          : direction[i] * velocity_difference[i];
        motion[i].dt   = dt;
      }
  }

  void ConnectorForces::begin_step(const Step &step)
  {
    evaluate_motion(step.from, step.dt);
    for (ConnectorMotion &m : motion)
      m.previous_extension = m.extension;
  }

  void ConnectorForces::add_residual(const Step &step, double *residual)
  {
    evaluate_motion(step.to, step.dt);
    law->evaluate(connectors.size(),
                  motion.data(),
                  step.from.history.data() + first_history,
                  step.to.history.data() + first_history,
                  response.data());
    for (unsigned int i = 0; i < connectors.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double force = response[i].force * direction[i][c];
          if (connectors[i].unknowns[c] >= 0)
            residual[connectors[i].unknowns[c]] -= force;
          if (connectors[i].unknowns[3 + c] >= 0)
            residual[connectors[i].unknowns[3 + c]] += force;
        }
  }

  void ConnectorForces::add_tangent(const Step           &step,
                                    const TangentFactors &factors,
                                    TangentMatrix        &matrix) const
  {
    if (factors.stiffness == 0 && factors.damping == 0)
      return;
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const auto  &n     = direction[i];
        const double along = factors.stiffness * response[i].stiffness +
          factors.damping * response[i].damping;
        // D: derivative of the force on the second end by the relative motion.
        double D[3][3];
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            D[a][b] = along * n[a] * n[b];
        if (follows_line)
          {
            // The line turns with the ends: force and rate change direction.
            const double turning = factors.stiffness / current_length[i];
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int b = 0; b < 3; ++b)
                {
                  const double across = (a == b ? 1. : 0.) - n[a] * n[b];
                  D[a][b] += turning * response[i].force * across;
                  if (differences_extension(step.to, step.dt))
                    continue;
                  const double rate_by_position =
                    velocity_difference[i][b] - motion[i].rate * n[b];
                  D[a][b] +=
                    turning * response[i].damping * n[a] * rate_by_position;
                }
          }
        double block[36];
        for (unsigned int a = 0; a < 6; ++a)
          for (unsigned int b = 0; b < 6; ++b)
            block[6 * a + b] = ((a < 3) == (b < 3) ? 1 : -1) * D[a % 3][b % 3];
        matrix.add(first_block + i, block);
      }
  }

  void ConnectorForces::accept(const Step &step)
  {
    const unsigned int n_history = law->n_history();
    for (unsigned int i = 0; i < connectors.size(); ++i)
      {
        const unsigned int    at = first_history + i * n_history;
        const ConnectorEnergy energy =
          law->energy(motion[i],
                      step.from.history.data() + at,
                      step.to.history.data() + at);
        stored[i] = energy.stored;
        if (law->is_viscous())
          step.to.dissipated[first_dissipated + i] =
            step.from.dissipated[first_dissipated + i] + energy.dissipated;
      }
  }

  void ConnectorForces::add_energies(const State &state,
                                     Energies    &energies) const
  {
    for (const unsigned int i : counted)
      {
        energies.stored += stored[i];
        if (law->is_viscous())
          energies.dissipated += state.dissipated[first_dissipated + i];
      }
  }

  double
  ConnectorForces::round_off_scale(const double largest_displacement,
                                   const double /*largest_rotation*/) const
  {
    double stiffest = 0;
    for (const ConnectorResponse &r : response)
      stiffest = std::max(stiffest, r.stiffness);
    return stiffest * largest_displacement;
  }

  const std::string &ConnectorForces::name() const
  {
    return group_name;
  }

  bool ConnectorForces::is_viscous() const
  {
    return law->is_viscous();
  }

  unsigned int ConnectorForces::n_reported() const
  {
    return counted.size();
  }

  ConnectorReport ConnectorForces::report(const unsigned int i,
                                          const State       &state) const
  {
    const unsigned int c    = counted[i];
    const Ends        &ends = connectors[c];
    ConnectorReport    report;
    report.ends[0] = lattice.joints[ends.first_joint];
    report.ends[1] = report.ends[0] + ends.span;
    for (unsigned int k = 0; k < 6; ++k)
      if (ends.unknowns[k] >= 0)
        report.displacements[k / 3][k % 3] =
          state.displacement[ends.unknowns[k]];
    report.force     = response[c].force;
    report.extension = motion[c].extension;
    report.dissipated =
      law->is_viscous() ? state.dissipated[first_dissipated + c] : 0.;
    report.cell = ends.cell;
    return report;
  }
} // namespace auxfem
