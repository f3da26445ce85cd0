#include <auxfem/output/verdict.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/time/watch.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    bool has_loads_at_start(const RunPlan &plan)
    {
      std::vector<TimeFunction> functions = functions_of_time(plan);
      functions.insert(functions.end(),
                       plan.scene.gravity.acceleration.begin(),
                       plan.scene.gravity.acceleration.end());
      return std::any_of(functions.begin(),
                         functions.end(),
                         [](const TimeFunction &function) {
                           return function.value_after(0) != 0;
                         });
    }

    using Kind = EnergyJudgement::Kind;

    Kind kind_of(const Equations &equations)
    {
      return equations.model().plan.simulated.inertia ? Kind::motion
        : equations.layout().path                     ? Kind::static_path
                                                      : Kind::static_steps;
    }

    class EnergyWatch : public Watch
    {
    public:
      explicit EnergyWatch(const WatchContext &run)
        : equations(run.equations)
        , judgement(kind_of(run.equations))
        , starts_with_loads(kind_of(run.equations) == Kind::static_steps &&
                            has_loads_at_start(run.plan))
      {}

      void start(const State &state) override
      {
        judgement.start(state.energies);
      }

      void step(const Evaluation        &step,
                const EvaluationResults &results,
                TangentSolver & /*solver*/) override
      {
        const Energies &energies = step.to.energies;
        // The work of sudden loads depends on how they are applied.
        if (expects_jump || (starts_with_loads && step.from.largest_force == 0))
          judgement.start(energies);
        expects_jump = false;
        judgement.add(energies,
                      step.to.time,
                      judgement.exceeds_balance_limit(energies)
                        ? round_off(step, results)
                        : 0.);
      }

      void expect_jump() override
      {
        expects_jump = true;
      }

      std::vector<Finding> findings() const override
      {
        return judgement.findings();
      }

      void serialize(CheckpointArchive &archive) override
      {
        judgement.serialize(archive);
      }

    private:
      /**
       * Work of the round-off of forces (J), which dominates in motions
       * without strain. Collective.
       */
      double round_off(const Evaluation        &step,
                       const EvaluationResults &results) const
      {
        const Vector         forces = equations.round_off(step, results);
        const Vector        &motion = step.to.displacement;
        const UnknownLayout &layout = equations.unknowns().layout;
        double               mine   = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          mine += forces[i] * std::abs(motion[i]);
        return layout.sum(mine);
      }

      const Equations &equations;
      EnergyJudgement  judgement;
      const bool       starts_with_loads; ///< in statics
      bool             expects_jump = false;
    };
  } // namespace

  std::unique_ptr<Watch> make_energy_watch(const WatchContext &run)
  {
    return std::make_unique<EnergyWatch>(run);
  }
} // namespace auxfem
