#ifndef auxfem_tests_equations_effects_effect_alone_h
#define auxfem_tests_equations_effects_effect_alone_h

#include <auxfem/equations/effect.h>

#include <memory>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** Allocates state variables of effects added to the layout. */
    inline void make_room(const StateLayout &layout, State &state)
    {
      state.history.resize(layout.history.n_values(), 0.);
      state.energies =
        Energies(std::make_shared<const EnergyLedger>(layout.energies));
      state.energy_sums = state.energies.amounts();
    }

    /** An effect evaluated by itself. */
    struct EvaluatedAlone
    {
      EvaluatedAlone(const Effect &effect, const Evaluation &evaluation)
        : effect(effect)
        , evaluation(evaluation)
        , residual(evaluation.to.displacement.size(), 0.)
        , results(effect.make_results())
      {
        effect.add_residual(evaluation, residual.data(), results.get());
      }

      /** Energies of the effect; its entries must be in the states. */
      Energies accept() const
      {
        EnergyAccount account(evaluation);
        effect.account(evaluation, results.get(), account);
        effect.account_step(evaluation, results.get(), account);
        evaluation.to.energies.amounts() = account.close();
        return evaluation.to.energies;
      }

      const Effect                      &effect;
      const Evaluation                   evaluation;
      std::vector<double>                residual;
      const std::unique_ptr<EffectCache> results;
    };

    /** The pattern of @p effect behind the blocks of elements. */
    inline TangentPattern pattern_of(Effect             &effect,
                                     const DofNumbering &numbering)
    {
      TangentPattern pattern(numbering.unknowns());
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        pattern.register_block(numbering.element_unknowns(e),
                               numbering.n_element_unknowns(e));
      effect.register_blocks(pattern);
      return pattern;
    }

    /** The tangent of an effect by itself. */
    struct TangentAlone
    {
      TangentAlone(Effect &effect, const DofNumbering &numbering)
        : effect(effect)
        , pattern(pattern_of(effect, numbering))
        , matrix(pattern)
      {}

      /** Fills the matrix with the tangent at @p evaluated. */
      void fill(const EvaluatedAlone &evaluated, const TangentFactors &factors)
      {
        matrix.reset();
        effect.add_tangent(evaluated.evaluation,
                           evaluated.results.get(),
                           factors,
                           matrix);
      }

      /** The tangent times @p direction. */
      std::vector<double> times(const std::vector<double> &direction) const
      {
        std::vector<double> y(direction.size());
        matrix.multiply(direction.data(), y.data());
        return y;
      }

      const Effect        &effect;
      const TangentPattern pattern;
      TangentMatrix        matrix;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
