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
    if (!scheme.is_dynamic())
      {
        account_for_rates(solution, State(state), nullptr, 0.);
        watches_of_scene.start(state);
        return;
      }
    ConsistentRates rates(solvers->tangent);
    const State     before = rates.start(state, parameters.step);
    if (scheme.keeps_massless_in_equilibrium())
      rates.keep_massless(state);
    account_for_rates(solution, before, &rates, 0.);
    watches_of_scene.start(state);
    solvers->newton.drop_factorization();
  }

  void TimeStepper::begin_with_factorization(const State &rest)
  {
    State now = rest;
    if (parameters.static_start)
      solvers->newton.take_factorization(Evaluation::equilibrium(rest, now),
                                         Equilibrium().factors(rest, 0.));
    else
      solvers->newton.take_factorization(evaluation_of(rest, parameters.step),
                                         scheme.factors(rest, parameters.step));
  }

  void TimeStepper::find_static_equilibrium(State &state)
  {
    const Equilibrium search;
    trial.state                 = state;
    const Evaluation evaluation = Evaluation::equilibrium(state, trial.state);
    const auto       solve      = [&] {
      search.predict(state, /*dt=*/0., trial.state);
      rotations.follow(evaluation);
      return solvers->newton.solve(search, evaluation, trial.results);
    };
    Newton::Result result = solve();
    if (!result.converged && solvers->newton.allow_slack(state))
      result = solve();
    solvers->newton.drop_factorization();
    work.iterations += result.iterations;
    if (const std::string why =
          result.converged ? rejection_reason(evaluation) : result.reason;
        !why.empty())
      throw ComputationError(
        "No static equilibrium was found under the loads of t = 0 in one go: " +
        why +
        ". Start from rest, or raise the load in steps with "
        "`Scheme = static` to see where it is lost.");
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
    watches_of_scene.serialize(archive);
  }

  void TimeStepper::restart(Solution &solution)
  {
    take_ghosts(equations.restart_couplings(solution.state));
    if (stages)
      stages->forget();
    watches_of_scene.forget_steps();
    solvers->newton.restart();
    if (solvers->rates)
      solvers->rates->solver.restart();
    trial.state = solution.state;
    if (!stages && last_dt > 0)
      solvers->newton.factorize_ahead(scheme,
                                      evaluation_of(solution.state, last_dt),
                                      trial.results);
    State evaluated = solution.state;
    solvers->tangent.residual(Evaluation::consistent_rates(solution.state,
                                                           evaluated),
                              solution.results);
    trial.state = solution.state;
  }
} // namespace auxfem
