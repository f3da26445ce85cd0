#include <auxfem/analysis/time_stepper.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/static.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const ImplicitScheme &prepare(System               &system,
                                  const TimeParameters &parameters)
    {
      const ImplicitScheme &scheme = parameters.implicit_scheme();
      if (scheme.uses_algorithmic_acceleration())
        system.use_algorithmic_acceleration();
      return scheme;
    }
  } // namespace

  TimeStepper::TimeStepper(System &system, const Scene &scene)
    : system(system)
    , parameters(scene.time)
    , scheme(prepare(system, parameters))
    , solver(system, scene.newton, scene.solver)
    , trial(system.initial_state())
  {
    if (system.has_conditions() && scheme.carries_on_alternating_errors())
      rate_solver = std::make_unique<RateSolver>(system, scene.solver);
    if (parameters.smallest_step == 0)
      parameters.smallest_step = parameters.step / 1024;
  }

  TimeStepper::RateSolver::RateSolver(System                 &system,
                                      const SolverParameters &parameters)
    : matrix(system.make_tangent())
    , linear_solver(parameters, *matrix, system)
    , rates(system, *matrix, linear_solver)
  {}

  unsigned long TimeStepper::n_steps() const
  {
    return parameters.n_steps();
  }

  void TimeStepper::start(State &state)
  {
    if (parameters.static_start)
      {
        const Equilibrium equilibrium;
        trial = state;
        const Step step{state, trial, std::numeric_limits<double>::infinity()};
        equilibrium.predict(step.from, step.dt, step.to);
        system.rotations().follow(step);
        system.begin_step(step);
        const Newton::Result result = solver.solve(equilibrium, step);
        solver.drop_factorization();
        if (!result.converged)
          throw ComputationError(
            "No static equilibrium was found under the loads of t = 0: " +
            result.reason +
            ". Start from rest, or raise the load in steps with "
            "`Scheme = static` to see where it is lost.");
        if (state.velocity)
          {
            *trial.velocity = *state.velocity;
            system.rotations().make_material(trial, *trial.velocity);
          }
        state = trial;
      }
    if (scheme.is_dynamic())
      {
        ConsistentRates(system, solver.tangent(), solver.solver())
          .start(state, parameters.step);
        solver.drop_factorization();
      }
    complete_start(state);
    largest_energy = state.energies.total();
  }

  void TimeStepper::complete_start(State &state)
  {
    evaluate_accepted(state);
    system.accept({trial, state, /*dt=*/0.});
    // What brought the lattice into its first state is not part of the run.
    state.external_work     = 0;
    state.energies.external = 0;
  }

  void TimeStepper::evaluate_accepted(State &state)
  {
    trial = state;
    const Step step{trial, state, /*dt=*/0.};
    system.begin_step(step);
    system.residual(step);
  }

  StepReport TimeStepper::advance(State &state)
  {
    StepReport report;
    report.substeps = 0;
    report.dt       = parameters.step;

    const double begin = parameters.time_at(state.step),
                 end   = parameters.time_at(state.step + 1);
    // Equal steps must have exactly equal lengths to share a factorization.
    const double length =
      std::abs(end - begin - parameters.step) < 1e-6 * parameters.step
      ? parameters.step
      : end - begin;

    // The step is covered by pieces of 1/2^level, number `position` next.
    unsigned int level = 0, position = 0;
    while (position < (1u << level))
      {
        const double piece   = 1. / (1u << level);
        const bool   is_last = position + 1 == (1u << level);
        const double time =
          is_last ? end : begin + length * piece * (position + 1);
        const double dt = length * piece;
        if (try_step(state, time, dt, report))
          {
            ++report.substeps;
            report.dt = std::min(report.dt, dt);
            ++position;
            if (!is_last && level > 0 && position % 2 == 0)
              {
                --level;
                position /= 2;
              }
            continue;
          }
        ++report.retries;
        if (dt / 2 < parameters.smallest_step)
          give_up(state, dt);
        ++level;
        position *= 2;
      }
    ++state.step;
    return report;
  }

  void TimeStepper::give_up(State &state, const double dt)
  {
    evaluate_accepted(state);
    std::ostringstream message;
    message
      << "The step from t = " << state.time
      << " s did not converge even with dt = " << dt
      << " s (Time/Smallest time step = " << parameters.smallest_step
      << " s): " << last_failure
      << ".\nAll steps until then are in the output folder. A smaller smallest "
         "step, numerical damping (Scheme = generalized-alpha) or, in statics, "
         "prescribed motion in place of a force may carry it further; an "
         "unstable structure will not be carried by any.";
    throw ComputationError(message.str());
  }

  Newton::Result TimeStepper::solve_trial(State &state, const Step &step)
  {
    try
      {
        scheme.predict(step.from, step.dt, step.to);
        system.rotations().follow(step);
        if (scheme.is_dynamic())
          system.prescribe_motion(step, parameters.step);
        system.begin_step(step);
        return solver.solve(scheme, step);
      }
    catch (const ComputationError &)
      {
        // A load that is not a number, say: what is on disk stays complete.
        evaluate_accepted(state);
        throw;
      }
  }

  bool TimeStepper::try_step(State       &state,
                             const double time,
                             const double dt,
                             StepReport  &report)
  {
    trial.time = time;
    const Step           step{state, trial, dt};
    const Newton::Result result = solve_trial(state, step);
    report.iterations += result.iterations;
    report.factorizations += result.factorizations;
    report.linear_iterations += result.linear_iterations;
    report.relative_residual = result.relative_residual;
    if (!result.converged)
      {
        std::ostringstream words;
        words << result.reason << "; relative residual "
              << result.relative_residual << ", largest at the "
              << system.worst_unknown(trial);
        last_failure = words.str();
        solver.drop_factorization();
        return false;
      }
    if (rate_solver)
      {
        rate_solver->rates.restore(trial);
        system.begin_step(step);
        system.residual(step);
      }
    system.accept(step);
    if (creates_energy(step))
      {
        last_failure =
          "the step would create energy (more than Time/Largest energy error)";
        solver.drop_factorization();
        return false;
      }
    largest_energy = std::max(
      {largest_energy, trial.energies.total(), trial.energies.dissipated});
    trial.step = state.step;
    state      = trial;
    return true;
  }

  bool TimeStepper::creates_energy(const Step &step) const
  {
    // Implicit schemes can converge to states that have nothing to do with the
    // motion when a step is too long for it; these show by energy from nowhere.
    const Energies &before = step.from.energies, &after = step.to.energies;
    const double    created = after.balance(before.balance(0.));
    const double    turnover =
      std::max({largest_energy,
                std::abs(after.external - before.external),
                after.dissipated - before.dissipated});
    return created > parameters.energy_error * turnover;
  }

  Newton &TimeStepper::newton()
  {
    return solver;
  }
} // namespace auxfem
