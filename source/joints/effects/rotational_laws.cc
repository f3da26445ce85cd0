#include <auxfem/connectors/effects/law_group.h>
#include <auxfem/joints/effects/rotational_springs.h>

#include <cmath>
#include <utility>

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

    /** Springs of one law between two rotations, whose @p Angles are
     * PlaneAngles or AxisAngles. */
    template <class Angles>
    class RotationalLaws : public Effect,
                           public StageTerms,
                           public SmallMotionTerms
    {
    public:
      RotationalLaws(Angles angles, LawGroup group)
        : angles(std::move(angles))
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
        angles.register_in(layout);
      }

      void register_blocks(TangentPattern &pattern) override
      {
        for (unsigned int i = 0; i < size(); ++i)
          {
            const std::size_t block =
              pattern.register_block(angles.rows()[i].data(), n_rows);
            if (i == 0)
              first_block = block;
          }
      }

      std::unique_ptr<EffectCache> make_results() const override
      {
        return std::make_unique<RotationalLawResults>(size());
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache      *results) const override
      {
        auto &cache = static_cast<RotationalLawResults &>(*results);
        for (unsigned int i = 0; i < size(); ++i)
          cache.motion[i] = angles.motion(i, evaluation);
        group.evaluate(evaluation, cache.motion, cache.response);
        for (unsigned int i = 0; i < size(); ++i)
          {
            const auto directions = angles.directions(i, evaluation);
            for (unsigned int r = 0; r < n_rows; ++r)
              if (const int row = angles.rows()[i][r]; row >= 0)
                residual[row] += directions[r] * cache.response[i].force;
          }
      }

      void add_tangent(const Evaluation     &evaluation,
                       const EffectCache    *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        // Factors and axes of mean moments are nearly those at the end.
        const bool is_mean =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        for (unsigned int i = 0; i < size(); ++i)
          {
            const ConnectorResponse &response =
              law_results(results).response[i];
            add_block(evaluation,
                      i,
                      is_mean ? response.stiffness
                              : factors.stiffness * response.stiffness +
                          factors.damping * response.damping,
                      (is_mean ? 1 : factors.stiffness) * response.force,
                      matrix);
          }
      }

      void add_relaxation_times(const Unknowns      &unknowns,
                                std::vector<double> &times) const override
      {
        for (const auto &rows : angles.rows())
          if (unknowns.layout.is_owned(rows.back()))
            for (const auto &[time, stiffness] : law.relaxing_stiffnesses())
              times.push_back(time);
      }

      void add_relaxing_stiffness(const Evaluation &evaluation,
                                  const EffectCache * /*results*/,
                                  const double   time,
                                  TangentMatrix &matrix) const override
      {
        const std::map<double, double> relaxing = law.relaxing_stiffnesses();
        if (const auto found = relaxing.find(time); found != relaxing.end())
          for (unsigned int i = 0; i < size(); ++i)
            add_block(evaluation, i, found->second, 0, matrix);
      }

      void add_viscous_stiffness(const Evaluation          &evaluation,
                                 const EffectCache         *results,
                                 const std::complex<double> s,
                                 TangentMatrix             &real,
                                 TangentMatrix &imaginary) const override
      {
        if (!law.is_viscous())
          return;
        const RotationalLawResults &cache = law_results(results);
        for (unsigned int i = 0; i < size(); ++i)
          {
            const std::complex<double> stiffness =
              law.dynamic_stiffness(s, cache.motion[i].extension) -
              cache.response[i].stiffness;
            add_block(evaluation, i, stiffness.real(), 0, real);
            add_block(evaluation, i, stiffness.imag(), 0, imaginary);
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
          [&](const unsigned int i) { return angles.rate(i, step.from); },
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
        for (unsigned int i = 0; i < size(); ++i)
          for (const int unknown : angles.rows()[i])
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
        for (unsigned int i = 0; i < size(); ++i)
          {
            const ConnectorResponse &response =
              law_results(results).response[i];
            for (const int unknown : angles.rows()[i])
              raise_bound(forces,
                          unknown,
                          std::abs(response.stiffness) * largest.rotation +
                            std::abs(response.damping) * rate);
          }
      }

    private:
      static constexpr unsigned int n_rows = Angles::n_rows;

      unsigned int size() const
      {
        return angles.rows().size();
      }

      /** Adds the derivative of the moment of spring @p i, with the stiffness
       * @p k (N m/rad), and of the direction of a @p moment (N m). */
      void add_block(const Evaluation  &evaluation,
                     const unsigned int i,
                     const double       k,
                     const double       moment,
                     TangentMatrix     &matrix) const
      {
        const auto directions  = angles.directions(i, evaluation),
                   derivatives = angles.derivatives(i, evaluation);
        double block[n_rows * n_rows];
        for (unsigned int r = 0; r < n_rows; ++r)
          for (unsigned int c = 0; c < n_rows; ++c)
            block[n_rows * r + c] = k * directions[r] * derivatives[c];
        angles.add_turning(i, evaluation, moment, block);
        matrix.add(first_block + i, block);
      }

      Angles              angles;
      LawGroup            group;
      const ConnectorLaw &law; ///< that of the group
      std::size_t         first_block = 0;
    };

    /** Makes the effect of @p angles, whose members have @p numbers. */
    template <class Angles>
    std::unique_ptr<Effect> make_laws(const DofNumbering &numbering,
                                      const std::string  &name,
                                      std::shared_ptr<const ConnectorLaw> law,
                                      Angles                           angles,
                                      const std::vector<unsigned int> &numbers)
    {
      std::vector<unsigned int> owned;
      for (unsigned int i = 0; i < numbers.size(); ++i)
        if (numbering.layout().is_owned(angles.rows()[i].back()))
          owned.push_back(i);
      return std::make_unique<RotationalLaws<Angles>>(
        std::move(angles),
        LawGroup(name, std::move(law), {}, numbers, owned));
    }
  } // namespace

  std::unique_ptr<Effect>
  make_rotational_laws(const DofNumbering                    &numbering,
                       const std::string                     &name,
                       std::shared_ptr<const ConnectorLaw>    law,
                       const std::vector<std::array<int, 2>> &unknowns,
                       const std::vector<unsigned int>       &numbers)
  {
    return make_laws(numbering,
                     name,
                     std::move(law),
                     PlaneAngles(unknowns),
                     numbers);
  }

  std::unique_ptr<Effect>
  make_axis_laws(const DofNumbering                 &numbering,
                 const bool                          large_rotation,
                 const std::string                  &name,
                 std::shared_ptr<const ConnectorLaw> law,
                 const std::vector<AxisPair>        &pairs)
  {
    std::vector<unsigned int> numbers;
    for (const AxisPair &pair : pairs)
      numbers.push_back(pair.number);
    return make_laws(numbering,
                     name,
                     std::move(law),
                     AxisAngles(numbering, large_rotation, name, pairs),
                     numbers);
  }
} // namespace auxfem
