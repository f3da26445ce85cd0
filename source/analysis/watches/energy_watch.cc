#include <auxfem/analysis/watch.h>
#include <auxfem/output/energy_judgement.h>

namespace auxfem
{
  namespace
  {
    class EnergyWatch : public Watch
    {
    public:
      explicit EnergyWatch(const EnergyJudgement::Kind kind) : judgement(kind)
      {}

      void start(const State &state) override
      {
        judgement.start(state.energies);
      }

      void step(const Evaluation &step,
                const EvaluationResults & /*results*/,
                TangentSolver & /*solver*/) override
      {
        judgement.add(step.to.energies, step.to.time);
      }

      std::vector<Finding> findings() const override
      {
        return judgement.findings();
      }

      void save(Records &records) const override
      {
        judgement.save(records);
      }

      void resume(const Records &records) override
      {
        judgement.resume(records);
      }

    private:
      EnergyJudgement judgement;
    };
  } // namespace

  std::unique_ptr<Watch> make_energy_watch(const Equations &equations)
  {
    using Kind = EnergyJudgement::Kind;
    return std::make_unique<EnergyWatch>(
      equations.model().simulated.inertia ? Kind::motion
        : equations.layout().path         ? Kind::static_path
                                          : Kind::static_steps);
  }
} // namespace auxfem
