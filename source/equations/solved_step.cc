#include <auxfem/equations/equations.h>

#include <deal.II/base/mpi.h>

#include <set>

namespace auxfem
{
  namespace
  {
    /** Clears the rates of multipliers, which are by-products of the time
     * scheme and must not enter its predictor. */
    void clear_multiplier_rates(const DofNumbering &numbering, State &state)
    {
      for (const int multiplier : numbering.constraints().multipliers())
        for (std::optional<Vector> *rate : {&state.velocity,
                                            &state.acceleration,
                                            &state.algorithmic_acceleration})
          if (*rate)
            (**rate)[multiplier] = 0;
    }
  } // namespace

  void Equations::accept(const Evaluation        &evaluation,
                         const EvaluationResults &results) const
  {
    clear_multiplier_rates(structure.numbering, evaluation.to);
    const bool is_stage = evaluation.kind == Evaluation::Kind::stage;
    update_history(evaluation);
    EnergyAccount account(evaluation);
    for (unsigned int i = 0; i < effects.size(); ++i)
      {
        const EffectCache *cache = results.effect_caches[i].get();
        effects[i]->account(evaluation, cache, account);
        if (!is_stage)
          effects[i]->account_step(evaluation, cache, account);
      }
    if (is_stage)
      add_stage(evaluation, results, account);
    evaluation.to.energies.amounts() =
      structure.numbering.layout().sum(account.close());
  }

  void Equations::update_history(const Evaluation &solved) const
  {
    for (const auto &effect : effects)
      effect->update_history(solved);
    if (!structure.struts_may_fail())
      return;
    std::vector<unsigned int> mine;
    for (const auto &effect : effects)
      effect->add_failures(solved, mine);
    const MPI_Comm         communicator = unknowns().layout.communicator();
    std::set<unsigned int> struts;
    for (const auto &rank_struts :
         dealii::Utilities::MPI::all_gather(communicator, mine))
      struts.insert(rank_struts.begin(), rank_struts.end());
    if (struts.empty())
      return;
    const std::vector<unsigned int> sorted(struts.begin(), struts.end());
    for (const auto &effect : effects)
      effect->break_struts(sorted, solved);
  }

  void Equations::account_stage(const Evaluation        &stage,
                                const EvaluationResults &results) const
  {
    EnergyAccount account(stage);
    add_stage(stage, results, account);
    account.close();
  }

  void Equations::add_stage(const Evaluation        &stage,
                            const EvaluationResults &results,
                            EnergyAccount           &account) const
  {
    for (const auto &[effect, terms] : stage_terms)
      terms->account_stage(stage, results.effect_caches[effect].get(), account);
  }
} // namespace auxfem
