#include <auxfem/parameters/errors.h>
#include <auxfem/time/schemes/static.h>
#include <auxfem/time/time_stepper.h>

namespace auxfem
{
  void TimeStepper::start(Solution &solution)
  {
    State &state = solution.state;
    update_couplings(state);
    if (parameters.static_start)
      find_static_equilibrium(state);
    else
      strain_materials(state);
    if (!scheme.is_dynamic())
      {
        update_results(solution, State(state), nullptr, 0.);
        scene_watches.start(state);
        return;
      }
    ConsistentRates rates(solvers->tangent);
    const State     before = rates.start(state, parameters.step);
    if (scheme.keeps_massless_in_equilibrium())
      rates.keep_massless(state);
    update_results(solution, before, &rates, 0.);
    scene_watches.start(state);
    solvers->newton.drop_factorization();
  }

  void TimeStepper::strain_materials(State &state)
  {
    if (equations.model().initial_strains.strains.empty())
      return;
    trial.state           = state;
    Evaluation evaluation = Evaluation::equilibrium(state, trial.state);
    evaluation.starts_run = true;
    equations.update_history(evaluation);
    state.history = trial.state.history;
  }

  void TimeStepper::adopt_rest_factorization(const State &rest)
  {
    State now = rest;
    // Materials may start in another state than the relaxed one.
    if (parameters.static_start && equations.model().laws.size() > 1)
      return;
    if (parameters.static_start)
      solvers->newton.adopt_factorization(Evaluation::equilibrium(rest, now),
                                          Equilibrium().factors(rest, 0.));
    else
      solvers->newton.adopt_factorization(
        make_evaluation(rest, parameters.step),
        scheme.factors(rest, parameters.step));
  }

  void TimeStepper::find_static_equilibrium(State &state)
  {
    const Equilibrium search;
    trial.state           = state;
    Evaluation evaluation = Evaluation::equilibrium(state, trial.state);
    evaluation.starts_run = true;
    const auto solve      = [&] {
      search.predict(state, /*dt=*/0., trial.state);
      rotations.follow(evaluation);
      return solvers->newton.solve(search, evaluation, trial.results);
    };
    Newton::Result result = solve();
    if (!result.converged && solvers->newton.allow_slack(state))
      result = solve();
    solvers->newton.drop_factorization();
    work.iterations += result.iterations;
    if (const std::string reason =
          result.converged ? rejection_reason(evaluation) : result.reason;
        !reason.empty())
      throw ComputationError(
        "No static equilibrium was found in one step under the loads of "
        "t = 0: " +
        reason +
        ". Start from rest, or increase the load in steps with "
        "`Scheme = static` to see where equilibrium is lost.");
    equations.update_history(evaluation);
    if (state.velocity)
      {
        *trial.state.velocity = *state.velocity;
        rotations.make_material(trial.state, *trial.state.velocity);
      }
    state = trial.state;
  }

  void TimeStepper::serialize(CheckpointArchive &archive)
  {
    archive.values("length of the last step", last_dt);
    control->serialize(archive);
    if (error)
      error->serialize(archive);
    scene_watches.serialize(archive);
  }

  void TimeStepper::restart(Solution &solution)
  {
    extend_ghosts(equations.restart_couplings(solution.state));
    if (stages)
      stages->reset_prediction();
    scene_watches.forget_steps();
    solvers->newton.restart();
    if (solvers->rates)
      solvers->rates->solver.restart();
    trial.state = solution.state;
    if (!stages && last_dt > 0)
      solvers->newton.factorize_ahead(scheme,
                                      make_evaluation(solution.state, last_dt),
                                      trial.results);
    State evaluated = solution.state;
    solvers->tangent.residual(Evaluation::consistent_rates(solution.state,
                                                           evaluated),
                              solution.results);
    trial.state = solution.state;
  }
} // namespace auxfem
