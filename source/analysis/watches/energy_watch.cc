#include <auxfem/analysis/watch.h>
#include <auxfem/output/energy_judgement.h>

namespace auxfem
{
  namespace
  {
    class EnergyWatch : public Watch
    {
    public:
      explicit EnergyWatch(const bool has_inertia) : judgement(has_inertia)
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

  std::unique_ptr<Watch> make_energy_watch(const bool has_inertia)
  {
    return std::make_unique<EnergyWatch>(has_inertia);
  }
} // namespace auxfem
