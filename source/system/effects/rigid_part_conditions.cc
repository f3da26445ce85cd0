#include <auxfem/system/effects/rigid_part_conditions.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Difference of the values at both base points, whose unknowns come first.
     */
    template <std::size_t n>
    PlaneVector across_base(const std::array<int, n> &unknowns,
                            const double             *values)
    {
      PlaneVector difference;
      for (unsigned int c = 0; c < 2; ++c)
        difference[c] = values[unknowns[2 + c]] - values[unknowns[c]];
      return difference;
    }

    /** Whether multiplier rows are to hold the conditions' second derivatives.
     */
    bool wants_accelerations(const Step &step)
    {
      return step.dt == 0 && step.to.acceleration;
    }

    /** Entry (i, j) of a symmetric row-major block of size n. */
    template <std::size_t n>
    void set_pair(std::array<double, n * n> &block,
                  const unsigned int         i,
                  const unsigned int         j,
                  const double               value)
    {
      block[n * i + j] = block[n * j + i] = value;
    }
  } // namespace

  RigidPartConditions::RigidPartConditions(const std::vector<RigidBody> &bodies,
                                           const Lattice      &lattice,
                                           const DofNumbering &numbering,
                                           const bool          large_rotation,
                                           const dealii::Tensor<1, 3> &gravity)
    : bodies(bodies)
    , lattice(lattice)
    , numbering(numbering)
    , large_rotation(large_rotation)
    , gravity(gravity)
  {
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const RigidBody &body = bodies[b];
        const auto      &base = body.base;
        const RigidPart &part = lattice.rigid_parts[body.part];
        unsigned int     next = 0;
        joint_begin.push_back(joints.size());
        clamp_begin.push_back(clamps.size());
        const auto multiplier = [&] {
          return numbering.multiplier(body.part, next++);
        };
        bases.push_back({{{base[0], base[1], base[2], base[3], multiplier()}},
                         {body.rest, body.length}});
        for (unsigned int k = 2; k < part.joints.size(); ++k)
          {
            const unsigned int joint = part.joints[k];
            const NaturalPlace place =
              place_in(part, lattice, lattice.joints[joint]);
            const int first = multiplier(), second = multiplier();
            joints.push_back({k,
                              {{numbering.joint_unknown(joint, 0),
                                numbering.joint_unknown(joint, 1),
                                base[0],
                                base[1],
                                base[2],
                                base[3],
                                first,
                                second}},
                              {{shape(place, 0), shape(place, 1)}}});
          }
        for (const unsigned int joint : numbering.clamped_joints(body.part))
          clamps.push_back({{{base[0],
                              base[1],
                              base[2],
                              base[3],
                              numbering.joint_unknown(joint, rotation_z),
                              multiplier()}},
                            {body.rest, body.length}});
        if (body.counted)
          reported.push_back(b);
      }
    joint_begin.push_back(joints.size());
    clamp_begin.push_back(clamps.size());
  }

  bool RigidPartConditions::is_linear() const
  {
    return !large_rotation;
  }

  void RigidPartConditions::register_blocks(TangentMatrix &matrix)
  {
    // Numbered consecutively: bases, then joints, then clamps.
    bool       is_first = true;
    const auto add_all  = [&](const auto &conditions) {
      for (const auto &condition : conditions)
        {
          const std::size_t block =
            matrix.register_block(condition.unknowns.data(),
                                  condition.unknowns.size());
          if (is_first)
            first_block = block;
          is_first = false;
        }
    };
    add_all(bases);
    add_all(joints);
    add_all(clamps);
  }

  PlaneVector RigidPartConditions::gradient(const Base   &base,
                                            const double *u) const
  {
    return base.condition.gradient(
      large_rotation ? across_base(base.unknowns, u) : PlaneVector());
  }

  std::pair<PlaneVector, double>
  RigidPartConditions::gradient(const Clamp &clamp, const double *u) const
  {
    if (!large_rotation)
      return {clamp.condition.normal(0), -clamp.condition.length};
    const double      phi = u[clamp.unknowns[4]];
    const PlaneVector d = clamp.condition.rest + across_base(clamp.unknowns, u);
    return {clamp.condition.normal(phi),
            clamp.condition.normal_derivative(phi) * d};
  }

  void RigidPartConditions::add_residual(const Step &step, double *residual)
  {
    add_base_rows(step, residual);
    add_joint_rows(step, residual);
    add_clamp_rows(step, residual);
    largest_multiplier = 0;
    for (const int multiplier : numbering.multipliers())
      largest_multiplier = std::max(largest_multiplier,
                                    std::abs(step.to.displacement[multiplier]));
  }

  void RigidPartConditions::add_base_rows(const Step &step,
                                          double     *residual) const
  {
    const double *u = step.to.displacement.Values();
    for (const Base &base : bases)
      {
        const auto       &unknowns = base.unknowns;
        const PlaneVector G        = gradient(base, u);
        for (unsigned int c = 0; c < 2; ++c)
          {
            residual[unknowns[c]] -= u[unknowns[4]] * G[c];
            residual[unknowns[2 + c]] += u[unknowns[4]] * G[c];
          }
        double &row = residual[unknowns[4]];
        if (wants_accelerations(step))
          {
            row += G * across_base(unknowns, step.to.acceleration->Values());
            if (large_rotation)
              row += base.condition.curvature() *
                across_base(unknowns, step.to.velocity->Values()).norm_square();
          }
        else
          {
            const PlaneVector stretch = across_base(unknowns, u);
            row += large_rotation ? base.condition.value(stretch) : G * stretch;
          }
      }
  }

  void RigidPartConditions::add_joint_rows(const Step &step,
                                           double     *residual) const
  {
    const double *u = step.to.displacement.Values();
    const double *q =
      wants_accelerations(step) ? step.to.acceleration->Values() : u;
    for (const Joint &joint : joints)
      {
        const auto &unknowns = joint.unknowns;
        for (unsigned int c = 0; c < 2; ++c)
          {
            const double lambda = u[unknowns[6 + c]];
            double       gap    = q[unknowns[c]];
            residual[unknowns[c]] += lambda;
            for (unsigned int i = 0; i < 4; ++i)
              {
                gap -= joint.shapes[c][i] * q[unknowns[2 + i]];
                residual[unknowns[2 + i]] -= lambda * joint.shapes[c][i];
              }
            residual[unknowns[6 + c]] += gap;
          }
      }
  }

  void RigidPartConditions::add_clamp_rows(const Step &step,
                                           double     *residual) const
  {
    const double *u = step.to.displacement.Values();
    for (const Clamp &clamp : clamps)
      {
        const auto &unknowns     = clamp.unknowns;
        const auto [along, turn] = gradient(clamp, u);
        const double lambda      = u[unknowns[5]];
        for (unsigned int c = 0; c < 2; ++c)
          {
            residual[unknowns[c]] -= lambda * along[c];
            residual[unknowns[2 + c]] += lambda * along[c];
          }
        residual[unknowns[4]] += lambda * turn;

        double &row = residual[unknowns[5]];
        if (wants_accelerations(step))
          {
            const double *a = step.to.acceleration->Values();
            const double *v = step.to.velocity->Values();
            row += along * across_base(unknowns, a) + turn * a[unknowns[4]];
            if (large_rotation)
              {
                const double      rate = v[unknowns[4]];
                const PlaneVector d =
                  clamp.condition.rest + across_base(unknowns, u);
                row += 2 * rate *
                    (clamp.condition.normal_derivative(u[unknowns[4]]) *
                     across_base(unknowns, v)) -
                  rate * rate * (along * d);
              }
          }
        else if (large_rotation)
          row += along * (clamp.condition.rest + across_base(unknowns, u));
        else
          row += along * across_base(unknowns, u) + turn * u[unknowns[4]];
      }
  }

  void RigidPartConditions::add_tangent(const Step           &step,
                                        const TangentFactors &factors,
                                        TangentMatrix        &matrix) const
  {
    // The gradients are no stiffness: they stand in the matrix whatever is
    // solved for, displacements or accelerations.
    const double *u     = step.to.displacement.Values();
    std::size_t   block = first_block;
    for (const Base &base : bases)
      {
        const PlaneVector      G         = gradient(base, u);
        const double           geometric = large_rotation
                    ? factors.stiffness * u[base.unknowns[4]] * base.condition.curvature()
                    : 0.;
        std::array<double, 25> values    = {};
        for (unsigned int c = 0; c < 2; ++c)
          {
            set_pair<5>(values, c, 4, -G[c]);
            set_pair<5>(values, 2 + c, 4, G[c]);
            set_pair<5>(values, c, c, geometric);
            set_pair<5>(values, 2 + c, 2 + c, geometric);
            set_pair<5>(values, c, 2 + c, -geometric);
          }
        matrix.add(block++, values.data());
      }
    for (const Joint &joint : joints)
      {
        std::array<double, 64> values = {};
        for (unsigned int c = 0; c < 2; ++c)
          {
            set_pair<8>(values, c, 6 + c, 1.);
            for (unsigned int i = 0; i < 4; ++i)
              set_pair<8>(values, 2 + i, 6 + c, -joint.shapes[c][i]);
          }
        matrix.add(block++, values.data());
      }
    for (const Clamp &clamp : clamps)
      {
        const auto [along, turn]      = gradient(clamp, u);
        std::array<double, 36> values = {};
        set_pair<6>(values, 4, 5, turn);
        for (unsigned int c = 0; c < 2; ++c)
          {
            set_pair<6>(values, c, 5, -along[c]);
            set_pair<6>(values, 2 + c, 5, along[c]);
          }
        if (large_rotation)
          {
            const double      force = factors.stiffness * u[clamp.unknowns[5]];
            const PlaneVector d =
              clamp.condition.rest + across_base(clamp.unknowns, u);
            const PlaneVector derivative =
              clamp.condition.normal_derivative(u[clamp.unknowns[4]]);
            set_pair<6>(values, 4, 4, -force * (along * d));
            for (unsigned int c = 0; c < 2; ++c)
              {
                set_pair<6>(values, c, 4, -force * derivative[c]);
                set_pair<6>(values, 2 + c, 4, force * derivative[c]);
              }
          }
        matrix.add(block++, values.data());
      }
  }

  double
  RigidPartConditions::round_off_scale(const double /*largest_displacement*/,
                                       const double /*largest_rotation*/) const
  {
    return largest_multiplier;
  }

  void RigidPartConditions::find_rates(const State &state, double *rates) const
  {
    const double *u = state.displacement.Values();
    const double *v = state.velocity->Values();
    for (const Base &base : bases)
      rates[base.unknowns[4]] =
        gradient(base, u) * across_base(base.unknowns, v);
    for (const Joint &joint : joints)
      for (unsigned int c = 0; c < 2; ++c)
        {
          double rate = v[joint.unknowns[c]];
          for (unsigned int i = 0; i < 4; ++i)
            rate -= joint.shapes[c][i] * v[joint.unknowns[2 + i]];
          rates[joint.unknowns[6 + c]] = rate;
        }
    for (const Clamp &clamp : clamps)
      {
        const auto [along, turn] = gradient(clamp, u);
        rates[clamp.unknowns[5]] =
          along * across_base(clamp.unknowns, v) + turn * v[clamp.unknowns[4]];
      }
  }

  unsigned int RigidPartConditions::n_reported() const
  {
    return reported.size();
  }

  unsigned int RigidPartConditions::part(const unsigned int i) const
  {
    return bodies[reported[i]].part;
  }

  double RigidPartConditions::rotation(const unsigned int i,
                                       const State       &state) const
  {
    const RigidBody  &body = bodies[reported[i]];
    const PlaneVector stretch =
      across_base(bases[reported[i]].unknowns, state.displacement.Values());
    const double across = turned(body.rest) * stretch;
    return large_rotation
      ? std::atan2(across, body.rest * (body.rest + stretch))
      : across / (body.length * body.length);
  }

  RigidPartReport RigidPartConditions::report(const unsigned int i,
                                              const State       &state) const
  {
    const unsigned int b    = reported[i];
    const RigidBody   &body = bodies[b];
    const double      *u    = state.displacement.Values();
    RigidPartReport    report;
    report.part = body.part;
    for (unsigned int r = 0; r < 4; ++r)
      {
        report.base_displacement[r] = u[body.base[r]];
        report.base_velocity[r] =
          state.velocity ? (*state.velocity)[body.base[r]] : 0.;
      }
    report.forces.resize(lattice.rigid_parts[body.part].joints.size());

    // What the joints exert is the body's inertia less its weight, and what its
    // conditions take up.
    std::array<double, 4> on_base = {};
    for (unsigned int r = 0; r < 4; ++r)
      for (unsigned int s = 0; s < 4; ++s)
        on_base[r] += body.mass[4 * r + s] *
          ((state.acceleration ? (*state.acceleration)[body.base[s]] : 0.) -
           gravity[s % 2]);
    const PlaneVector G = gradient(bases[b], u);
    for (unsigned int c = 0; c < 2; ++c)
      {
        on_base[c] -= u[bases[b].unknowns[4]] * G[c];
        on_base[2 + c] += u[bases[b].unknowns[4]] * G[c];
      }
    for (unsigned int k = joint_begin[b]; k < joint_begin[b + 1]; ++k)
      for (unsigned int c = 0; c < 2; ++c)
        {
          const Joint &joint                    = joints[k];
          const double lambda                   = u[joint.unknowns[6 + c]];
          report.forces[joint.place_in_part][c] = lambda;
          for (unsigned int r = 0; r < 4; ++r)
            on_base[r] -= lambda * joint.shapes[c][r];
        }
    for (unsigned int k = clamp_begin[b]; k < clamp_begin[b + 1]; ++k)
      {
        const PlaneVector force =
          u[clamps[k].unknowns[5]] * gradient(clamps[k], u).first;
        for (unsigned int c = 0; c < 2; ++c)
          {
            on_base[c] -= force[c];
            on_base[2 + c] += force[c];
          }
      }
    for (unsigned int r = 0; r < 4; ++r)
      report.forces[r / 2][r % 2] = on_base[r];
    return report;
  }
} // namespace auxfem
