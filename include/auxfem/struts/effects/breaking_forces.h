#ifndef auxfem_struts_effects_breaking_forces_h
#define auxfem_struts_effects_breaking_forces_h

#include <auxfem/struts/effects/broken_strut_drag.h>
#include <auxfem/struts/effects/damped_velocity.h>
#include <auxfem/struts/effects/law_forces.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace auxfem
{
  /** LawForces of struts that may break. A strut whose limit is passed at the
   * end of a step loses its forces in the following steps; its mass is dragged
   * along by its joints. */
  template <class Beam>
  class BreakingForces : public LawForces<Beam>
  {
    using Base = LawForces<Beam>;

  public:
    using Base::Base;

    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectCache      *results) const override
    {
      Base::add_residual(evaluation, residual, results);
      if (!evaluation.to.velocity || !has_broken(evaluation.from))
        return;
      const DampedVelocity velocity(evaluation);
      for_each_dragged(evaluation, [&](const unsigned int e, const double c) {
        drag.add_force(c, beams.unknowns(e), velocity.values(), residual);
      });
    }

    void add_tangent(const Evaluation     &evaluation,
                     const EffectCache    *results,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override
    {
      Base::add_tangent(evaluation, results, factors, matrix);
      if (factors.damping == 0 || !has_broken(evaluation.from))
        return;
      for_each_dragged(evaluation, [&](const unsigned int e, const double c) {
        double block[n * n] = {};
        drag.add_block(factors.damping * c, block);
        matrix.add(beams.group.begin + e, block);
      });
    }

    void register_in(StateLayout &layout) override
    {
      Base::register_in(layout);
      if (!layout.failures)
        {
          std::vector<unsigned int> all(beams.lattice.struts.size());
          std::iota(all.begin(), all.end(), 0u);
          layout.failures = FailureRecords{
            layout.history.keep("failures of struts",
                                all,
                                FailureRecords::values_per_strut)};
        }
      failures        = *layout.failures;
      fracture_entry  = layout.energies.enter(fracture_energy_entry());
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    void update_history(const Evaluation &solved) const override
    {
      Base::update_history(solved);
      const std::vector<double> &before = solved.from.history;
      std::vector<double>       &now    = solved.to.history;
      for (unsigned int e = 0; e < beams.size(); ++e)
        now[lost_part(e)] =
          responses.lost_part_after(before[lost_part(e)], solved.dt);
      std::copy_n(before.begin() + failures.first,
                  FailureRecords::values_per_strut *
                    beams.lattice.struts.size(),
                  now.begin() + failures.first);
    }

    void add_failures(const Evaluation          &solved,
                      std::vector<unsigned int> &struts) const override
    {
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && carries_load(e, solved.to))
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
      for (const unsigned int strut : struts)
        failures.set_time(strut, solved.to.time, now);
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (!(now[lost_part(e)] > 0) &&
            std::binary_search(struts.begin(),
                               struts.end(),
                               beams.interval(e).strut))
          now[lost_part(e)] = std::numeric_limits<double>::min();
    }

    void add_broken_struts(const State              &state,
                           std::vector<BrokenStrut> &broken) const override
    {
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && state.history[lost_part(e)] > 0 &&
            beams.interval(e).begin == 0)
          broken.push_back(
            {beams.interval(e).strut,
             *failures.time_of(state.history, beams.interval(e).strut)});
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
      Losses losses;
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned && step.from.history[lost_part(e)] > 0)
          {
            account_fracture(e, step, account.motion(), losses);
            if (step.to.velocity)
              account_drag(e, step, account.motion(), losses);
          }
      account.add_in_step(fracture_entry, losses.fracture);
      account.add_in_step(numerical_entry, losses.numerical);
    }

  protected:
    bool carries_load(const unsigned int e, const State &state) const override
    {
      return !(state.history[lost_part(e)] > 0);
    }

  private:
    using Base::beams;
    using Base::n;
    using Base::order;
    using Base::responses;

    /** Energies that broken struts lose in a step (J). */
    struct Losses
    {
      double fracture = 0, numerical = 0;
    };

    std::size_t lost_part(const unsigned int e) const
    {
      return responses.lost_parts() + e;
    }

    /** Whether a strut has begun to break. */
    bool has_broken(const State &state) const
    {
      const double *lost = state.history.data() + responses.lost_parts();
      return std::any_of(lost, lost + beams.size(), [](const double part) {
        return part > 0;
      });
    }

    /** Part of its forces that element @p e has lost @p dt (s) after @p state. */
    double lost_fraction(const unsigned int e,
                         const State       &state,
                         const double       dt) const
    {
      return 1 -
        lane_value(responses.intactness(state.history, this->batch_of(e), dt),
                   0);
    }

    /** Coefficient of the drag of element @p e when all its forces are lost
     * (N s/m): its nodes then follow its ends within about the time of failure.
     * Without inertia, 0. */
    double drag_coefficient(const unsigned int e) const
    {
      if (!responses.moves_by_inertia(e))
        return 0;
      const double mass = beams.section(e).mass_per_length() * beams[e].length *
        (beams.interval(e).end - beams.interval(e).begin);
      return 2 * order * mass / *responses.failure_time();
    }

    /** Calls @p action with each broken element and the coefficient of its drag
     * in an evaluation. */
    template <class Action>
    void for_each_dragged(const Evaluation &evaluation,
                          const Action     &action) const
    {
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (evaluation.from.history[lost_part(e)] > 0)
          {
            double lost = lost_fraction(e, evaluation.from, evaluation.dt);
            if (evaluation.kind == Evaluation::Kind::discrete_gradient)
              lost = (lost + lost_fraction(e, evaluation.from, 0)) / 2;
            action(e, lost * drag_coefficient(e));
          }
    }

    /** Adds the energy that the drag takes from element @p e: the work of the
     * mean velocity. That of the forces of both ends differs by a numerical
     * energy. */
    void account_drag(const unsigned int e,
                      const Evaluation  &step,
                      const StepMotion  &motion,
                      Losses            &losses) const
    {
      const double c      = motion.dt * drag_coefficient(e),
                   before = lost_fraction(e, step.from, 0),
                   now    = lost_fraction(e, step.to, 0);
      const auto power    = [&](const Vector &v, const Vector &w) {
        return drag.power(beams.unknowns(e), v.data(), w.data());
      };
      const double dissipated =
        c * (before + now) / 2 * power(motion.velocity, motion.velocity);
      losses.fracture += dissipated;
      if (step.kind != Evaluation::Kind::discrete_gradient)
        losses.numerical += c / 2 *
            (before * power(*step.from.velocity, motion.rate) +
             now * power(*step.to.velocity, motion.rate)) -
          dissipated;
    }

    /**
     * Adds the energy that element @p e loses because its stiffness falls in a
     * step: what the forces of both ends do beyond the growth of stored and
     * plastic energy. Mean forces lose the mean of the energies of both ends
     * that an intact strut would store, times the lost part.
     */
    void account_fracture(const unsigned int e,
                          const Evaluation  &step,
                          const StepMotion  &motion,
                          Losses            &losses) const
    {
      const ElementBatch batch   = this->batch_of(e);
      const auto         at_rest = beams.at_rest_in_all_lanes(e);
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
      const End start = at(step.from), end = at(step.to);
      if (step.kind == Evaluation::Kind::discrete_gradient)
        {
          losses.fracture +=
            (before - now) * (start.stored / before + end.stored / now) / 2;
          return;
        }
      const double plastic = step.to.history[this->lost_energies() + e] -
        step.from.history[this->lost_energies() + e];
      const double lost = motion.dt / 2 * (start.power + end.power) -
        (end.stored - start.stored) - plastic;
      // A loss is never negative.
      (lost > 0 ? losses.fracture : losses.numerical) += lost;
    }

    const BrokenStrutDrag drag{{beams.shape.node, beams.shape.node + order + 1},
                               Beam::n_components};
    unsigned int          fracture_entry = 0, numerical_entry = 0;
    FailureRecords        failures;
  };
} // namespace auxfem

#endif
