#include <auxfem/mesh/sets.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/run_output.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/out_of_memory.h>
#include <auxfem/reduced_cell/cell_run.h>
#include <auxfem/reduced_cell/comparison.h>
#include <auxfem/simulation.h>
#include <auxfem/system/mechanism.h>
#include <auxfem/system/overconstrained.h>
#include <auxfem/time/stopwatch.h>
#include <auxfem/time/time_stepper.h>

#include <limits>
#include <new>

namespace auxfem
{
  namespace
  {
    void count(const StepReport &report, RunTotals &totals)
    {
      ++totals.steps;
      totals.iterations += report.iterations;
      totals.factorizations += report.factorizations;
      totals.linear_iterations += report.linear_iterations;
      totals.retries += report.retries;
    }

    void finish(RunOutput         &output,
                const System      &system,
                const State       &state,
                TimeStepper       &stepper,
                RunTotals          totals,
                const std::string &exit_state)
    {
      const double setup = totals.wall.setup;
      totals.wall        = stepper.newton().times();
      totals.wall.setup  = setup;
      output.finish(system, state, totals, exit_state);
    }

    /** Throws InputError if the scene has no unique solution from the start. */
    void refuse_undetermined(const Scene &scene,
                             System      &system,
                             const State &state,
                             TimeStepper &stepper)
    {
      refuse_overconstrained(system,
                             state,
                             stepper.newton().tangent(),
                             stepper.newton().solver());
      if (system.is_dynamic() && !scene.time.static_start)
        return;
      refuse_mechanism(system,
                       state,
                       scene.time.static_start
                         ? std::numeric_limits<double>::infinity()
                         : scene.time.step,
                       stepper.newton().tangent(),
                       stepper.newton().solver());
    }

    void run_lattice(const Scene      &scene,
                     const MPI_Comm    communicator,
                     const StartTimes &start)
    {
      RunTotals totals;
      auto      setup = std::make_unique<Stopwatch>(totals.wall.setup);

      RunOutput     output(scene, communicator, start);
      const Lattice lattice = build_lattice(scene);
      System        system(scene, lattice, communicator);
      TimeStepper   stepper(system, scene);
      State         state = system.initial_state();
      refuse_undetermined(scene, system, state, stepper);
      // Mistakes it finds must not cost the results of an earlier run; a
      // search for equilibrium that fails is no mistake.
      if (!scene.time.static_start)
        try
          {
            stepper.start(state);
          }
        catch (const ComputationError &failure)
          {
            output.begin(system);
            finish(output, system, state, stepper, totals, failure.what());
            throw;
          }
      setup.reset();
      output.begin(system);

      try
        {
          if (scene.time.static_start)
            stepper.start(state);
          output.write_start(state);
          while (state.step < scene.time.n_steps())
            {
              const StepReport report = stepper.advance(state);
              count(report, totals);
              output.write_step(state, report);
            }
        }
      catch (const std::bad_alloc &)
        {
          // On several ranks the others know nothing of it, and would wait.
          if (system.numbering().n_ranks() == 1)
            finish(output,
                   system,
                   state,
                   stepper,
                   totals,
                   out_of_memory_text());
          throw;
        }
      catch (const std::exception &failure)
        {
          finish(output, system, state, stepper, totals, failure.what());
          throw;
        }
      finish(output, system, state, stepper, totals, "completed");
    }

    void check_lattice(const Scene &scene, const MPI_Comm communicator)
    {
      const Lattice lattice = build_lattice(scene);
      System        system(scene, lattice, communicator);
      TimeStepper   stepper(system, scene);
      State         state = system.initial_state();
      refuse_undetermined(scene, system, state, stepper);
      if (!scene.time.static_start)
        stepper.start(state);
      refuse_columns_of_nothing(scene, lattice);
      print_overview(scene, system);
    }
  } // namespace

  void
  run(const Scene &scene, const MPI_Comm communicator, const StartTimes &start)
  {
    if (scene.model == Model::reduced_cell)
      on_first_rank(communicator, [&]() { run_reduced_cell(scene, start); });
    else
      run_lattice(scene, communicator, start);
  }

  void check(const Scene &scene, const MPI_Comm communicator)
  {
    if (scene.model == Model::reduced_cell)
      on_first_rank(communicator, [&]() { check_reduced_cell(scene); });
    else
      check_lattice(scene, communicator);
  }

  void compare(const std::vector<Scene> &scenes,
               const std::string        &folder,
               const MPI_Comm            communicator)
  {
    on_first_rank(communicator, [&]() { run_comparison(scenes, folder); });
  }
} // namespace auxfem
