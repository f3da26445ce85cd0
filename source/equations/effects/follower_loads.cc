#include <auxfem/equations/effects/follower_loads.h>
#include <auxfem/equations/load_values.h>
#include <auxfem/equations/step_travel.h>

namespace auxfem
{
  FollowerLoads::FollowerLoads(const Lattice      &lattice,
                               const DofNumbering &numbering,
                               const bool          raised_from_zero)
    : is_planar(lattice.dimension == 2)
    , numbering(numbering)
    , rotations(numbering)
    , raised_from_zero(raised_from_zero)
  {}

  unsigned int FollowerLoads::add_load(
    const std::array<TimeFunction, n_motion_components> &components,
    const EnergyEntry                                   &work)
  {
    loads.push_back({components, work, {}});
    return loads.size() - 1;
  }

  void FollowerLoads::add_joint(const unsigned int load,
                                const unsigned int joint)
  {
    Joint unknowns;
    for (unsigned int c = 0; c < n_motion_components; ++c)
      unknowns[c] = numbering.joint_unknown(joint, c);
    loads[load].joints.push_back(unknowns);
  }

  bool FollowerLoads::empty() const
  {
    return loads.empty();
  }

  bool FollowerLoads::is_linear() const
  {
    return false;
  }

  void FollowerLoads::register_blocks(TangentPattern &pattern)
  {
    bool is_first = true;
    for (const Load &load : loads)
      for (const Joint &joint : load.joints)
        {
          const std::size_t block =
            pattern.register_block(joint.data(), n_motion_components);
          if (is_first)
            first_block = block;
          is_first = false;
        }
  }

  template <class Value>
  FollowerLoads::Values FollowerLoads::values(const Load  &load,
                                              const Value &value)
  {
    Values values;
    for (unsigned int c = 0; c < n_motion_components; ++c)
      if (!load.components[c].is_zero())
        (c < 3 ? values.force : values.moment)[c % 3] =
          value(load.components[c]);
    return values;
  }

  FollowerLoads::Values FollowerLoads::values_now(const Load       &load,
                                                  const Evaluation &evaluation)
  {
    return values(load, [&](const TimeFunction &component) {
      return value_at_end(component, evaluation);
    });
  }

  FollowerLoads::Values
  FollowerLoads::values_before(const Load &load, const Evaluation &step) const
  {
    return raised_from_zero && step.from.time == 0
      ? Values()
      : values(load, [&](const TimeFunction &component) {
          return value_at_start(component, step);
        });
  }

  void FollowerLoads::register_in(StateLayout &layout)
  {
    for (Load &load : loads)
      load.work_entry = layout.energies.enter(load.work);
  }

  Quaternion FollowerLoads::rotation(const Joint &joint,
                                     const State &state) const
  {
    const int rotation_about_z = joint[rotation_z];
    return is_planar
      ? exponential(SpaceVector({0, 0, state.displacement[rotation_about_z]}))
      : state.rotations[numbering.rotations().with(rotation_about_z)];
  }

  template <class Value>
  void FollowerLoads::subtract(const Value &value,
                               const State &state,
                               double      *forces) const
  {
    for (const Load &load : loads)
      {
        const Values of_load = values(load, value);
        for (const Joint &joint : load.joints)
          {
            const Quaternion  P      = rotation(joint, state);
            const SpaceVector force  = rotated(P, of_load.force),
                              moment = rotated(P, of_load.moment);
            for (unsigned int c = 0; c < n_motion_components; ++c)
              if (joint[c] >= 0)
                forces[joint[c]] -= (c < 3 ? force : moment)[c % 3];
          }
      }
  }

  void FollowerLoads::add_residual(const Evaluation &evaluation,
                                   double           *residual,
                                   EffectResults * /*results*/) const
  {
    if (evaluation.kind == Evaluation::Kind::between)
      add_mean_loads(evaluation, residual);
    else
      subtract(
        [&](const TimeFunction &component) {
          return value_at_end(component, evaluation);
        },
        evaluation.to,
        residual);
  }

