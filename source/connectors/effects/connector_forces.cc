#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/connectors/effects/connector_lines.h>
#include <auxfem/connectors/effects/law_group.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Tensor = dealii::Tensor<2, 3>;

    std::vector<unsigned int> numbers_of(const ConnectorLines &lines)
    {
      std::vector<unsigned int> numbers;
      for (const ConnectorEnds &ends : lines.ends)
        numbers.push_back(ends.number);
      return numbers;
    }

    std::vector<unsigned int> owned_ones(const ConnectorLines &lines)
    {
      std::vector<unsigned int> owned;
      for (unsigned int i = 0; i < lines.ends.size(); ++i)
        if (lines.ends[i].owned)
          owned.push_back(i);
      return owned;
    }

    /** Connector forces by the law of the group along its ConnectorLines. */
    class ConnectorGroupForces : public ConnectorForces
    {
    public:
      ConnectorGroupForces(const ConnectorDefinition &definition,
                           ConnectorLines             connector_lines,
                           const Lattice             &lattice)
        : lines(std::move(connector_lines))
        , connectors(lines.ends)
        , owned(owned_ones(lines))
        , group(definition.name,
                definition.law,
                definition.limits,
                numbers_of(lines),
                owned)
        , law(*group.law)
        , lattice(lattice)
      {}

      bool is_linear() const override
      {
        return !lines.follow_ends && group.is_linear();
      }

      void register_in(StateLayout &layout) override
      {
        group.register_in(layout, stored_energy_entry());
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
        group.evaluate(evaluation, cache.motion, cache.response);
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
        const bool              is_mean =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        for (unsigned int i = 0; i < connectors.size(); ++i)
          add_block(i,
                    is_mean ? lines.mean_tangent(i, evaluation, cache)
                            : lines.tangent(i, evaluation, factors, cache),
                    matrix);
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
        const std::map<double, double> relaxing = law.relaxing_stiffnesses();
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

      void add_relaxing_stiffness(const Evaluation  &evaluation,
                                  const EffectCache *results,
                                  const double       time,
                                  TangentMatrix     &matrix) const override
      {
        const std::map<double, double> relaxing = law.relaxing_stiffnesses();
        if (const auto found = relaxing.find(time); found != relaxing.end())
          for (unsigned int i = 0; i < connectors.size(); ++i)
            if (!group.is_broken(evaluation.from, i))
              add_stiffness(i,
                            found->second,
                            connector_cache(*results),
                            matrix);
      }

      void add_viscous_stiffness(const Evaluation          &evaluation,
                                 const EffectCache         *results,
                                 const std::complex<double> s,
                                 TangentMatrix             &real,
                                 TangentMatrix &imaginary) const override
      {
        if (!law.is_viscous())
          return;
        const ConnectorResults &cache = connector_cache(*results);
        for (unsigned int i = 0; i < connectors.size(); ++i)
          {
            if (group.is_broken(evaluation.from, i))
              continue;
            const std::complex<double> stiffness =
              law.dynamic_stiffness(s, cache.motion[i].extension) -
              cache.response[i].stiffness;
            add_stiffness(i, stiffness.real(), cache, real);
            add_stiffness(i, stiffness.imag(), cache, imaginary);
          }
      }

      void account(const Evaluation  &evaluation,
                   const EffectCache *results,
                   EnergyAccount     &account) const override
      {
        group.account(evaluation, connector_cache(*results).motion, account);
      }

      void update_history(const Evaluation &solved) const override
      {
        if (!group.may_break())
          return;
        ConnectorResults at_end(connectors.size());
        lines.find_motion(solved, at_end);
        group.update_history(solved, at_end.motion);
      }

      void account_step(const Evaluation  &step,
                        const EffectCache *results,
                        EnergyAccount     &account) const override
      {
        const ConnectorResults &cache = connector_cache(*results);
        group.account_step(
          step,
          cache.motion,
          cache.response,
          [&](const unsigned int i) {
            return lines.rate_at(connectors[i], step.from);
          },
          account);
      }

      void account_stage(const Evaluation  &stage,
                         const EffectCache *results,
                         EnergyAccount     &account) const override
      {
        group.account_stage(stage, connector_cache(*results).motion, account);
      }

      StageNeeds stage_needs() const override
      {
        return law.dissipates() ? StageNeeds::results : StageNeeds::state;
      }

      void find_internal_rates(const State       &state,
                               const EffectCache *results,
                               double            *rates) const override
      {
        group.find_internal_rates(state,
                                  connector_cache(*results).motion,
                                  rates);
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
                        std::abs(cache.response[i].stiffness) *
                            largest.displacement +
                          std::abs(cache.response[i].damping) * rate);
      }

      std::string nonfinite_reason(const Evaluation  &evaluation,
                                   const EffectCache *results) const override
      {
        return lines.nonfinite_reason(group.name,
                                      evaluation.to.time,
                                      connector_cache(*results));
      }

      const std::string &name() const override
      {
        return group.name;
      }

      ShortestConnector shortest(const Evaluation  &step,
                                 const EffectCache &results,
                                 const double       least) const override
      {
        return lines.shortest(step, connector_cache(results), least);
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
        report.force      = cache.response[c].force;
        report.extension  = cache.motion[c].extension;
        report.dissipated = group.dissipated(state, c);
        report.cell       = ends.cell;
        report.is_broken  = group.is_broken(state, c);
        return report;
      }

      bool may_break() const override
      {
        return group.may_break();
      }

    private:
      /** Adds the stiffness @p k (N/m) along connector @p i. */
      void add_stiffness(const unsigned int      i,
                         const double            k,
                         const ConnectorResults &results,
                         TangentMatrix          &matrix) const
      {
        const auto &n = results.direction[i];
        add_block(i, dealii::outer_product(k * n, n), matrix);
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

      const ConnectorLines              lines;
      const std::vector<ConnectorEnds> &connectors; ///< ends of the lines
      const std::vector<unsigned int>   owned;
      LawGroup                          group;
      const ConnectorLaw               &law; ///< that of the group
      const Lattice                    &lattice;
      std::size_t                       first_block = 0;
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
