#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/path_work.h>
#include <auxfem/equations/prescribed_motion.h>
#include <auxfem/equations/step_travel.h>

namespace auxfem
{
  namespace
  {
    class SupportWork : public Effect, public StageTerms
    {
    public:
      explicit SupportWork(const LatticeModel &model)
        : model(model)
        , rotations(model.numbering)
        , entries(model.supports.size(), 0)
      {}

      bool is_linear() const override
      {
        return true;
      }

      void register_in(StateLayout &layout) override
      {
        for (unsigned int s = 0; s < entries.size(); ++s)
          if (!model.supports[s].is_at_rest())
            entries[s] = layout.energies.enter(
              {EnergyKind::work,
               model.supports[s].name + ".support_work",
               "work of the support's prescribed motion since the start"});
      }

      void add_residual(const Evaluation & /*evaluation*/,
                        double * /*residual*/,
                        EffectResults * /*results*/) const override
      {}

      void account_step(const Evaluation &step,
                        const EffectResults * /*results*/,
                        EnergyAccount &account) const override
      {
        for (unsigned int s = 0; s < entries.size(); ++s)
          if (!model.supports[s].is_at_rest())
            account.add_in_step(entries[s], work(model.supports[s], step));
      }

      void account_stage(const Evaluation &stage,
                         const EffectResults * /*results*/,
                         EnergyAccount &account) const override
      {
        for (unsigned int s = 0; s < entries.size(); ++s)
          for (const Support::PrescribedUnknown &prescribed :
               model.supports[s].unknowns)
            if (const int i = prescribed.unknown;
                !model.supports[s].is_at_rest() &&
                model.numbering.layout().is_owned(i))
              account.add_power(entries[s],
                                stage.to.residual[i] *
                                  rotations.spatial_rate(stage.to, i));
      }

      StageNeeds stage_needs() const override
      {
        return StageNeeds::residual;
      }

    private:
      /** Work of impulses: times the mean of the velocities before and after.
       */
      double impulse_work(const Support    &support,
                          const Evaluation &strike) const
      {
        const DofNumbering &numbering = model.numbering;
        const Vector       &before    = *strike.from.velocity,
                     &after           = *strike.to.velocity;
        double sum                    = 0;
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (const int i = prescribed.unknown;
              numbering.layout().is_owned(i) &&
              !support.moves_as_rotation(prescribed))
            sum += (*strike.impulses)[i] * (before[i] + after[i]) / 2;
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const unsigned int        i     = prescribed.rotation;
            const std::array<int, 3> &spins = numbering.rotations()[i];
            const SpaceVector         mean = (spatial_velocity(strike.from, i) +
                                      spatial_velocity(strike.to, i)) /
              2;
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && numbering.layout().is_owned(spins[c]))
                sum += (*strike.impulses)[spins[c]] * mean[c];
          }
        return sum;
      }

      /** Work of the support's mean forces over the step, the residual. */
      double mean_work(const Support &support, const Evaluation &step) const
      {
        const StepTravel travel(step, model.numbering);
        double           sum = 0;
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (const int i = prescribed.unknown;
              model.numbering.layout().is_owned(i))
            sum += step.to.residual[i] * travel.of(i);
        return sum;
      }

      /** By the mean of the support's forces over the step. */
      double work(const Support &support, const Evaluation &step) const
      {
        if (step.impulses)
          return impulse_work(support, step);
        if (step.kind == Evaluation::Kind::between)
          return mean_work(support, step);
        const DofNumbering &numbering  = model.numbering;
        const auto          mean_force = [&](const int unknown) {
          return (step.from.residual[unknown] + step.to.residual[unknown]) / 2;
        };
        const PathWork path(step);
        double         sum = 0;
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (const int i = prescribed.unknown;
              numbering.layout().is_owned(i) &&
              !support.moves_as_rotation(prescribed))
            {
              sum += mean_force(i) *
                (step.to.displacement[i] - step.from.displacement[i]);
              if (const State::Before *before = path.state_before())
                sum += path.beyond_mean({{before->residual[i],
                                          step.from.residual[i],
                                          step.to.residual[i]}},
                                        {{before->displacement[i],
                                          step.from.displacement[i],
                                          step.to.displacement[i]}});
            }
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const std::array<int, 3> &spins =
              numbering.rotations()[prescribed.rotation];
            const SpaceVector increment =
              rotations.spatial_increment(step, prescribed.rotation);
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && numbering.layout().is_owned(spins[c]))
                sum += mean_force(spins[c]) * increment[c];
          }
        return sum;
      }

      SpaceVector spatial_velocity(const State       &state,
                                   const unsigned int i) const
      {
        return rotated(state.rotations[i],
                       rotations.values(*state.velocity, i));
      }

      const LatticeModel       &model;
      const NodeRotations       rotations;
      std::vector<unsigned int> entries; ///< by support
    };
  } // namespace

  std::unique_ptr<Effect> make_support_work(const LatticeModel &model)
  {
    if (supports_are_at_rest(model))
      return nullptr;
    return std::make_unique<SupportWork>(model);
  }
} // namespace auxfem
