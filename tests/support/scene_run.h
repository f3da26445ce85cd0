#ifndef auxfem_tests_support_scene_run_h
#define auxfem_tests_support_scene_run_h

#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/scene/scene.h>

#include <support/mass_matrix.h>

#include <functional>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * A scene computed in this process without writing anything: set up from
     * `.prm` text, advanced step by step, asked for motions and reactions.
     * Needs one rank.
     */
    class SceneRun
    {
    public:
      explicit SceneRun(const std::string              &prm_text,
                        const std::vector<std::string> &overrides = {})
        : scene(read_scene_from_text(prm_text, "test.prm", overrides))
        , computation(scene, MPI_COMM_WORLD)
        , lattice(computation.lattice)
        , model(computation.model)
        , equations(computation.equations)
        , state(computation.solution.state)
        , results(computation.solution.results)
      {
        computation.start();
        initial_balance = state.energies.balance(0);
      }

      /** Advances to the end; calls @p after_step after each step. */
      void run(const std::function<void()> &after_step = [] {})
      {
        struct Caller : public Recorder
        {
          explicit Caller(const std::function<void()> &after_step)
            : after_step(after_step)
          {}
          void step(const Solution &, const StepReport &) override
          {
            after_step();
          }
          const std::function<void()> &after_step;
        };
        Caller caller(after_step);
        computation.advance_to_end(caller);
      }

      /** One step of the scene. */
      StepReport advance()
      {
        Recorder nobody;
        return computation.advance(nobody);
      }

      /** All that was done so far. */
      const Work &work() const
      {
        return computation.work();
      }

      /** Displacement or rotation of a joint, by component of motion. */
      double motion(const unsigned int joint,
                    const unsigned int component) const
      {
        return state
          .displacement[model.numbering.joint_unknown(joint, component)];
      }

      double velocity(const unsigned int joint,
                      const unsigned int component) const
      {
        return (
          *state.velocity)[model.numbering.joint_unknown(joint, component)];
      }

      /** Sum of the support's forces or moments on the lattice. */
      double reaction(const std::string &support,
                      const unsigned int component) const
      {
        double sum = 0;
        for (const Support &candidate : model.supports)
          if (candidate.name == support)
            for (const auto &unknown : candidate.unknowns)
              if (unknown.component == component)
                sum += state.residual[unknown.unknown];
        return sum;
      }

      /** Counted connector @p i of group number @p group now. */
      ConnectorReport connector(const unsigned int group,
                                const unsigned int i) const
      {
        return equations.reporting().connectors[group].report(i,
                                                              state,
                                                              results);
      }

      /** Evaluates `state`. */
      const EvaluationResults &residual(const Evaluation &evaluation)
      {
        equations.residual(evaluation, results);
        return results;
      }

      /** The tangent at the evaluation last given to residual(). */
      void tangent(const Evaluation     &evaluation,
                   const TangentFactors &factors,
                   TangentMatrix        &matrix) const
      {
        equations.tangent(evaluation, results, factors, matrix);
      }

      std::unique_ptr<TangentMatrix> make_tangent() const
      {
        return std::make_unique<TangentMatrix>(equations.pattern());
      }

      /** The mass matrix now. */
      std::unique_ptr<TangentMatrix> mass() const
      {
        return mass_matrix(equations, state);
      }

      /** Error of the energy balance now (J). */
      double balance() const
      {
        return state.energies.balance(initial_balance);
      }

      const Scene         scene;
      LatticeRun          computation;
      const Lattice      &lattice;
      const LatticeModel &model;
      const Equations    &equations;
      State              &state;
      EvaluationResults  &results;
      double              initial_balance = 0;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
