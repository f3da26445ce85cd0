#include <auxfem/connectors/effects/law_group.h>

#include <cmath>

namespace auxfem
{
  LawGroup::LawGroup(const std::string                  &name,
                     std::shared_ptr<const ConnectorLaw> law,
                     const ConnectorLimits              &limits,
                     const std::vector<unsigned int>    &numbers,
                     const std::vector<unsigned int>    &owned)
    : name(name)
    , law(std::move(law))
    , limits(limits)
    , numbers(numbers)
    , owned(owned)
    , is_owned(numbers.size(), false)
  {
    for (const unsigned int i : owned)
      is_owned[i] = true;
  }

  void LawGroup::register_in(StateLayout &layout, const EnergyEntry &stored)
  {
    if (law->n_history() > 0)
      {
        first_history = layout.history.keep(name + ": internal variables",
                                            numbers,
                                            law->n_history());
        if (!law->slips())
          layout.integrated.emplace_back(first_history,
                                         layout.history.n_values());
      }
    stored_entry = layout.energies.enter(stored);
    if (may_break())
      {
        first_broken    = layout.history.keep(name + ": broken",
                                           numbers,
                                           /*values_per_item=*/1);
        fracture_entry  = layout.energies.enter(fracture_energy_entry());
        numerical_entry = layout.energies.enter(numerical_energy_entry());
      }
    if (!law->dissipates())
      return;
    layout.velocity  = layout.velocity || law->is_viscous();
    first_dissipated = layout.history.keep(name + ": dissipated energy",
                                           numbers,
                                           /*values_per_item=*/1);
    dissipated_entry =
      layout.energies.enter({EnergyKind::dissipated,
                             name + ".dissipated",
                             "energy lost in the connectors since the start"});
    numerical_entry = layout.energies.enter(numerical_energy_entry());
  }

  void LawGroup::evaluate(const Evaluation                   &evaluation,
                          const std::vector<ConnectorMotion> &motion,
                          std::vector<ConnectorResponse>     &response) const
  {
    using Kind = Evaluation::Kind;
    std::invoke(evaluation.kind == Kind::discrete_gradient
                  ? &ConnectorLaw::evaluate_mean
                  : evaluation.kind == Kind::stage
                  ? &ConnectorLaw::evaluate_stage
                  : evaluation.kind == Kind::equilibrium
                  ? &ConnectorLaw::evaluate_relaxed
                  : &ConnectorLaw::evaluate,
                *law,
                motion.size(),
                motion.data(),
                evaluation.from.history.data() + first_history,
                evaluation.to.history.data() + first_history,
                response.data());
    for (unsigned int i = 0; may_break() && i < motion.size(); ++i)
      if (is_broken(evaluation.from, i))
        response[i] = {0, 0, 0};
  }

  void LawGroup::account(const Evaluation                   &evaluation,
                         const std::vector<ConnectorMotion> &motion,
                         EnergyAccount                      &account) const
  {
    std::vector<double> rates(law->n_history());
    for (const unsigned int i : owned)
      if (!is_broken(evaluation.to, i))
        account.add(
          stored_entry,
          continuous(i, evaluation.to, motion[i], rates.data()).stored);
  }

  void
  LawGroup::update_history(const Evaluation                   &solved,
                           const std::vector<ConnectorMotion> &motion) const
  {
    std::vector<double> rates(law->n_history());
    for (unsigned int i = 0; i < motion.size(); ++i)
      {
        // The response may hold the mean force of the step.
        const double force =
          continuous(i, solved.to, motion[i], rates.data()).force;
        const bool exceeds =
          (limits.force && std::abs(force) > *limits.force) ||
          (limits.extension && motion[i].extension > *limits.extension);
        solved.to.history[first_broken + i] = is_broken(solved.from, i) ? broken
          : exceeds ? breaks_now
                    : intact;
      }
  }

