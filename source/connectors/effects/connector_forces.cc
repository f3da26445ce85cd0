#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/connectors/effects/connector_lines.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Tensor = dealii::Tensor<2, 3>;

    /** Connector forces by the law of the group along its ConnectorLines. */
    class ConnectorGroupForces : public ConnectorForces
    {
    public:
      ConnectorGroupForces(const ConnectorDefinition &definition,
                           ConnectorLines             lines,
                           const Lattice             &lattice)
        : group_name(definition.name)
        , law(definition.law)
        , lines(std::move(lines))
        , connectors(this->lines.ends)
        , lattice(lattice)
      {
        for (unsigned int i = 0; i < connectors.size(); ++i)
          if (connectors[i].owned)
            owned.push_back(i);
      }

      bool is_linear() const override
      {
        return !lines.follow_ends && law->is_linear();
      }

      void register_in(StateLayout &layout) override
      {
        std::vector<unsigned int> numbers;
        numbers.reserve(connectors.size());
        for (const ConnectorEnds &ends : connectors)
          numbers.push_back(ends.number);
        if (law->n_history() > 0)
          {
            first_history =
              layout.history.keep(group_name + ": internal variables",
                                  numbers,
                                  law->n_history());
            layout.integrated.emplace_back(first_history,
                                           layout.history.n_values());
          }
        stored_entry = layout.energies.enter(stored_energy_entry());
        if (!law->is_viscous())
          return;
        layout.velocity = true;
        first_dissipated =
          layout.history.keep(group_name + ": dissipated energy",
                              numbers,
                              /*values_per_item=*/1);
        dissipated_entry = layout.energies.enter(
          {EnergyKind::dissipated,
           group_name + ".dissipated",
           "energy lost in the connectors since the start"});
        numerical_entry = layout.energies.enter(numerical_energy_entry());
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block =
          pattern.register_blocks(connectors, &ConnectorEnds::unknowns);
      }

      std::unique_ptr<EffectCache> make_results() const override
      {
        return std::make_unique<ConnectorResults>(connectors.size());
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache      *results) const override
      {
        auto &cache = static_cast<ConnectorResults &>(*results);
        lines.find_motion(evaluation, cache);
        find_response(evaluation, cache);
        for (unsigned int i = 0; i < connectors.size(); ++i)
          for (unsigned int c = 0; c < 3; ++c)
            {
              const double force =
                cache.response[i].force * cache.direction[i][c];
              if (connectors[i].unknowns[c] >= 0)
                residual[connectors[i].unknowns[c]] -= force;
              if (connectors[i].unknowns[3 + c] >= 0)
                residual[connectors[i].unknowns[3 + c]] += force;
            }
      }

      void add_tangent(const Evaluation     &evaluation,
                       const EffectCache    *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        if (factors.stiffness == 0 && factors.damping == 0)
          return;
        const ConnectorResults &cache = connector_cache(*results);
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          return add_mean_tangent(evaluation, cache, matrix);
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            const auto  &n = cache.direction[i];
            const double along =
              factors.stiffness * cache.response[i].stiffness +
              factors.damping * cache.response[i].damping;
            Tensor by_motion = dealii::outer_product(along * n, n);
            if (lines.follow_ends)
              {
                // The force and the rate change direction as the line rotates.
                const double rotating =
                  factors.stiffness / cache.current_length[i];
                by_motion +=
                  rotating * cache.response[i].force * normal_projector(n, n);
                if (evaluation.kind != Evaluation::Kind::static_step)
                  by_motion += dealii::outer_product(
                    rotating * cache.response[i].damping * n,
                    cache.velocity_difference[i] - cache.motion[i].rate * n);
              }
            add_block(i, by_motion, matrix);
          }
      }

      void add_geometric_tangent(const ForceChange &change,
                                 const unsigned int effect,
                                 TangentMatrix     &matrix) const override
      {
        if (!lines.follow_ends)
          return;
        const auto in = [effect](const EvaluationResults &results) {
          return &connector_cache(*results.effect_caches[effect]);
        };
        const ConnectorResults &now    = *in(change.at_state),
                               &before = *in(change.at_from),
                               &after  = *in(change.at_to);
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            const auto  &n     = now.direction[i];
            const double force = change.factor *
              (after.response[i].force - before.response[i].force);
            add_block(i,
                      force / now.current_length[i] * normal_projector(n, n),
                      matrix);
          }
      }

      void add_relaxation_times(const Unknowns      &unknowns,
                                std::vector<double> &times) const override
      {
        const std::map<double, double> relaxing = law->relaxing_stiffnesses();
        for (const unsigned int i : owned)
          {
            const auto &ends = connectors[i].unknowns;
            if (std::any_of(ends.begin(), ends.end(), [&](const int unknown) {
                  return unknown >= 0 &&
                    unknowns.kinds[unknown] != UnknownKind::prescribed;
                }))
              for (const auto &[time, stiffness] : relaxing)
                times.push_back(time);
          }
      }

      void add_relaxing_stiffness(const Evaluation & /*evaluation*/,
                                  const EffectCache *results,
                                  const double       time,
                                  TangentMatrix     &matrix) const override
      {
        const std::map<double, double> relaxing = law->relaxing_stiffnesses();
        if (const auto found = relaxing.find(time); found != relaxing.end())
          add_stiffness(found->second, *results, matrix);
      }

      void add_viscous_stiffness(const Evaluation & /*evaluation*/,
                                 const EffectCache         *results,
                                 const std::complex<double> s,
                                 TangentMatrix             &real,
                                 TangentMatrix &imaginary) const override
      {
        if (!law->is_viscous())
          return;
        const std::complex<double> stiffness =
          law->dynamic_stiffness(s) - law->long_time_stiffness();
        add_stiffness(stiffness.real(), *results, real);
        add_stiffness(stiffness.imag(), *results, imaginary);
      }

      void account(const Evaluation  &evaluation,
                   const EffectCache *results,
                   EnergyAccount     &account) const override
      {
        std::vector<double> rates(law->n_history());
        for (const unsigned int i : owned)
          account.add(
            stored_entry,
            continuous(i, evaluation.to, *results, rates.data()).stored);
      }

      void account_step(const Evaluation  &step,
                        const EffectCache *results,
                        EnergyAccount     &account) const override
      {
        if (!law->is_viscous())
          return;
        const ConnectorResults &cache = connector_cache(*results);
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            const std::size_t     at = first_history + i * law->n_history();
            const ConnectorEnergy energy =
              law->energy(cache.motion[i],
                          step.from.history.data() + at,
                          step.to.history.data() + at);
            step.to.history[first_dissipated + i] =
              step.from.history[first_dissipated + i] + energy.dissipated;
            if (!connectors[i].owned)
              continue;
            account.add_in_step(dissipated_entry, energy.dissipated);
            // The mean force of Kind::discrete_gradient does exactly this work.
            if (account.has_duration() &&
                step.kind != Evaluation::Kind::discrete_gradient)
              account.add_in_step(numerical_entry,
                                  numerical_work(i, step, cache, energy));
          }
      }

      void account_stage(const Evaluation  &stage,
                         const EffectCache *results,
                         EnergyAccount     &account) const override
      {
        if (!law->is_viscous())
          return;
        std::vector<double> rates(law->n_history());
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            const double power =
              continuous(i, stage.to, *results, rates.data()).lost_power;
            stage.to.history[first_dissipated + i] =
              stage.from.history[first_dissipated + i] + stage.weight * power;
            if (connectors[i].owned)
              account.add_power(dissipated_entry, power);
          }
      }

      StageNeeds stage_needs() const override
      {
        return law->is_viscous() ? StageNeeds::results : StageNeeds::state;
      }

      void find_internal_rates(const State       &state,
                               const EffectCache *results,
                               double            *rates) const override
      {
        if (law->n_history() > 0)
          for (unsigned int i = 0; i < connectors.size(); ++i)
            continuous(i,
                       state,
                       *results,
                       rates + first_history + i * law->n_history());
      }

      void row_force_bounds(const Evaluation & /*evaluation*/,
                            const EffectCache *results,
                            double            *forces) const override
      {
        const ConnectorResults &cache = connector_cache(*results);
        for (unsigned int i = 0; i < connectors.size(); ++i)
          for (const int unknown : connectors[i].unknowns)
            raise_bound(forces, unknown, std::abs(cache.response[i].force));
      }

      void roundoff_force_bounds(const Evaluation    &evaluation,
                                 const EffectCache   *results,
                                 const LargestMotion &largest,
                                 double              *forces) const override
      {
        const ConnectorResults &cache = connector_cache(*results);
        const double            rate  = evaluation.rates_are_differences()
                      ? largest.displacement / evaluation.dt
                      : largest.velocity;
        for (unsigned int i = 0; i < connectors.size(); ++i)
          for (const int unknown : connectors[i].unknowns)
            raise_bound(forces,
                        unknown,
                        cache.response[i].stiffness * largest.displacement +
                          cache.response[i].damping * rate);
      }

      std::string nonfinite_reason(const Evaluation  &evaluation,
                                   const EffectCache *results) const override
      {
        return lines.nonfinite_reason(group_name,
                                      evaluation.to.time,
                                      connector_cache(*results));
      }

      const std::string &name() const override
      {
        return group_name;
      }

      ShortestConnector shortest(const Evaluation  &step,
                                 const EffectCache &results,
                                 const double       least) const override
      {
        ShortestConnector shortest{least, invalid_index};
        if (!lines.follow_ends)
          return shortest;
        const ConnectorResults &cache = connector_cache(results);
        for (const unsigned int i : owned)
          {
            // A line that reverses has passed through zero length.
            const ConnectorEnds &ends    = connectors[i];
            const double         product = ends.line(step.from.displacement) *
              ends.line(step.to.displacement);
            const double length_ratio =
              product < 0 ? 0. : cache.current_length[i] / ends.rest_length;
            if (length_ratio < shortest.length_ratio)
              shortest = {length_ratio, ends.first_joint};
          }
        return shortest;
      }

      unsigned int n_reported() const override
      {
        return owned.size();
      }

      ConnectorReport report(const unsigned int i,
                             const State       &state,
                             const EffectCache *results) const override
      {
        const ConnectorResults &cache = connector_cache(*results);
        const unsigned int      c     = owned[i];
        const ConnectorEnds    &ends  = connectors[c];
        ConnectorReport         report;
        report.ends[0] = lattice.joints[ends.first_joint];
        report.ends[1] = report.ends[0] + ends.span;
        for (unsigned int k = 0; k < 6; ++k)
          if (ends.unknowns[k] >= 0)
            report.displacements[k / 3][k % 3] =
              state.displacement[ends.unknowns[k]];
        report.force     = cache.response[c].force;
        report.extension = cache.motion[c].extension;
        report.dissipated =
          law->is_viscous() ? state.history[first_dissipated + c] : 0.;
        report.cell = ends.cell;
        return report;
      }

    private:
      /** Evaluates the law of connector @p i in continuous form at @p state,
       * with @p results of its evaluation. */
      ContinuousResponse continuous(const unsigned int i,
                                    const State       &state,
                                    const EffectCache &results,
                                    double            *internal_rates) const
      {
        const ConnectorMotion &motion = connector_cache(results).motion[i];
        return law->continuous(motion.extension,
                               motion.rate,
                               state.history.data() + first_history +
                                 i * law->n_history(),
                               internal_rates);
      }

      /**
       * Computes forces and internal variables for the motion in @p results.
       */
      void find_response(const Evaluation &evaluation,
                         ConnectorResults &results) const
      {
        double *const internal = evaluation.to.history.data() + first_history;
        using Kind             = Evaluation::Kind;
        if (evaluation.kind != Kind::equilibrium)
          return std::invoke(evaluation.kind == Kind::discrete_gradient
                               ? &ConnectorLaw::evaluate_mean
                               : evaluation.kind == Kind::stage
                               ? &ConnectorLaw::evaluate_stage
                               : &ConnectorLaw::evaluate,
                             *law,
                             connectors.size(),
                             results.motion.data(),
                             evaluation.from.history.data() + first_history,
                             internal,
                             results.response.data());
        for (unsigned int i = 0; i < connectors.size(); ++i)
          results.response[i] = law->relaxed(results.motion[i].extension);
        std::fill_n(internal, connectors.size() * law->n_history(), 0.);
      }

      /**
       * Numerical work (J): trapezoidal work of the forces of connector @p i at
       * both ends of the step, minus stored and dissipated energy of @p energy.
       */
      double numerical_work(const unsigned int      i,
                            const Evaluation       &step,
                            const ConnectorResults &results,
                            const ConnectorEnergy  &energy) const
      {
        const double          extension = results.motion[i].previous_extension;
        const ConnectorMotion start     = {extension,
                                           lines.rate_at(connectors[i], step.from),
                                           extension,
                                           0};
        const double         *committed =
          step.from.history.data() + first_history + i * law->n_history();
        std::vector<double> internal(law->n_history());
        ConnectorResponse   before;
        law->evaluate(1, &start, committed, internal.data(), &before);
        const double stored_before =
          law->energy(start, committed, committed).stored;
        return (before.force + results.response[i].force) / 2 *
          (results.motion[i].extension - start.extension) -
          (energy.stored - stored_before) - energy.dissipated;
      }

      /** Adds the derivative of mean forces by the state at the end. */
      void add_mean_tangent(const Evaluation       &evaluation,
                            const ConnectorResults &results,
                            TangentMatrix          &matrix) const
      {
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            const ConnectorResponse   &response = results.response[i];
            const dealii::Tensor<1, 3> e        = results.direction[i];
            dealii::Tensor<1, 3>       now      = e;
            double                     rotating = 0;
            if (lines.follow_ends)
              {
                const ConnectorEnds &ends = connectors[i];
                now = ends.line(evaluation.to.displacement) /
                  results.current_length[i];
                const double length_before =
                  ends.line(evaluation.from.displacement).norm();
                rotating =
                  response.force / (length_before + results.current_length[i]);
              }
            add_block(i,
                      dealii::outer_product(response.stiffness * e, now) +
                        rotating * normal_projector(e, now),
                      matrix);
          }
      }

      /** Adds the stiffness @p k (N/m) along each connector. */
      void add_stiffness(const double       k,
                         const EffectCache &results,
                         TangentMatrix     &matrix) const
      {
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            const auto &n = connector_cache(results).direction[i];
            add_block(i, dealii::outer_product(k * n, n), matrix);
          }
      }

      /** Adds the derivative of the force on the second end of connector @p i
       * by the relative motion. */
      void add_block(const unsigned int i,
                     const Tensor      &by_motion,
                     TangentMatrix     &matrix) const
      {
        double block[36];
        for (unsigned int a = 0; a < 6; ++a)
          for (unsigned int b = 0; b < 6; ++b)
            block[6 * a + b] =
              ((a < 3) == (b < 3) ? 1 : -1) * by_motion[a % 3][b % 3];
        matrix.add(first_block + i, block);
      }

      const std::string                         group_name;
      const std::shared_ptr<const ConnectorLaw> law;
      const ConnectorLines                      lines;
      const std::vector<ConnectorEnds> &connectors; ///< ends of the lines
      const Lattice                    &lattice;
      std::vector<unsigned int>         owned;
      /** Positions in State::history. */
      std::size_t  first_history = 0, first_dissipated = 0;
      unsigned int stored_entry = 0, dissipated_entry = 0, numerical_entry = 0;
      std::size_t  first_block = 0;
    };
  } // namespace

  std::unique_ptr<ConnectorForces>
  make_connector_forces(const ConnectorDefinition    &definition,
                        const std::vector<JointPair> &pairs,
                        const Lattice                &lattice,
                        const DofNumbering           &numbering,
                        const bool                    large_rotation)
  {
    return std::make_unique<ConnectorGroupForces>(
      definition,
      ConnectorLines(definition, pairs, lattice, numbering, large_rotation),
      lattice);
  }
} // namespace auxfem
