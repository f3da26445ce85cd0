#ifndef auxfem_tests_support_scene_run_h
#define auxfem_tests_support_scene_run_h

#include <auxfem/analysis/time_stepper.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/scene/scene.h>
#include <auxfem/system/system.h>

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
        , lattice(build_lattice(scene))
        , system(scene, lattice, MPI_COMM_WORLD)
        , stepper(system, scene)
        , state(system.initial_state())
      {
        stepper.start(state);
        initial_total = state.energies.total();
      }

      /** Advances to the end; calls @p after_step after each step. */
      void run(const std::function<void()> &after_step = [] {})
      {
        while (state.step < scene.time.n_steps())
          {
            const StepReport report = stepper.advance(state);
            iterations += report.iterations;
            factorizations += report.factorizations;
            after_step();
          }
      }

      /** Displacement or rotation of a joint, by component of motion. */
      double motion(const unsigned int joint,
                    const unsigned int component) const
      {
        return state
          .displacement[system.numbering().joint_unknown(joint, component)];
      }

      double velocity(const unsigned int joint,
                      const unsigned int component) const
      {
        return (
          *state.velocity)[system.numbering().joint_unknown(joint, component)];
      }

      /** Sum of the support's forces or moments on the lattice. */
      double reaction(const std::string &support,
                      const unsigned int component) const
      {
        double sum = 0;
        for (const Support &candidate : system.supports())
          if (candidate.name == support)
            for (const auto &unknown : candidate.unknowns)
              if (unknown.component == component)
                sum += state.residual[unknown.unknown];
        return sum;
      }

      /** Error of the energy balance now (J). */
      double balance() const
      {
        return state.energies.balance(initial_total);
      }

      const Scene   scene;
      const Lattice lattice;
      System        system;
      TimeStepper   stepper;
      State         state;
      double        initial_total  = 0;
      unsigned int  iterations     = 0;
      unsigned int  factorizations = 0;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
