#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/discretization/order_choice.h>
#include <auxfem/analysis/simulation/imperfect_lattice.h>
#include <auxfem/analysis/simulation/kinematics_choice.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/equations/mode_space.h>
#include <auxfem/model/load_history.h>
#include <auxfem/output/console.h>
#include <auxfem/output/history.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/run_output.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>
#include <auxfem/time/small_displacement_limit.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <new>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Checkpoint interval in steps; 0: no checkpoints. */
    unsigned long steps_between_checkpoints(const RunPlan &plan)
    {
      // Step errors need three consecutive steps, which checkpoints must not
      // separate in short runs.
      const unsigned long n     = plan.scene.output.checkpoints,
                          least = plan.simulated.inertia ? 4 : 1;
      return n == 0 ? 0 : std::max(least, (plan.time.n_steps() + n - 1) / n);
    }

    double solver_seconds(const PhaseTimes &wall)
    {
      return wall.residual + wall.tangent + wall.factorize + wall.solve +
        wall.contact;
    }

    /**
     * Counts its lifetime as set-up, except phases with clocks of their own.
     */
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

  LatticeRun::LatticeRun(const RunPlan &plan, const MPI_Comm communicator)
    : set_up_watch(std::in_place, work_done.wall.setup)
    , shared_lattice(
        std::make_shared<const Lattice>(imperfect_lattice(plan, communicator)))
    , scene(plan.scene)
    , lattice(*shared_lattice)
    , model(plan, lattice, communicator)
    , equations(model)
    , solution(equations.initial_solution())
    , stepper(equations, work_done)
  {
    set_up_watch.reset();
  }

  LatticeRun::LatticeRun(const LatticeRun &other, SimulatedEffects simulated)
    : set_up_watch(std::in_place, work_done.wall.setup)
    , shared_lattice(other.shared_lattice)
    , scene(other.scene)
    , lattice(*shared_lattice)
    , model(other.model, std::move(simulated))
    , equations(model)
    , solution(equations.initial_solution())
    , stepper(equations, work_done)
  {
    set_up_watch.reset();
  }

  void LatticeRun::refuse_undetermined()
  {
    refuse_overconstrained(stepper.solver(), solution.state);
    if (model.plan.simulated.inertia && !model.plan.time.static_start)
      return;
    const bool is_tangent =
      refuse_mechanism(stepper.solver(),
                       solution.state,
                       model.plan.time.static_start
                         ? std::nullopt
                         : std::optional<double>(model.plan.time.step));
    if (is_tangent)
      stepper.adopt_rest_factorization(solution.state);
  }

  void LatticeRun::prepare()
  {
    const SetUpWatch watch(work_done);
    refuse_undetermined();
    if (!model.plan.time.static_start)
      start();
  }

  std::optional<EffectMeasure> LatticeRun::inertia_measure()
  {
    if (!model.plan.simulated.inertia)
      return std::nullopt;
    const auto frequency = first_frequency(stepper.solver(), solution.state);
    if (!frequency)
      return std::nullopt;
    return EffectMeasure{uncommanded_motion(model.plan, *frequency),
                         "the answer"};
  }

  void LatticeRun::start()
  {
    stepper.start(solution);
    if (const auto &elements = model.plan.elements)
      observer.emplace(model, elements->report).start(solution.state);
  }

  StepReport LatticeRun::advance(Recorder &recorder)
  {
    const StepReport report = stepper.advance(solution, recorder);
    if (observer)
      observer->step(solution.state, report);
    return report;
  }

  void LatticeRun::serialize(CheckpointArchive &archive, Recorder &recorder)
  {
    Work counts = archive.is_saving() ? work_of_all() : Work();
    archive.values("work",
                   counts.steps,
                   counts.iterations,
                   counts.factorizations,
                   counts.retries,
                   counts.linear_solutions,
                   counts.linear_iterations,
                   counts.shortened);
    if (!archive.is_saving())
      {
        work_done.add_effort(counts);
        work_done.steps += counts.steps;
      }
    serialize_state(equations, archive, solution.state);
    stepper.serialize(archive);
    if (limit != nullptr)
      limit->serialize(archive);
    if (model.plan.elements && !observer)
      observer.emplace(model, model.plan.elements->report);
    if (observer)
      observer->serialize(archive);
    recorder.serialize(solution, archive);
  }

  CheckpointData LatticeRun::last_checkpoint(Recorder &recorder)
  {
    CheckpointData    data;
    CheckpointArchive archive =
      CheckpointArchive::saving(data, model.numbering.layout());
    serialize(archive, recorder);
    model.plan.save(data);
    return data;
  }

  CheckpointData LatticeRun::checkpoint(Recorder &recorder)
  {
    CheckpointData data = last_checkpoint(recorder);
    stepper.restart(solution);
    return data;
  }

  void LatticeRun::resume(const CheckpointData &checkpoint, Recorder &recorder)
  {
    CheckpointArchive archive =
      CheckpointArchive::restoring(checkpoint, model.numbering.layout());
    serialize(archive, recorder);
    // A run that ended between two steps of the scene completes its step.
    while (!solution.state.path && solution.state.step > 0 &&
           model.plan.time.time_at(solution.state.step) > solution.state.time)
      --solution.state.step;
    stepper.restart(solution);
  }

  void LatticeRun::advance_to_end(Recorder &recorder)
  {
    const unsigned long interval     = steps_between_checkpoints(model.plan);
    const MPI_Comm      communicator = model.numbering.layout().communicator();
    while (solution.state.time < model.plan.time.end_time)
      {
        if (const int signal = pending_signal(communicator); signal != 0)
          {
            recorder.keep_checkpoint();
            throw Interrupted(signal);
          }
        const StepReport report = advance(recorder);
        recorder.step(solution, report);
        if (interval == 0)
          continue;
        if (solution.state.time >= model.plan.time.end_time)
          recorder.store_checkpoint(last_checkpoint(recorder));
        else if (solution.state.step % interval == 0)
          recorder.store_checkpoint(checkpoint(recorder));
      }
    recorder.keep_checkpoint();
  }

  void LatticeRun::begin(Recorder &recorder, bool &has_begun)
  {
    if (const CheckpointData *const checkpoint = recorder.restart_checkpoint())
      {
        recorder.begin(equations);
        has_begun = true;
        resume(*checkpoint, recorder);
        return;
      }
    // Mistakes found here must not overwrite results of an earlier run. A
    // failed search for equilibrium is no mistake and comes later.
    prepare();
    recorder.begin(equations);
    has_begun = true;
    if (model.plan.time.static_start)
      start();
    recorder.start(solution);
  }

  void LatticeRun::set_limit(SmallDisplacementLimit &new_limit)
  {
    limit = &new_limit;
    stepper.set_limit(new_limit);
  }

  Work LatticeRun::work_of_all() const
  {
    Work all = work_done;
    if (limit != nullptr)
      all.add_effort(limit->effort());
    return all;
  }

  void LatticeRun::add_effort(const Work &elsewhere)
  {
    work_done.add_effort(elsewhere);
  }

  RunResult LatticeRun::result(const std::string &exit_state) const
  {
    RunResult result           = {exit_state,
                                  solution.state.time,
                                  work_of_all(),
                                  stepper.findings(),
                                  stepper.estimated_error()};
    result.largest_penetration = stepper.watches().largest_penetration();
    if (limit != nullptr)
      result.small_displacement_error = limit->error();
    if (observer)
      observer->add_to(result);
    else if (model.plan.elements)
      result.orders = model.plan.elements->report;
    return result;
  }

  RunResult LatticeRun::run(Recorder &recorder)
  {
    return run(recorder, [this](Recorder &run_recorder) {
      advance_to_end(run_recorder);
      return std::vector<Finding>();
    });
  }

  RunResult LatticeRun::run(Recorder &recorder, const Advance &advance)
  {
    bool                 has_begun = false;
    std::vector<Finding> run_findings;
    const auto           finish = [&](const std::string &exit_state) {
      if (!has_begun)
        recorder.begin(equations);
      RunResult failed = result(exit_state);
      failed.findings.push_back(failed.work.steps == 0
                                  ? nothing_computed(failed.time)
                                  : incomplete(failed.time));
      recorder.finish(solution, failed);
    };
    // With several ranks, others may not know of the exception and would wait.
    const bool is_serial = model.numbering.layout().n_ranks() == 1;
    try
      {
        begin(recorder, has_begun);
        run_findings = advance(recorder);
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const SmallDisplacementLimitExceeded &)
      {
        throw;
      }
    catch (const ComputationError &failure)
      {
        finish(failure.what());
        throw;
      }
    catch (const std::bad_alloc &)
      {
        if (has_begun && is_serial)
          finish(out_of_memory_text());
        throw;
      }
    catch (const std::exception &failure)
      {
        if (is_serial)
          finish(failure.what());
        throw;
      }
    RunResult completed = result("completed");
    completed.findings.insert(completed.findings.end(),
                              run_findings.begin(),
                              run_findings.end());
    recorder.finish(solution, completed);
    return completed;
  }

  namespace
  {
    /** Notes scenes for which statics suffices. */
    void advise_on_inertia(LatticeRun &run)
    {
      const auto measure = run.inertia_measure();
      if (!measure || run.model.numbering.layout().rank() != 0 ||
          measure->change > run.scene.effects.tolerance)
        return;
      std::ostringstream note;
      note << "Inertia is about " << std::setprecision(2) << measure->change
           << " of the answer, as loads vary slowly against the lattice's "
              "oscillations. Unless struts snap through, Time/Scheme = static "
              "suffices.";
      std::cout << "\nNote\n" << indented(note.str()) << std::endl;
    }
  } // namespace

  RunResult run_lattice(const Scene   &scene,
                        const MPI_Comm communicator,
                        Recorder      &recorder)
  {
    RunPlan plan(scene);
    if (const CheckpointData *const checkpoint = recorder.restart_checkpoint())
      plan.restore(*checkpoint);
    else if (scene.discretization.tolerance)
      plan.elements = choose_elements(plan, communicator, recorder);
    return run_with_chosen_kinematics(plan, communicator, recorder);
  }

  void check_lattice(const Scene &scene, const MPI_Comm communicator)
  {
    LatticeRun run(scene, communicator);
    run.prepare();
    require_existing_columns(scene, run.lattice);
    explain_kinematics(run);
    show_lattice(scene, run.equations);
    advise_on_inertia(run);
    if (scene.discretization.tolerance &&
        run.model.numbering.layout().rank() == 0)
      std::cout
        << "Discretization/Order = auto: the run chooses its own elements; "
           "these counts are for order "
        << scene.discretization.order << '.' << std::endl;
  }

  AnalysisEntry simulation_entry()
  {
    return {
      "simulation",
      "Motion of a lattice under its loads from t = 0 to the end time, with "
      "inertia by an implicit time scheme, or as a series of equilibria.",
      [](const Scene &scene) {
        return scene.analysis == Analysis::simulation &&
          scene.context.model == Model::lattice;
      },
      [](const Scene         &scene,
         const MPI_Comm       communicator,
         const FolderOptions &options) {
        return run_lattice(scene,
                           communicator,
                           *make_run_output(scene, communicator, options));
      },
      run_lattice,
      check_lattice,
      {}};
  }
} // namespace auxfem