  void FollowerLoads::add_mean_loads(const Evaluation &step,
                                     double           *residual) const
  {
    const StepTravel travel(step, numbering);
    for (const Load &load : loads)
      {
        const Ends ends = values_at_ends(load, step);
        for (const Joint &joint : load.joints)
          {
            const Values mean = mean_values(ends, joint, step);
            // In space the moment turns with the joint; the rotation of the
            // step is the same seen from its start and its end.
            const SpaceVector moment =
              (rotated(rotation(joint, step.from), mean.moment) +
               rotated(rotation(joint, step.to), mean.moment)) /
              2;
            for (unsigned int c = 0; c < n_motion_components; ++c)
              if (const int i = joint[c]; i >= 0)
                residual[i] -= (c < 3 ? mean.force : moment)[c % 3] *
                  travel.increment_per_travel(i);
          }
      }
  }

  FollowerLoads::Ends
  FollowerLoads::values_at_ends(const Load &load, const Evaluation &step) const
  {
    return {values_before(load, step), values_now(load, step)};
  }

  FollowerLoads::Values FollowerLoads::mean_values(const Ends       &ends,
                                                   const Joint      &joint,
                                                   const Evaluation &step) const
  {
    // The moment is constant in axes that turn with the joint, as is the turn
    // itself.
    const auto &[before, now] = ends;
    return {(rotated(rotation(joint, step.from), before.force) +
             rotated(rotation(joint, step.to), now.force)) /
              2,
            (before.moment + now.moment) / 2};
  }

  void FollowerLoads::add_load_derivative(const Evaluation &evaluation,
                                          double           *derivative) const
  {
    const double time = time_of_loads(evaluation.to);
    subtract(
      [&](const TimeFunction &component) { return component.jet(time)[1]; },
      evaluation.to,
      derivative);
  }

  void FollowerLoads::add_tangent(const Evaluation &evaluation,
                                  const EffectResults * /*results*/,
                                  const TangentFactors &factors,
                                  TangentMatrix        &matrix) const
  {
    const double factor = factors.stiffness;
    std::size_t  number = first_block;
    for (const Load &load : loads)
      {
        const Values now = values_now(load, evaluation);
        for (const Joint &joint : load.joints)
          {
            const Quaternion  P          = rotation(joint, evaluation.to);
            const SpaceTensor by_spin[2] = {
              factor * cross_product_tensor(rotated(P, now.force)),
              factor * cross_product_tensor(rotated(P, now.moment))};
            double block[n_motion_components * n_motion_components] = {};
            for (unsigned int r = 0; r < n_motion_components; ++r)
              for (unsigned int c = 0; c < 3; ++c)
                block[r * n_motion_components + first_rotation + c] =
                  by_spin[r / 3][r % 3][c];
            matrix.add(number++, block);
          }
      }
  }

  void FollowerLoads::account_step(const Evaluation &step,
                                   const EffectResults * /*results*/,
                                   EnergyAccount &account) const
  {
    // As for dead loads, by the mean of the forces over the step.
    for (const Load &load : loads)
      {
        const Ends ends = values_at_ends(load, step);
        for (const Joint &joint : load.joints)
          {
            if (!numbering.layout().is_owned(joint[0]))
              continue;
            const Values mean = mean_values(ends, joint, step);
            for (unsigned int c = 0; c < n_motion_components; ++c)
              if (joint[c] >= 0)
                account.add_in_step(load.work_entry,
                                    (c < 3 ? mean.force : mean.moment)[c % 3] *
                                      (step.to.displacement[joint[c]] -
                                       step.from.displacement[joint[c]]));
          }
      }
  }

  void FollowerLoads::account_stage(const Evaluation &stage,
                                    const EffectResults * /*results*/,
                                    EnergyAccount &account) const
  {
    for (const Load &load : loads)
      {
        const Values now = values_now(load, stage);
        for (const Joint &joint : load.joints)
          {
            if (!numbering.layout().is_owned(joint[0]))
              continue;
            const Quaternion  P      = rotation(joint, stage.to);
            const SpaceVector force  = rotated(P, now.force),
                              moment = rotated(P, now.moment);
            for (unsigned int c = 0; c < n_motion_components; ++c)
              if (joint[c] >= 0)
                account.add_power(load.work_entry,
                                  (c < 3 ? force : moment)[c % 3] *
                                    rotations.spatial_rate(stage.to, joint[c]));
          }
      }
  }
} // namespace auxfem
