#ifndef auxfem_struts_effects_breaking_forces_h
#define auxfem_struts_effects_breaking_forces_h

#include <auxfem/struts/effects/law_forces.h>

#include <limits>
#include <vector>

namespace auxfem
{
  /** LawForces of struts that may break. A strut whose limit is passed at the
   * end of a step loses its forces in the following steps. */
  template <class Beam>
  class BreakingForces : public LawForces<Beam>
  {
    using Base = LawForces<Beam>;

  public:
    using Base::Base;

    void register_in(StateLayout &layout) override
    {
      Base::register_in(layout);
      first_time =
        layout.history.keep(beams.record_name() + ": time of failure (s)",
                            beams.numbers_in_lattice(),
                            /*values_per_item=*/1);
      fracture_entry  = layout.energies.enter(fracture_energy_entry());
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    void update_history(const Evaluation &solved) const override
    {
      Base::update_history(solved);
      const std::vector<double> &before = solved.from.history;
      std::vector<double>       &now    = solved.to.history;
      for (unsigned int e = 0; e < beams.size(); ++e)
        {
          now[lost_part(e)] =
            responses.lost_part_after(before[lost_part(e)], solved.dt);
          now[first_time + e] = before[first_time + e];
        }
    }

    void add_failures(const Evaluation          &solved,
                      std::vector<unsigned int> &struts) const override
    {
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && !(solved.to.history[lost_part(e)] > 0))
          for (const SectionYielding &point : this->yielding_in(e, solved.to))
            if (lane_value(point.failure, 0) >= 1)
              {
                struts.push_back(beams.interval(e).strut);
                break;
              }
    }

    void break_struts(const std::vector<unsigned int> &struts,
                      const Evaluation                &solved) const override
    {
      std::vector<double> &now = solved.to.history;
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (!(now[lost_part(e)] > 0) &&
            std::binary_search(struts.begin(),
                               struts.end(),
                               beams.interval(e).strut))
          {
            now[lost_part(e)]   = std::numeric_limits<double>::min();
            now[first_time + e] = solved.to.time;
          }
    }

    void add_broken_struts(const State              &state,
                           std::vector<BrokenStrut> &broken) const override
    {
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && state.history[lost_part(e)] > 0 &&
            beams.interval(e).begin == 0)
          broken.push_back(
            {beams.interval(e).strut, state.history[first_time + e]});
    }

    std::vector<StrutPoint> sample(const State       &state,
                                   const unsigned int element,
                                   const unsigned int n_points) const override
    {
      std::vector<StrutPoint> points = Base::sample(state, element, n_points);
      const ElementBatch batch = this->batch_of(element - beams.group.begin);
      for (StrutPoint &point : points)
        point.intactness =
          lane_value(responses.intactness(state.history, batch, 0), 0);
      return points;
    }

    void account_step(const Evaluation  &step,
                      const EffectCache *results,
                      EnergyAccount     &account) const override
    {
      Base::account_step(step, results, account);
      if (!account.has_duration())
        return;
      double fracture = 0, numerical = 0;
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && step.from.history[lost_part(e)] > 0)
          account_fracture(e, step, account.motion(), fracture, numerical);
      account.add_in_step(fracture_entry, fracture);
      account.add_in_step(numerical_entry, numerical);
    }

  private:
    using Base::beams;
    using Base::n;
    using Base::responses;

    std::size_t lost_part(const unsigned int e) const
    {
      return responses.lost_parts() + e;
    }

    /**
     * Adds the energy that element @p e loses because its stiffness falls in a
     * step: the mean of the energies of both ends that an intact strut would
     * store, times the lost part. Mean forces do exactly this work; that of the
     * forces of both ends exceeds it by a numerical energy.
     */
    void account_fracture(const unsigned int e,
                          const Evaluation  &step,
                          const StepMotion  &motion,
                          double            &fracture,
                          double            &numerical) const
    {
      const ElementBatch batch   = this->batch_of(e);
      const auto        &at_rest = beams.at_rest(batch);
      struct End
      {
        double stored, power;
      };
      const auto at = [&](const State &state) {
        Lanes       force[n];
        const Lanes stored = this->integrate(
          batch,
          at_rest,
          state,
          [](const SectionInstant &now, SectionResponse &r) {
            std::copy_n(now.forces, Beam::n_strains, r.forces);
            r.stored = now.stored;
          },
          force);
        return End{lane_value(stored, 0),
                   lane_value(Beam::power(beams.numbering,
                                          beams.unknowns(batch),
                                          state,
                                          motion.rate,
                                          force),
                              0)};
      };
      const auto intact = [&](const State &state) {
        return lane_value(responses.intactness(state.history, batch, 0), 0);
      };
      const double before = intact(step.from), now = intact(step.to);
      if (before == now)
        return;
      const End    start = at(step.from), end = at(step.to);
      const double lost =
        (before - now) * (start.stored / before + end.stored / now) / 2;
      fracture += lost;
      if (step.kind == Evaluation::Kind::discrete_gradient)
        return;
      const double plastic = step.to.history[this->lost_energies() + e] -
        step.from.history[this->lost_energies() + e];
      numerical += motion.dt / 2 * (start.power + end.power) -
        (end.stored - start.stored) - plastic - lost;
    }

    unsigned int fracture_entry = 0, numerical_entry = 0;
    std::size_t  first_time = 0; ///< in State::history
  };
} // namespace auxfem

#endif
