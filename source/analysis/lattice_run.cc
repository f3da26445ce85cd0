#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/analysis/lattice_run.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/out_of_memory.h>

#include <new>

namespace auxfem
{
  namespace
  {
    double solver_seconds(const PhaseTimes &wall)
    {
      return wall.residual + wall.tangent + wall.factorize + wall.solve;
    }

    /** Counts its life as set-up, without the phases that have clocks of their
     * own. */
    class SetUpWatch
    {
    public:
      explicit SetUpWatch(Work &work)
        : wall(work.wall)
        , watch(std::in_place, work.wall.setup)
        , others_before(solver_seconds(work.wall))
      {}

      ~SetUpWatch()
      {
        watch.reset();
        wall.setup -= solver_seconds(wall) - others_before;
      }

    private:
      PhaseTimes              &wall;
      std::optional<Stopwatch> watch;
      const double             others_before;
    };
  } // namespace

  LatticeRun::LatticeRun(const Scene &scene, const MPI_Comm communicator)
    : set_up_watch(std::in_place, work_done.wall.setup)
    , scene(scene)
    , lattice(build_lattice(scene))
    , model(scene, lattice, communicator)
    , equations(scene, model)
    , solution{equations.initial_state(), equations.make_results()}
    , stepper(equations, scene, work_done)
  {
    set_up_watch.reset();
  }

  void LatticeRun::refuse_undetermined()
  {
    refuse_overconstrained(stepper.solver(), solution.state);
    if (model.simulated.inertia && !scene.time.static_start)
      return;
    refuse_mechanism(stepper.solver(),
                     solution.state,
                     scene.time.static_start
                       ? std::nullopt
                       : std::optional<double>(scene.time.step));
  }

  void LatticeRun::start()
  {
    stepper.start(solution);
  }

  StepReport LatticeRun::advance()
  {
    return stepper.advance(solution);
  }

  void LatticeRun::advance_to_end(Recorder &recorder)
  {
    while (solution.state.time < scene.time.end_time)
      {
        const StepReport report = advance();
        recorder.step(solution, report);
      }
  }

  const Work &LatticeRun::work() const
  {
    return work_done;
  }

  RunResult LatticeRun::result(const std::string &exit_state) const
  {
    return {exit_state, solution.state.time, work_done};
  }

  RunResult LatticeRun::run(Recorder &recorder)
  {
    bool       has_begun = false;
    const auto begin     = [&]() {
      recorder.begin(equations);
      has_begun = true;
    };
    try
      {
        {
          const SetUpWatch watch(work_done);
          refuse_undetermined();
          // Mistakes it finds must not cost the results of an earlier run; a
          // search for equilibrium that fails is no mistake.
          if (!scene.time.static_start)
            start();
        }
        begin();
        if (scene.time.static_start)
          start();
        recorder.start(solution);
        advance_to_end(recorder);
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const std::bad_alloc &)
      {
        // On several ranks the others know nothing of it, and would wait.
        if (has_begun && model.numbering.layout().n_ranks() == 1)
          recorder.finish(solution, result(out_of_memory_text()));
        throw;
      }
    catch (const std::exception &failure)
      {
        if (!has_begun)
          begin();
        recorder.finish(solution, result(failure.what()));
        throw;
      }
    RunResult completed = result("completed");
    recorder.finish(solution, completed);
    return completed;
  }
} // namespace auxfem
