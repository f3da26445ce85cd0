#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/step_report.h>
#include <auxfem/time/consistent_rates.h>
#include <auxfem/time/schemes/static.h>
#include <auxfem/time/small_displacement_limit.h>
#include <auxfem/time/time_stepper.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Updates the largest energy of @p now, which follows @p before. */
    void update_largest_energy(const State &before, State &now)
    {
      now.largest_energy = std::max({before.largest_energy,
                                     now.energies.total(),
                                     now.energies.dissipated()});
    }
  } // namespace

  TimeStepper::TimeStepper(Equations &equations, Work &work)
    : equations(equations)
    , parameters(equations.model().plan.time)
    , scheme(parameters.implicit_scheme())
    , work(work)
    , trial(equations.initial_solution())
    , rotations(equations.model().numbering)
    , solvers(std::make_unique<Solvers>(equations, work))
    , control(make_step_control(parameters))
    , dense_output(equations, scheme)
    , ends(equations.model().plan)
    , scene_watches(equations, work)
  {
    if (!equations.reporting().constraints.empty() &&
        scheme.propagates_alternating_errors())
      solvers->rates = std::make_unique<RateSolver>(equations, work);
    if (parameters.relative_tolerance)
      error.emplace(equations);
    if (scheme.stages() != nullptr)
      stages.emplace(equations, scheme);
    if (!scheme.is_dynamic() && !equations.is_linear())
      jumps = scene_watches.add(
        std::make_unique<EquilibriumJumps>(equations.model()));
  }

  StepReport TimeStepper::advance(Solution &solution, Recorder &recorder)
  {
    State     &state = solution.state;
    StepReport report;
    report.dt = parameters.step;
    if (jumps)
      jumps->begin_step();
    const double end = parameters.time_at(state.step + 1);
    while (state.time < end)
      {
        update_couplings(state);
        const bool is_jump = handle_events(solution, report, recorder);
        advance_substep(solution, ends.next(state.time, end), report, recorder);
        if (is_jump)
          state.before.reset();
      }
    ++state.step;
    ++work.steps;
    return report;
  }

  void TimeStepper::update_couplings(State &state)
  {
    bool are_more_ghosts;
    {
      const Stopwatch watch(work.wall.contact);
      are_more_ghosts = equations.update_couplings(state);
    }
    extend_ghosts(are_more_ghosts);
  }

  void TimeStepper::extend_ghosts(const bool are_more)
  {
    if (!are_more)
      return;
    trial.state.extend_ghosts(equations.unknowns().layout);
    if (stages)
      stages->reset_prediction();
  }

  bool TimeStepper::handle_events(Solution   &solution,
                                  StepReport &report,
                                  Recorder   &recorder)
  {
    const std::optional<StepEnd::Jump> jump = ends.jump_at(solution.state.time);
    if (!jump)
      return false;
    if (scheme.is_dynamic())
      {
        if (stages)
          stages->reset_prediction();
        restart_rates(solution, *jump);
        return false;
      }
    solution.state.before.reset();
    if (*jump != StepEnd::Jump::accelerations || !solution.state.velocity)
      return *jump != StepEnd::Jump::none;
    apply_load_jump(solution, report, recorder);
    return false;
  }

  void TimeStepper::restart_rates(Solution &solution, const StepEnd::Jump jump)
  {
    using Jump   = StepEnd::Jump;
    State &state = solution.state;
    // The discrete gradient does not use accelerations at the start of a step.
    if (jump == Jump::none ||
        (scheme.uses_discrete_gradient() && jump != Jump::velocities))
      return;
    ConsistentRates rates(solvers->tangent);
    const double    event = *ends.event_at_begin(state.time);
    const State before = rates.update_after_jump(state, event, parameters.step);
    update_results(solution, before, &rates, event);
    solvers->newton.drop_factorization();
  }

  void TimeStepper::update_results(Solution              &solution,
                                   const State           &before,
                                   const ConsistentRates *rates,
                                   const double           event)
  {
    State     &state    = solution.state;
    Evaluation instant  = Evaluation::consistent_rates(before, state);
    instant.event_at_to = {event, TimeSide::after};
    instant.impulses    = rates ? rates->impulses() : nullptr;
    solvers->tangent.residual(instant, solution.results);
    equations.accept(instant, solution.results);
    if (const std::string quantity =
          nonfinite_quantity(equations.model(), state);
        !quantity.empty())
      {
        const std::string reason =
          equations.nonfinite_reason(instant, solution.results);
        std::ostringstream message;
        message << "At t = " << state.time << " s the state is not finite: "
                << (reason.empty() ? quantity : reason) << '.';
        throw ComputationError(message.str());
      }
    update_largest_energy(state, state);
  }

  void TimeStepper::apply_load_jump(Solution   &solution,
                                    StepReport &report,
                                    Recorder   &recorder)
  {
    constexpr double step_fraction = 1e-5;
    State           &state         = solution.state;
    StepReport       jump_report;
    advance_substep(solution,
                    state.time + step_fraction * parameters.step,
                    jump_report,
                    recorder);
    report.iterations += jump_report.iterations;
    report.retries += jump_report.retries;
    state.before.reset();
  }

  void TimeStepper::advance_substep(Solution    &solution,
                                    const double target,
                                    StepReport  &report,
                                    Recorder    &recorder)
  {
    while (true)
      {
        const PlannedStep planned =
          control->plan(solution.state.time,
                        jumps ? jumps->target(target) : target);
        if (try_step(solution, planned, report, recorder))
          {
            ++report.substeps;
            report.dt = std::min(report.dt, planned.dt);
            return;
          }
        ++report.retries;
        ++work.retries;
        if (control->rejected(rejected_error))
          continue;
        if (!(jumps && jumps->allow_jumps()) &&
            !solvers->newton.allow_slack(solution.state))
          throw_step_failure(solution.state, planned.dt);
        control = make_step_control(parameters);
      }
  }

  bool TimeStepper::try_step(Solution          &solution,
                             const PlannedStep &planned,
                             StepReport        &report,
                             Recorder          &recorder)
  {
    State &state       = solution.state;
    rejected_error     = 0;
    trial.state.time   = planned.end;
    Evaluation step    = make_evaluation(state, planned.dt);
    step.event_at_from = ends.event_at_begin(state.time);
    step.event_at_to   = ends.event_at_end(planned.end);
    if (stages ? !solve_stages(solution, step, report)
               : !solve_step(step, report))
      return false;
    if (!is_acceptable(step))
      return false;
    accept(solution, step, recorder);
    return true;
  }

  Evaluation TimeStepper::make_evaluation(const State &from, const double dt)
  {
    if (!scheme.is_dynamic())
      return Evaluation::static_step(from, trial.state, dt);
    return scheme.uses_discrete_gradient()
      ? Evaluation::discrete_gradient(from, trial.state, dt)
      : Evaluation::step(from, trial.state, dt);
  }

  bool TimeStepper::solve_step(const Evaluation &step, StepReport &report)
  {
    predict(scheme, step);
    if (!solve(scheme, step, report))
      return false;
    if (solvers->rates)
      restore_rates(step);
    equations.accept(step, trial.results);
    return true;
  }

  bool TimeStepper::solve_stages(const Solution   &solution,
                                 const Evaluation &step,
                                 StepReport       &report)
  {
    stages->begin(step, solution.results);
    for (unsigned int i = 1; i < stages->n(); ++i)
      {
        const Evaluation stage = stages->next(step);
        predict(stages->rule(), stage);
        if (!solve(stages->rule(), stage, report))
          return false;
        stages->solved(stage, trial.results);
        if (i + 1 == stages->n())
          equations.accept(stage, trial.results);
      }
    return true;
  }

  void TimeStepper::predict(const ImplicitScheme &rule, const Evaluation &step)
  {
    rule.predict(step.from, step.dt, step.to);
    if (scheme.uses_discrete_gradient())
      extrapolate_predictor(rule, step, equations.model());
    else if (scheme.is_dynamic() && !stages &&
             equations.has_contact_candidates())
      keep_velocities(rule, step);
    if (equations.is_linear())
      repeat_last_increment(rule, step);
    Vector increment;
    if (jumps && jumps->extrapolate(step, rotations, increment))
      rule.correct(step.from, increment, step.dt, step.to);
    rotations.follow(step);
    if (scheme.is_dynamic())
      prescribe_motion(equations.model(), step);
  }

  bool TimeStepper::solve(const ImplicitScheme &rule,
                          const Evaluation     &step,
                          StepReport           &report)
  {
    const Newton::Result result =
      solvers->newton.solve(rule, step, trial.results);
    report.iterations += result.iterations;
    work.iterations += result.iterations;
    report.relative_residual = result.relative_residual;
    if (result.converged)
      return true;
    std::ostringstream reason;
    reason << result.reason << "; relative residual "
           << result.relative_residual << ", largest at the "
           << unknown_with_largest_residual(equations.model(), trial.state);
    return reject(reason.str());
  }

  void TimeStepper::restore_rates(const Evaluation &step)
  {
    solvers->rates->rates.restore(step);
    solvers->tangent.residual(step, trial.results);
  }

  bool TimeStepper::is_acceptable(const Evaluation &step)
  {
    if (const std::string quantity =
          nonfinite_quantity(equations.model(), step.to);
        !quantity.empty())
      return reject(quantity + " is not a finite number");
    if (const std::string reason = rejection_reason(step); !reason.empty())
      return reject(reason);
    if (creates_energy(step))
      return reject(
        "the step would create energy (more than Time/Largest energy error)");
    if (jumps)
      if (const std::string reason = jumps->rejection_reason(
            step,
            solvers->newton.predicted_increment(),
            scene_watches.changes_stability(step, solvers->tangent));
          !reason.empty())
        return reject(reason);
    const double error_of_step = error ? relative_error(step) : 0;
    if (control->may_be_accepted(error_of_step))
      return true;
    rejected_error = error_of_step;
    return reject("the error is larger than Time/Relative tolerance allows");
  }

  std::string TimeStepper::rejection_reason(const Evaluation &step)
  {
    const Stopwatch watch(work.wall.contact);
    return equations.rejection_reason(step);
  }

  bool TimeStepper::creates_energy(const Evaluation &step) const
  {
    // In too long a step an implicit scheme can converge to an unrelated state,
    // which shows as created energy. The discrete gradient creates none.
    if (scheme.uses_discrete_gradient())
      return false;
    const Energies &before = step.from.energies, &after = step.to.energies;
    // Numerical energy gain with inertia counts as created. In statics it only
    // stems from the rates at the end of the step.
    const double created = after.balance(before.balance(0.)) -
      (scheme.is_dynamic() ? after.numerical() - before.numerical() : 0.);
    const double turnover =
      std::max({step.from.largest_energy,
                std::abs(after.external() - before.external()),
                after.dissipated() - before.dissipated()});
    if (created <= parameters.energy_error * turnover)
      return false;
    // Displaced positions have round-off. Where a motion begins smoothly, all
    // energy is support work, and its integration error looks created.
    const LatticeModel &model = equations.model();
    double              error = equations.round_off_floor(step, trial.results) *
      largest_motion(model, step.to.displacement).first;
    if (scheme.is_dynamic())
      error += support_work_error(model, step);
    return !(created <= parameters.energy_error * turnover + error);
  }

  double TimeStepper::relative_error(const Evaluation &step)
  {
    return stages ? error->relative(step, stages->embedded_difference())
                  : error->relative(step);
  }

  void TimeStepper::accept(Solution         &solution,
                           const Evaluation &step,
                           Recorder         &recorder)
  {
    last_dt = step.dt;
    control->accepted(error ? error->accept(step) : 0);
    if (stages)
      stages->accept();
    update_largest_energy(solution.state, trial.state);
    if (jumps && jumps->is_jump())
      scene_watches.expect_jump();
    if (limit != nullptr)
      limit->check(step, trial.results);
    scene_watches.step(step, trial.results, solvers->tangent);
    trial.state.step = solution.state.step;
    std::swap(solution, trial);
    dense_output.record(trial,
                        solution,
                        step.event_at_from,
                        step.event_at_to,
                        step_end_tolerance(parameters),
                        solvers->tangent,
                        recorder);
    trial.state = solution.state;
  }

  bool TimeStepper::reject(const std::string &reason)
  {
    last_failure = reason;
    solvers->newton.drop_factorization();
    return false;
  }

  void TimeStepper::throw_step_failure(const State &state,
                                       const double dt) const
  {
    const auto         jump = ends.jump_at(state.time);
    std::ostringstream message;
    message
      << "The step from t = " << state.time << " s" << std::setprecision(3)
      << (jump && *jump != StepEnd::Jump::none
            ? ", where a load or a prescribed motion jumps,"
            : "")
      << " did not converge even with dt = " << dt << " s ("
      << (dt < control->shortest() ? "which is less than"
                                   : "half of it would be less than")
      << " Time/Smallest time step = " << control->shortest()
      << " s): " << last_failure
      << ".\nAll steps until then are in the output folder. Try a smaller smallest "
         "step or numerical damping (Scheme = generalized-alpha); with contact, "
         "Scheme = energy-momentum; in statics, prescribed motion in place of a "
         "force. If the structure is unstable, none of these helps.";
    throw ComputationError(message.str());
  }

  std::vector<Finding> TimeStepper::findings() const
  {
    std::vector<Finding> all = scene_watches.findings();
    if (error)
      for (const Finding &finding : error->findings())
        all.push_back(finding);
    return all;
  }
} // namespace auxfem
