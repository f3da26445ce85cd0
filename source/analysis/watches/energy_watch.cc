#include <auxfem/analysis/watch.h>
#include <auxfem/output/energy_judgement.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    class EnergyWatch : public Watch
    {
    public:
      EnergyWatch(const Equations &equations, const EnergyJudgement::Kind kind)
        : equations(equations)
        , judgement(kind)
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
        judgement.add(energies,
                      step.to.time,
                      judgement.is_off(energies) ? round_off(step, results)
                                                 : 0.);
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
      /** Work of the round-off of forces (J): all there is where a structure is
       * moved without strains. Collective. */
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
    };
  } // namespace

  std::unique_ptr<Watch> make_energy_watch(const Equations &equations)
  {
    using Kind = EnergyJudgement::Kind;
    return std::make_unique<EnergyWatch>(equations,
                                         equations.model().simulated.inertia
                                           ? Kind::motion
                                           : equations.layout().path
                                           ? Kind::static_path
                                           : Kind::static_steps);
  }
} // namespace auxfem
