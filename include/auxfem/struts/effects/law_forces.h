#ifndef auxfem_struts_effects_law_forces_h
#define auxfem_struts_effects_law_forces_h

#include <auxfem/struts/effects/law_reports.h>

#include <algorithm>

namespace auxfem
{
  /**
   * Internal forces of struts whose sections have a SectionLaw. Adds to
   * LawReports what relaxing and yielding need: history, losses, the equations
   * of internal variables for Runge-Kutta schemes, and the complex stiffness of
   * small motions. @p Beam is undamped.
   */
  template <class Beam>
  class LawForces : public LawReports<Beam>
  {
    using Base = LawReports<Beam>;

  public:
    using Base::Base;

    void register_in(StateLayout &layout) override
    {
      Base::register_in(layout);
      responses.register_in(layout);
      layout.mean_work = true;
      enter_initial_strains(layout);
      if (!responses.law().loses_energy())
        return;
      first_lost = layout.history.keep(beams.record_name() + ": lost energy",
                                       beams.numbers_in_lattice(),
                                       /*values_per_item=*/1);
      lost_entry = layout.energies.enter(responses.law().yields()
                                           ? plastic_energy_entry()
                                           : relaxation_energy_entry());
      if (!responses.finds_history_after_step())
        numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    std::vector<StrutPoint> sample(const State       &state,
                                   const unsigned int element,
                                   const unsigned int n_points) const override
    {
      std::vector<StrutPoint> points = Base::sample(state, element, n_points);
      if (!responses.law().loses_energy())
        return points;
      const unsigned int                       e = element - beams.group.begin;
      const std::array<SectionYielding, order> yielding =
        this->yielding_in(e, state);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          // Interpolation would give negative values beside plastic hinges.
          const unsigned int g = nearest_point(-1 + 2. * i / (n_points - 1));
          points[i].plastic_strain = lane_value(yielding[g].plastic_strain, 0);
          points[i].utilisation    = lane_value(yielding[g].utilisation, 0);
          const double modulus     = beams.section(e).youngs_modulus;
          points[i].fibre_stress =
            modulus * lane_value(yielding[g].fibre_stress, 0);
          points[i].equivalent_stress =
            modulus * lane_value(yielding[g].equivalent_stress, 0);
          points[i].dissipated_density =
            state.history[first_lost + e] / (2 * beams.at_rest(e).jacobian);
        }
      return points;
    }

    void update_history(const Evaluation &solved) const override
    {
      if (!responses.finds_history_after_step())
        return;
      const auto section = responses.in(solved, SectionPurpose::history);
      beams.for_each_batch([&](const ElementBatch &batch) {
        const auto &at_rest = beams.at_rest(batch);
        Lanes       force[n];
        Beam::internal_force(beams.shape,
                             at_rest,
                             section(batch, at_rest),
                             Beam::motion(beams.numbering,
                                          beams.unknowns(batch),
                                          solved.to),
                             force);
      });
    }

    void account_step(const Evaluation  &step,
                      const EffectCache *results,
                      EnergyAccount     &account) const override
    {
      Base::account_step(step, results, account);
      account_initial_strains(step, account);
      if (!account.has_duration() || !responses.law().loses_energy())
        return;
      const auto   losses = responses.law().losses(responses.step(step));
      const double lost =
        lose(step, 1, [&](const ElementBatch &batch, const auto &at_rest) {
          return responses.lost(*losses, step, batch, at_rest);
        });
      account.add_in_step(lost_entry, lost);
      // Mean forces do exactly the work of stored and lost energy.
      if (step.kind != Evaluation::Kind::discrete_gradient &&
          !responses.finds_history_after_step())
        account.add_in_step(numerical_entry,
                            work_of_relaxing_forces(step, account.motion()) -
                              lost);
    }

    void account_stage(const Evaluation &stage,
                       const EffectCache * /*results*/,
                       EnergyAccount &account) const override
    {
      const GroupInitialStrains &initial = responses.initial_strains();
      if (initial.exist())
        {
          const InitialStrainLoads rates = initial.rates(stage);
          for (unsigned int i = 0; i < initial.n_loads(); ++i)
            account.add_power(initial_entries[i],
                              -rates[i] * force_along(i, stage.to));
        }
      if (!responses.law().loses_energy())
        return;
      const double power =
        lose(stage,
             stage.weight,
             [&](const ElementBatch &batch, const auto &at_rest) {
               Lanes force[n];
               return this->integrate(
                 batch,
                 at_rest,
                 stage.to,
                 [](const SectionInstant &now, SectionResponse &r) {
                   r.stored = now.lost_power;
                 },
                 force);
             });
      account.add_power(lost_entry, power);
    }

