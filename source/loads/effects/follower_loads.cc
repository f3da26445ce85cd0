#include <auxfem/equations/load_work.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/follower_loads.h>

namespace auxfem
{
  namespace
  {
    /** Forces P f(t) and moments P m(t) that turn with the rotation P of their
     * joint. They have no potential, and their tangent is not symmetric. */
    class FollowerLoads : public Effect, public StageTerms
    {
    public:
      FollowerLoads(const Lattice                   &lattice,
                    const DofNumbering              &numbering,
                    const bool                       raised_from_zero,
                    const std::vector<FollowerLoad> &definitions)
        : is_planar(lattice.dimension == 2)
        , numbering(numbering)
        , rotations(numbering)
        , raised_from_zero(raised_from_zero)
      {
        for (const FollowerLoad &definition : definitions)
          {
            Load load{definition.components, definition.work, {}};
            for (const unsigned int joint : definition.joints)
              {
                Joint unknowns;
                for (unsigned int c = 0; c < n_motion_components; ++c)
                  unknowns[c] = numbering.joint_unknown(joint, c);
                load.joints.push_back(unknowns);
              }
            loads.push_back(load);
          }
      }

      bool is_linear() const override
      {
        return false;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block = pattern.n_blocks();
        for (const Load &load : loads)
          for (const Joint &joint : load.joints)
            pattern.register_block(joint.data(), joint.size());
      }

      void register_in(StateLayout &layout) override
      {
        for (Load &load : loads)
          load.work_entry = layout.energies.enter(load.work);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          add_mean_loads(evaluation, residual);
        else
          subtract(
            [&](const TimeFunction &component) {
              return value_at_end(component, evaluation);
            },
            evaluation.to,
            residual);
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
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

      void add_load_derivative(const Evaluation &evaluation,
                               double           *derivative) const override
      {
        const double time = time_of_loads(evaluation.to);
        subtract(
          [&](const TimeFunction &component) { return component.jet(time)[1]; },
          evaluation.to,
          derivative);
      }

      void account_step(const Evaluation &step,
                        const EffectCache * /*results*/,
                        EnergyAccount &account) const override
      {
        // Mean force over the step times displacement, as for dead loads.
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
                                        (c < 3 ? mean.force
                                               : mean.moment)[c % 3] *
                                          (step.to.displacement[joint[c]] -
                                           step.from.displacement[joint[c]]));
              }
          }
      }

      void account_stage(const Evaluation &stage,
                         const EffectCache * /*results*/,
                         EnergyAccount &account) const override
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
                                        rotations.spatial_rate(stage.to,
                                                               joint[c]));
              }
          }
      }

    private:
      /** Force and moment in the axes that turn with the joint (N, N m). */
      struct Values
      {
        SpaceVector force, moment;
      };

      /** Local unknowns by component of motion; -1: none. */
      using Joint = std::array<int, n_motion_components>;
      struct Load
      {
        std::array<TimeFunction, n_motion_components> components;
        EnergyEntry                                   work;
        std::vector<Joint>                            joints;
        unsigned int work_entry = 0; ///< in the energy ledger
      };

      /** Force and moment of @p load; @p value(function) evaluates a
       * component. */
      template <class Value>
      static Values values(const Load &load, const Value &value)
      {
        Values values;
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (!load.components[c].is_zero())
            (c < 3 ? values.force : values.moment)[c % 3] =
              value(load.components[c]);
        return values;
      }

      /** Values at the end of the step. */
      static Values values_now(const Load &load, const Evaluation &evaluation)
      {
        return values(load, [&](const TimeFunction &component) {
          return value_at_end(component, evaluation);
        });
      }

      /** Values at the start of the step. */
      Values values_before(const Load &load, const Evaluation &step) const
      {
        return raised_from_zero && step.from.time == 0
          ? Values()
          : values(load, [&](const TimeFunction &component) {
              return value_at_start(component, step);
            });
      }

      /** Values at start and end of a step. All ranks must evaluate them, as
       * functions of time may throw. */
      struct Ends
      {
        Values before, now;
      };

      Ends values_at_ends(const Load &load, const Evaluation &step) const
      {
        return {values_before(load, step), values_now(load, step)};
      }

      /** Means over the step of the force in the global frame and of the moment
       * in the frame of the joint. */
      Values mean_values(const Ends       &ends,
                         const Joint      &joint,
                         const Evaluation &step) const
      {
        // The rotation of the step is the same in both frames, so that the
        // moment's mean can be taken in that of the joint.
        const auto &[before, now] = ends;
        return {(rotated(rotation(joint, step.from), before.force) +
                 rotated(rotation(joint, step.to), now.force)) /
                  2,
                (before.moment + now.moment) / 2};
      }

      /** Adds the loads of a discrete-gradient step, whose moments do the exact
       * work of the mean. */
      void add_mean_loads(const Evaluation &step, double *residual) const
      {
        const StepTravel travel(step, numbering);
        for (const Load &load : loads)
          {
            const Ends ends = values_at_ends(load, step);
            for (const Joint &joint : load.joints)
              {
                const Values mean = mean_values(ends, joint, step);
                // The rotation vector of the step is the same in the frames of
                // its start and end, so that both rotated moments do the same
                // work.
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

      /** Subtracts force and moment of all loads; @p value as for values(). */
      template <class Value>
      void
      subtract(const Value &value, const State &state, double *forces) const
      {
        for (const Load &load : loads)
          {
            const Values local = values(load, value);
            for (const Joint &joint : load.joints)
              {
                const Quaternion  P      = rotation(joint, state);
                const SpaceVector force  = rotated(P, local.force),
                                  moment = rotated(P, local.moment);
                for (unsigned int c = 0; c < n_motion_components; ++c)
                  if (joint[c] >= 0)
                    forces[joint[c]] -= (c < 3 ? force : moment)[c % 3];
              }
          }
      }

      Quaternion rotation(const Joint &joint, const State &state) const
      {
        const int rotation_about_z = joint[rotation_z];
        return is_planar
          ? exponential(
              SpaceVector({0, 0, state.displacement[rotation_about_z]}))
          : state.rotations[numbering.rotations().with(rotation_about_z)];
      }

      const bool          is_planar;
      const DofNumbering &numbering;
      const NodeRotations rotations;
      const bool          raised_from_zero;
      std::vector<Load>   loads;
      std::size_t         first_block = 0;
    };
  } // namespace

  std::unique_ptr<Effect>
  make_follower_loads(const Lattice                   &lattice,
                      const DofNumbering              &numbering,
                      const bool                       raised_from_zero,
                      const std::vector<FollowerLoad> &loads)
  {
    return std::make_unique<FollowerLoads>(lattice,
                                           numbering,
                                           raised_from_zero,
                                           loads);
  }
} // namespace auxfem
