#include <auxfem/analysis/time_stepper.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/static.h>

namespace auxfem
{
  namespace
  {
    const std::string rates_record = "mass matrix";
  } // namespace

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
          result.converged ? why_not_acceptable(evaluation) : result.reason;
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

  void TimeStepper::save(Records &records) const
  {
    equations.save(records);
    control->save(records);
    if (error)
      error->save(records);
    watches_of_scene.save(records);
    if (stages)
      stages->save(records);
    solvers->newton.save(records);
    if (solvers->rates)
      solvers->rates->solver.save(rates_record,
                                  /*with_factorization=*/false,
                                  records);
  }

  void TimeStepper::resume(Solution &solution, const Records &records)
  {
    take_ghosts(equations.resume(solution.state, records));
    control->resume(records);
    if (error)
      error->resume(records);
    watches_of_scene.resume(records);
    if (stages)
      stages->resume(records);
    solvers->newton.resume(records);
    if (solvers->rates)
      solvers->rates->solver.resume(rates_record, records);
    trial.state     = solution.state;
    State evaluated = solution.state;
    solvers->tangent.residual(Evaluation::rates(solution.state, evaluated),
                              solution.results);
  }
} // namespace auxfem