    void add_load_derivative(const Evaluation &evaluation,
                             double           *derivative) const override
    {
      const GroupInitialStrains &initial = responses.initial_strains();
      if (!initial.exist())
        return;
      const InitialStrainLoads rates = initial.rates(evaluation);
      beams.for_each_batch([&](const ElementBatch &batch) {
        const auto &at_rest   = beams.at_rest(batch);
        const auto  stiffness = Beam::stiffness_by_strain(at_rest);
        Lanes       strains[Beam::n_strains] = {}, force[n];
        initial.add(1, rates, batch, strains);
        this->integrate(
          batch,
          at_rest,
          evaluation.to,
          [&](const SectionInstant &, SectionResponse &r) {
            for (unsigned int k = 0; k < Beam::n_strains; ++k)
              r.forces[k] = -stiffness[k] * strains[k] *
                responses.law().long_time_ratio(
                  Beam::strain_type(k, beams.shear > 0));
          },
          force);
        for (unsigned int lane = 0; lane < batch.size; ++lane)
          for (int i = 0; i < n; ++i)
            derivative[beams.unknowns(batch.elements[lane])[i]] +=
              lane_value(force[i], lane);
      });
    }

    void find_internal_rates(const State &state,
                             const EffectCache * /*results*/,
                             double *rates) const override
    {
      beams.for_each_batch([&](const ElementBatch &batch) {
        const auto &at_rest = beams.at_rest(batch);
        Lanes       force[n];
        this->integrate(
          batch,
          at_rest,
          state,
          [](const SectionInstant &, SectionResponse &) {},
          force,
          rates);
      });
    }

    void add_viscous_stiffness(const Evaluation &evaluation,
                               const EffectCache * /*results*/,
                               const std::complex<double> s,
                               TangentMatrix             &real,
                               TangentMatrix &imaginary) const override
    {
      const auto ratio = [&](const StrainType type) {
        std::complex<double> sum = 0;
        for (const auto &[time, part] : responses.law().relaxing_ratios(type))
          sum += part * s * time / (1. + s * time);
        return sum;
      };
      const std::complex<double> normal = ratio(StrainType::normal),
                                 shear  = ratio(StrainType::shear);
      add_material_tangent(evaluation, normal.real(), shear.real(), real);
      add_material_tangent(evaluation, normal.imag(), shear.imag(), imaginary);
    }

    void add_relaxation_times(const Unknowns      &unknowns,
                              std::vector<double> &times) const override
    {
      for (unsigned int e = 0; e < beams.size(); ++e)
        if (beams[e].owned &&
            std::any_of(beams.unknowns(e),
                        beams.unknowns(e) + n,
                        [&](const int unknown) {
                          return unknowns.kinds[unknown] !=
                            UnknownKind::prescribed;
                        }))
          {
            for (const StrainType type :
                 {StrainType::normal, StrainType::shear})
              for (const auto &[time, part] :
                   responses.law().relaxing_ratios(type))
                times.push_back(time);
            // All elements of the group have the same.
            return;
          }
    }

    void add_relaxing_stiffness(const Evaluation &evaluation,
                                const EffectCache * /*results*/,
                                const double   time,
                                TangentMatrix &matrix) const override
    {
      const auto part = [&](const StrainType type) {
        const std::map<double, double> ratios =
          responses.law().relaxing_ratios(type);
        const auto found = ratios.find(time);
        return found == ratios.end() ? 0. : found->second;
      };
      add_material_tangent(evaluation,
                           part(StrainType::normal),
                           part(StrainType::shear),
                           matrix);
    }

  protected:
    using Base::beams;
    using Base::n;
    using Base::order;
    using Base::responses;

    /** Position in State::history of the energies that elements have lost
     * (J). */
    std::size_t lost_energies() const
    {
      return first_lost;
    }

    /**
     * Sum of @p value_of as of sum_over_owned(); adds the values of all
     * elements, times @p factor, to the energies (J) that they have lost.
     */
    template <class ValueOfBatch>
    double lose(const Evaluation   &evaluation,
                const double        factor,
                const ValueOfBatch &value_of) const
    {
      const double *before = evaluation.from.history.data() + first_lost;
      double       *now    = evaluation.to.history.data() + first_lost;
      return this->sum_over_owned(
        [&](const ElementBatch &batch, const auto &at_rest) {
          const Lanes values = value_of(batch, at_rest);
          for (unsigned int lane = 0; lane < batch.size; ++lane)
            {
              const unsigned int e = batch.elements[lane];
              now[e] = before[e] + factor * lane_value(values, lane);
            }
          return values;
        });
    }

