#include <auxfem/equations/load_work.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/applied_loads.h>
#include <auxfem/loads/effects/prescribed_motion.h>

namespace auxfem
{
  namespace
  {
    /** Dead loads: fixed distributions over the unknowns times functions of
     * time. */
    class AppliedLoads : public Effect, public StageTerms
    {
    public:
      AppliedLoads(const DofNumbering             &numbering,
                   const bool                      raised_from_zero,
                   const std::vector<AppliedLoad> &loads)
        : numbering(numbering)
        , rotations(numbering)
        , raised_from_zero(raised_from_zero)
        , loads(loads.begin(), loads.end())
      {}

      bool is_linear() const override
      {
        return true;
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
          {
            add_mean_loads(evaluation, residual);
            return;
          }
        for (const Load &load : loads)
          {
            const double value = value_at_end(load.time_history, evaluation);
            for (const AppliedLoad::Weight &w : load.weights)
              residual[w.unknown] -= value * w.weight;
          }
      }

      void add_load_derivative(const Evaluation &evaluation,
                               double           *derivative) const override
      {
        for (const Load &load : loads)
          {
            const double rate =
              load.time_history.jet(time_of_loads(evaluation.to))[1];
            for (const AppliedLoad::Weight &w : load.weights)
              derivative[w.unknown] -= rate * w.weight;
          }
      }

      void account_step(const Evaluation &step,
                        const EffectCache * /*results*/,
                        EnergyAccount &account) const override
      {
        // Mean force over the step times displacement: exact for average
        // acceleration and discrete gradients, otherwise of second order.
        const PathWork path(step);
        for (const Load &load : loads)
          {
            double along = 0;
            for (const AppliedLoad::Weight &w : load.weights)
              if (numbering.layout().is_owned(w.unknown))
                along += w.weight * motion(step, w.unknown);
            account.add_in_step(load.work_entry,
                                mean_value(load, step) * along);
            if (path.state_before() != nullptr)
              account.add_in_step(load.work_entry,
                                  work_of_path(load, step, path));
          }
      }

      void account_stage(const Evaluation &stage,
                         const EffectCache * /*results*/,
                         EnergyAccount &account) const override
      {
        for (const Load &load : loads)
          {
            double along = 0;
            for (const AppliedLoad::Weight &w : load.weights)
              if (numbering.layout().is_owned(w.unknown))
                along += w.weight * rotations.spatial_rate(stage.to, w.unknown);
            account.add_power(load.work_entry,
                              value_at_end(load.time_history, stage) * along);
          }
      }

    private:
      struct Load : AppliedLoad
      {
        Load(const AppliedLoad &load) : AppliedLoad(load)
        {}

        unsigned int work_entry = 0; ///< in the energy ledger
      };

      /** Value at the start of the step. */
      double value_before(const Load &load, const Evaluation &step) const
      {
        return raised_from_zero && step.from.time == 0
          ? 0.
          : value_at_start(load.time_history, step);
      }

      /** Correction of the work for a curved path, without moments on large
       * rotations in space (J). */
      double work_of_path(const Load       &load,
                          const Evaluation &step,
                          const PathWork   &path) const
      {
        const State::Before   &before = *path.state_before();
        PathWork::Values       displacement{};
        const PathWork::Values force{
          {load.time_history.value(before.time_of_loads),
           value_before(load, step),
           value_at_end(load.time_history, step)}};
        for (const AppliedLoad::Weight &w : load.weights)
          if (numbering.layout().is_owned(w.unknown) &&
              (step.to.rotations.empty() ||
               numbering.rotations().with(w.unknown) < 0))
            {
              displacement[0] += w.weight * before.displacement[w.unknown];
              displacement[1] += w.weight * step.from.displacement[w.unknown];
              displacement[2] += w.weight * step.to.displacement[w.unknown];
            }
        return path.beyond_mean(force, displacement);
      }

      /** Mean value over the step. */
      double mean_value(const Load &load, const Evaluation &step) const
      {
        return (value_before(load, step) +
                value_at_end(load.time_history, step)) /
          2;
      }

      /** Adds the loads of a discrete-gradient step, whose moments do the exact
       * work of the mean. */
      void add_mean_loads(const Evaluation &step, double *residual) const
      {
        const StepTravel travel(step, numbering);
        for (const Load &load : loads)
          {
            const double value = mean_value(load, step);
            for (const AppliedLoad::Weight &w : load.weights)
              residual[w.unknown] -=
                value * w.weight * travel.increment_per_travel(w.unknown);
          }
      }

      /** Increment of an unknown in the step, of rotations in the global frame.
       */
      double motion(const Evaluation &step, const int unknown) const
      {
        if (const int i = numbering.rotations().with(unknown);
            i >= 0 && !step.to.rotations.empty())
          return rotations
            .spatial_increment(step, i)[numbering.rotations().axis(unknown)];
        return step.to.displacement[unknown] - step.from.displacement[unknown];
      }

      const DofNumbering &numbering;
      const NodeRotations rotations;
      const bool          raised_from_zero;
      std::vector<Load>   loads;
    };
  } // namespace

  std::unique_ptr<Effect>
  make_applied_loads(const DofNumbering             &numbering,
                     const bool                      raised_from_zero,
                     const std::vector<AppliedLoad> &loads)
  {
    return std::make_unique<AppliedLoads>(numbering, raised_from_zero, loads);
  }

  namespace
  {
    /** Accounts the work of moved supports, whose forces are the residual. */
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
                        EffectCache * /*results*/) const override
      {}

      void account_step(const Evaluation &step,
                        const EffectCache * /*results*/,
                        EnergyAccount &account) const override
      {
        for (unsigned int s = 0; s < entries.size(); ++s)
          if (!model.supports[s].is_at_rest())
            account.add_in_step(entries[s], work(model.supports[s], step));
      }

      void account_stage(const Evaluation &stage,
                         const EffectCache * /*results*/,
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
      /** Work of impulses: their products with the mean of the velocities
       * before and after. */
      double impulse_work(const Support    &support,
                          const Evaluation &impact) const
      {
        const DofNumbering &numbering = model.numbering;
        const Vector       &before    = *impact.from.velocity,
                     &after           = *impact.to.velocity;
        double sum                    = 0;
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (const int i = prescribed.unknown;
              numbering.layout().is_owned(i) &&
              !support.moves_as_rotation(prescribed))
            sum += (*impact.impulses)[i] * (before[i] + after[i]) / 2;
        for (const Support::PrescribedRotation &prescribed : support.rotations)
          {
            const unsigned int        i     = prescribed.rotation;
            const std::array<int, 3> &spins = numbering.rotations()[i];
            const SpaceVector         mean = (spatial_velocity(impact.from, i) +
                                      spatial_velocity(impact.to, i)) /
              2;
            for (unsigned int c = 0; c < 3; ++c)
              if (prescribed.fixed[c] && numbering.layout().is_owned(spins[c]))
                sum += (*impact.impulses)[spins[c]] * mean[c];
          }
        return sum;
      }

      /** Work in a discrete-gradient step, whose residual is the mean force. */
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

      /** Work of the support in the step, by the mean of its forces. */
      double work(const Support &support, const Evaluation &step) const
      {
        if (step.impulses)
          return impulse_work(support, step);
        if (step.kind == Evaluation::Kind::discrete_gradient)
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