  void
  LawGroup::account_step(const Evaluation                          &step,
                         const std::vector<ConnectorMotion>        &motion,
                         const std::vector<ConnectorResponse>      &response,
                         const std::function<double(unsigned int)> &rate_before,
                         EnergyAccount &account) const
  {
    if (!law->dissipates() && !may_break())
      return;
    for (unsigned int i = 0; i < motion.size(); ++i)
      {
        const ConnectorEnergy energy = energy_at_end(i, step, motion[i]);
        if (law->dissipates())
          step.to.history[first_dissipated + i] =
            step.from.history[first_dissipated + i] + energy.dissipated;
        if (!is_owned[i])
          continue;
        if (law->dissipates())
          account.add_in_step(dissipated_entry, energy.dissipated);
        if (breaks(step.to, i))
          account.add_in_step(fracture_entry, energy.stored);
        // The mean force of Kind::discrete_gradient does exactly this work.
        if (account.has_duration() &&
            step.kind != Evaluation::Kind::discrete_gradient &&
            (law->dissipates() || breaks(step.from, i)))
          account.add_in_step(numerical_entry,
                              numerical_work(i,
                                             step,
                                             motion[i],
                                             response[i],
                                             law->is_viscous() ? rate_before(i)
                                                               : 0.,
                                             energy));
      }
  }

  void LawGroup::account_stage(const Evaluation                   &stage,
                               const std::vector<ConnectorMotion> &motion,
                               EnergyAccount &account) const
  {
    if (!law->dissipates())
      return;
    std::vector<double> rates(law->n_history());
    for (unsigned int i = 0; i < motion.size(); ++i)
      {
        const double power =
          continuous(i, stage.to, motion[i], rates.data()).lost_power;
        stage.to.history[first_dissipated + i] =
          stage.from.history[first_dissipated + i] + stage.weight * power;
        if (is_owned[i])
          account.add_power(dissipated_entry, power);
      }
  }

  void LawGroup::find_internal_rates(const State                        &state,
                                     const std::vector<ConnectorMotion> &motion,
                                     double *rates) const
  {
    if (law->n_history() > 0)
      for (unsigned int i = 0; i < motion.size(); ++i)
        continuous(i,
                   state,
                   motion[i],
                   rates + first_history + i * law->n_history());
  }

  ContinuousResponse LawGroup::continuous(const unsigned int     i,
                                          const State           &state,
                                          const ConnectorMotion &motion,
                                          double *internal_rates) const
  {
    return law->continuous(motion.extension,
                           motion.rate,
                           state.history.data() + first_history +
                             i * law->n_history(),
                           internal_rates);
  }

  ConnectorEnergy LawGroup::energy_at_end(const unsigned int     i,
                                          const Evaluation      &step,
                                          const ConnectorMotion &motion) const
  {
    if (is_broken(step.from, i))
      return {0, 0};
    const std::size_t at = first_history + i * law->n_history();
    return law->energy(motion,
                       step.from.history.data() + at,
                       step.to.history.data() + at);
  }

  double LawGroup::numerical_work(const unsigned int       i,
                                  const Evaluation        &step,
                                  const ConnectorMotion   &motion,
                                  const ConnectorResponse &response,
                                  const double             rate_before,
                                  const ConnectorEnergy   &energy) const
  {
    const double          extension = motion.previous_extension;
    const ConnectorMotion start     = {extension, rate_before, extension, 0};
    const double         *committed =
      step.from.history.data() + first_history + i * law->n_history();
    std::vector<double> internal(law->n_history());
    ConnectorResponse   before{0, 0, 0};
    double              stored_before = 0;
    if (!is_broken(step.from, i) || breaks(step.from, i))
      law->evaluate(1, &start, committed, internal.data(), &before);
    if (!is_broken(step.from, i))
      stored_before = law->energy(start, committed, committed).stored;
    return (before.force + response.force) / 2 *
      (motion.extension - extension) -
      (energy.stored - stored_before) - energy.dissipated;
  }
} // namespace auxfem
