#include <auxfem/connectors/effects/law_group.h>
#include <auxfem/joints/effects/rotational_springs.h>
#include <auxfem/time/schemes/static.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    struct RotationalLawResults : public EffectCache
    {
      explicit RotationalLawResults(const unsigned int n)
        : motion(n)
        , response(n)
      {}

      std::vector<ConnectorMotion>   motion;   ///< rad, rad/s
      std::vector<ConnectorResponse> response; ///< N m
    };

    const RotationalLawResults &law_results(const EffectCache *results)
    {
      return static_cast<const RotationalLawResults &>(*results);
    }

    /** Springs of one law between two rotations in the plane. */
    class RotationalLaws : public Effect,
                           public StageTerms,
                           public SmallMotionTerms
    {
    public:
      RotationalLaws(std::vector<RotationalSpring> springs, LawGroup group)
        : springs(std::move(springs))
        , group(std::move(group))
        , law(*this->group.law)
      {}

      bool is_linear() const override
      {
        return group.is_linear();
      }

      void register_in(StateLayout &layout) override
      {
        group.register_in(layout, strain_energy_entry());
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block =
          pattern.register_blocks(springs, &RotationalSpring::unknowns);
      }

      std::unique_ptr<EffectCache> make_results() const override
      {
        return std::make_unique<RotationalLawResults>(springs.size());
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache      *results) const override
      {
        auto &cache = static_cast<RotationalLawResults &>(*results);
        for (unsigned int i = 0; i < springs.size(); ++i)
          cache.motion[i] = motion_of(springs[i].unknowns, evaluation);
        group.evaluate(evaluation, cache.motion, cache.response);
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const auto [base, end] = springs[i].unknowns;
            double moment          = cache.response[i].force;
            if (evaluation.kind == Evaluation::Kind::discrete_gradient)
              moment *= mean_moment_factor(springs[i].unknowns, evaluation);
            if (base >= 0)
              residual[base] -= moment;
            residual[end] += moment;
          }
      }

      void add_tangent(const Evaluation     &evaluation,
                       const EffectCache    *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        // The factor of mean moments is nearly one.
        const bool is_mean =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const ConnectorResponse &response =
              law_results(results).response[i];
            add_block(i,
                      is_mean ? response.stiffness
                              : factors.stiffness * response.stiffness +
                          factors.damping * response.damping,
                      matrix);
          }
      }

      void add_relaxation_times(const Unknowns      &unknowns,
                                std::vector<double> &times) const override
      {
        for (const RotationalSpring &spring : springs)
          if (unknowns.layout.is_owned(spring.unknowns[1]))
            for (const auto &[time, stiffness] : law.relaxing_stiffnesses())
              times.push_back(time);
      }

      void add_relaxing_stiffness(const Evaluation & /*evaluation*/,
                                  const EffectCache * /*results*/,
                                  const double   time,
                                  TangentMatrix &matrix) const override
      {
        const std::map<double, double> relaxing = law.relaxing_stiffnesses();
        if (const auto found = relaxing.find(time); found != relaxing.end())
          for (unsigned int i = 0; i < springs.size(); ++i)
            add_block(i, found->second, matrix);
      }

      void add_viscous_stiffness(const Evaluation & /*evaluation*/,
                                 const EffectCache         *results,
                                 const std::complex<double> s,
                                 TangentMatrix             &real,
                                 TangentMatrix &imaginary) const override
      {
        if (!law.is_viscous())
          return;
        const RotationalLawResults &cache = law_results(results);
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const std::complex<double> stiffness =
              law.dynamic_stiffness(s, cache.motion[i].extension) -
              cache.response[i].stiffness;
            add_block(i, stiffness.real(), real);
            add_block(i, stiffness.imag(), imaginary);
          }
      }

      void account(const Evaluation  &evaluation,
                   const EffectCache *results,
                   EnergyAccount     &account) const override
      {
        group.account(evaluation, law_results(results).motion, account);
      }

      void account_step(const Evaluation  &step,
                        const EffectCache *results,
                        EnergyAccount     &account) const override
      {
        const RotationalLawResults &cache = law_results(results);
        group.account_step(
          step,
          cache.motion,
          cache.response,
          [&](const unsigned int i) {
            return difference(springs[i].unknowns, *step.from.velocity);
          },
          account);
      }

      void account_stage(const Evaluation  &stage,
                         const EffectCache *results,
                         EnergyAccount     &account) const override
      {
        group.account_stage(stage, law_results(results).motion, account);
      }

      StageNeeds stage_needs() const override
      {
        return law.dissipates() ? StageNeeds::results : StageNeeds::state;
      }

      void find_internal_rates(const State       &state,
                               const EffectCache *results,
                               double            *rates) const override
      {
        group.find_internal_rates(state, law_results(results).motion, rates);
      }

      void row_force_bounds(const Evaluation & /*evaluation*/,
                            const EffectCache *results,
                            double            *forces) const override
      {
        for (unsigned int i = 0; i < springs.size(); ++i)
          for (const int unknown : springs[i].unknowns)
            raise_bound(forces,
                        unknown,
                        std::abs(law_results(results).response[i].force));
      }

      void roundoff_force_bounds(const Evaluation    &evaluation,
                                 const EffectCache   *results,
                                 const LargestMotion &largest,
                                 double              *forces) const override
      {
        const double rate = evaluation.rates_are_differences()
          ? largest.rotation / evaluation.dt
          : largest.spin;
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const ConnectorResponse &response =
              law_results(results).response[i];
            for (const int unknown : springs[i].unknowns)
              raise_bound(forces,
                          unknown,
                          std::abs(response.stiffness) * largest.rotation +
                            std::abs(response.damping) * rate);
          }
      }

    private:
      /** Second minus first of @p values at two unknowns. */
      static double difference(const std::array<int, 2> &unknowns,
                               const Vector             &values)
      {
        return values[unknowns[1]] -
          (unknowns[0] >= 0 ? values[unknowns[0]] : 0.);
      }

      /** Relative rotation (rad) and its rate. */
      static ConnectorMotion motion_of(const std::array<int, 2> &unknowns,
                                       const Evaluation         &evaluation)
      {
        const State    &from = evaluation.from, &to = evaluation.to;
        ConnectorMotion motion{difference(unknowns, to.displacement),
                               0,
                               difference(unknowns, from.displacement),
                               evaluation.dt};
        const double    turn = motion.extension - motion.previous_extension;
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          motion.rate = turn / evaluation.dt;
        else if (evaluation.kind == Evaluation::Kind::static_step)
          {
            const BackwardDifference backward(from, evaluation.dt);
            motion.rate = backward.now * turn;
            if (from.before)
              motion.rate -= backward.before *
                (motion.previous_extension -
                 difference(unknowns, from.before->displacement));
          }
        else if (to.velocity)
          motion.rate = difference(unknowns, *to.velocity);
        return motion;
      }

      /** Adds the derivative @p k (N m/rad) of the moment of spring @p i. */
      void add_block(const unsigned int i,
                     const double       k,
                     TangentMatrix     &matrix) const
      {
        const double block[4] = {k, -k, -k, k};
        matrix.add(first_block + i, block);
      }

      const std::vector<RotationalSpring> springs;
      LawGroup                            group;
      const ConnectorLaw                 &law; ///< that of the group
      std::size_t                         first_block = 0;
    };
  } // namespace

  std::unique_ptr<Effect>
  make_rotational_laws(const DofNumbering                 &numbering,
                       const std::string                  &name,
                       std::shared_ptr<const ConnectorLaw> law,
                       std::vector<RotationalSpring>       springs,
                       const std::vector<unsigned int>    &numbers)
  {
    std::vector<unsigned int> owned;
    for (unsigned int i = 0; i < springs.size(); ++i)
      if (numbering.layout().is_owned(springs[i].unknowns[1]))
        owned.push_back(i);
    return std::make_unique<RotationalLaws>(
      std::move(springs),
      LawGroup(name, std::move(law), {}, numbers, owned));
  }
} // namespace auxfem