  private:
    void enter_initial_strains(StateLayout &layout)
    {
      const GroupInitialStrains &initial = responses.initial_strains();
      for (unsigned int i = 0; i < initial.n_loads(); ++i)
        initial_entries.push_back(
          layout.energies.enter({EnergyKind::work,
                                 initial.load(i).name + ".load_work",
                                 "work of the load since the start"}));
    }

    /** Adds the work of initial strains that change: minus the mean forces of
     * both ends times the change. */
    void account_initial_strains(const Evaluation &step,
                                 EnergyAccount    &account) const
    {
      const GroupInitialStrains &initial = responses.initial_strains();
      if (!initial.exist())
        return;
      const InitialStrainLoads start = initial.at_start(step),
                               end   = initial.at_end(step);
      for (unsigned int i = 0; i < initial.n_loads(); ++i)
        if (start[i] != end[i])
          account.add_in_step(initial_entries[i],
                              (start[i] - end[i]) / 2 *
                                (force_along(i, step.from) +
                                 force_along(i, step.to)));
    }

    /** Section forces along the strain by a unit of initial load @p i,
     * integrated over the elements owned by this rank. */
    double force_along(const unsigned int i, const State &state) const
    {
      return this->sum_over_owned(
        [&](const ElementBatch &batch, const auto &at_rest) {
          Lanes unit[Beam::n_strains] = {}, force[n];
          responses.initial_strains().add_one(i, 1., batch, unit);
          return this->integrate(
            batch,
            at_rest,
            state,
            [&](const SectionInstant &now, SectionResponse &r) {
              r.stored = 0;
              for (unsigned int k = 0; k < Beam::n_strains; ++k)
                r.stored += now.forces[k] * unit[k];
            },
            force);
        });
    }

    /** Gauss point nearest to @p xi in [-1, 1]. */
    unsigned int nearest_point(const double xi) const
    {
      const double *const points = beams.shape.point;
      return std::min_element(points,
                              points + order,
                              [xi](const double one, const double other) {
                                return std::abs(one - xi) <
                                  std::abs(other - xi);
                              }) -
        points;
    }

    /** Work of the mean relaxing forces of both ends of a step minus the growth
     * of the energy they store (J). */
    double work_of_relaxing_forces(const Evaluation &step,
                                   const StepMotion &motion) const
    {
      const auto relaxing = [](const SectionInstant &now, SectionResponse &r) {
        std::copy_n(now.relaxing, Beam::n_strains, r.forces);
        r.stored = now.relaxing_stored;
      };
      return this->sum_over_owned(
        [&](const ElementBatch &batch, const auto &at_rest) {
          const auto at = [&](const State &state, const double sign) {
            Lanes       force[n];
            const Lanes stored =
              this->integrate(batch, at_rest, state, relaxing, force);
            return Lanes(motion.dt / 2 *
                           Beam::power(beams.numbering,
                                       beams.unknowns(batch),
                                       state,
                                       motion.rate,
                                       force) -
                         sign * stored);
          };
          return Lanes(at(step.from, -1) + at(step.to, 1));
        });
    }

    /** Sections without force, with a given tangent stiffness. */
    template <class Stiffness>
    struct TangentSection
    {
      const Stiffness stiffness;

      template <class Strains>
      auto linearized(const int /*g*/, const Strains & /*strains*/) const
      {
        return Beam::without_forces(stiffness);
      }
    };

    /** Adds the tangent of the elastic stiffness times @p normal and @p shear at
     * the end of @p evaluation, without geometric part. */
    void add_material_tangent(const Evaluation &evaluation,
                              const double      normal,
                              const double      shear,
                              TangentMatrix    &matrix) const
    {
      const auto factor = [&](const unsigned int strain) {
        return Beam::strain_type(strain, beams.shear > 0) == StrainType::normal
          ? normal
          : shear;
      };
      this->add_tangent_at_end(
        evaluation,
        {1, 0, 0},
        [&](const ElementBatch & /*batch*/, const auto &at_rest) {
          const auto stiffness = Beam::scaled_stiffness(at_rest, factor);
          return TangentSection<std::decay_t<decltype(stiffness)>>{stiffness};
        },
        matrix);
    }

    /** Ledger entries of the work of initial strains, by load of the group. */
    std::vector<unsigned int> initial_entries;
    unsigned int              lost_entry = 0, numerical_entry = 0;
    std::size_t               first_lost = 0; ///< in State::history
  };
} // namespace auxfem

#endif
