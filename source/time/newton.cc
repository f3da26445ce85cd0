#include <auxfem/parameters/errors.h>
#include <auxfem/time/newton.h>
#include <auxfem/time/stopwatch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Further than this no linearisation can see. Iterates that do turn so far
     * can end in equilibria of a tangle that has nothing to do with the step
     * (rad).
     */
    constexpr double half_turn = 3.14159265358979323846;
  } // namespace

  Newton::Newton(System                 &system,
                 const NewtonParameters &parameters,
                 const SolverParameters &solver)
    : system(system)
    , parameters(parameters)
    , matrix(system.make_tangent())
    , linear_solver(solver, *matrix, system.numbering())
    , increment(system.numbering().local_map())
  {}

  Newton::Result Newton::solve(const TimeIntegrator &integrator,
                               const Step           &step)
  {
    Result       result;
    ResidualNorm norm      = timed_residual(step);
    double       size      = in_force_units(norm);
    double       reduction = std::numeric_limits<double>::infinity();
    // Prescribed unknowns may still have to move to their place.
    bool is_in_place = integrator.is_dynamic();

    while (true)
      {
        // A wild iterate must not set the scale for what follows.
        const double force = std::max(largest_force, system.force_scale());
        if (!std::isfinite(size))
          {
            result.reason = "the residual is not finite";
            return result;
          }
        result.relative_residual = force > 0 ? size / force : 0.;
        // The floor is that of the iterate: a static step from rest begins
        // without motion, hence without round-off.
        const double wanted = parameters.tolerance * force;
        const bool   stagnates =
          reduction < parameters.kept_reduction || result.iterations == 0;
        if (is_in_place && meets_conditions(norm, step.to) &&
            (size <= wanted ||
             (stagnates && size <= wanted + system.round_off_floor(step.to))))
          {
            result.converged = true;
            largest_force    = force;
            return result;
          }
        if (result.iterations == parameters.maximum_iterations)
          {
            result.reason = "Newton's method has not converged in " +
              std::to_string(result.iterations) + " iterations";
            return result;
          }

        const bool serves = factorized_dt == step.dt &&
          (system.is_linear() ||
           (parameters.keep_factorization &&
            reduction >= parameters.kept_reduction));
        if (!serves)
          {
            if (!factorize(integrator, step))
              {
                result.reason = "the tangent is singular";
                return result;
              }
            ++result.factorizations;
          }
        solve_increment(step.to);
        if (!system.is_linear() &&
            system.largest_motion(increment).second > half_turn)
          {
            result.reason =
              "an iteration turned a section by more than half a turn";
            return result;
          }
        integrator.correct(increment, step.dt, step.to);
        is_in_place = true;
        ++result.iterations;

        const double before = size;
        norm                = timed_residual(step);
        size                = in_force_units(norm);
        reduction           = before / size;
      }
  }

  void Newton::find_initial_acceleration(State &state, const double dt)
  {
    const State before = state;
    const Step  step{before, state, /*dt=*/0.};
    state.acceleration->PutScalar(0.);
    system.begin_step(step);
    system.prescribe_motion(state, dt);
    timed_residual(step);

    drop_factorization();
    system.tangent(step, {0., 0., 1.}, *matrix);
    if (has_empty_row() || !linear_solver.factorize())
      {
        system.tangent(step, {dt * dt / 4, dt / 2, 1.}, *matrix);
        refuse_empty_rows();
        if (!linear_solver.factorize())
          throw ComputationError(
            "The mass matrix is singular, so the accelerations at t = 0 are "
            "not determined. Give every moving part a density or a mass.");
      }
    if (system.rigid_parts())
      {
        project_velocities(state, dt);
        timed_residual(step);
      }
    solve_increment(state);
    state.acceleration->Update(1., increment, 1.);
    for (const int multiplier : system.numbering().multipliers())
      {
        state.displacement[multiplier] += increment[multiplier];
        (*state.acceleration)[multiplier] = 0;
      }
    if (state.algorithmic_acceleration)
      *state.algorithmic_acceleration = *state.acceleration;
    timed_residual(step);
  }

  void Newton::project_velocities(State &state, const double dt)
  {
    // Prescribed velocities are differences, given ones have few digits. What
    // these leave would ring on in multipliers and accelerations.
    constexpr double digits_of_velocities = 1e-6, part_of_first_step = 1e-3,
                     round_off_of_differences = 1e-12;

    const DofNumbering &numbering = system.numbering();
    std::vector<double> rates(numbering.n_local(), 0.);
    system.rigid_parts()->find_rates(state, rates.data());
    double mine = 0, rate = 0;
    for (const double value : rates)
      mine = std::max(mine, std::abs(value));
    numbering.communicator().MaxAll(&mine, &rate, 1);
    const double speed = system.largest_motion(*state.velocity).first,
                 acceleration =
                   system.largest_motion(*state.acceleration).first;
    if (rate > digits_of_velocities * speed +
          part_of_first_step * acceleration * dt +
          round_off_of_differences * system.length_scale() / dt)
      {
        std::ostringstream message;
        message
          << "Initial velocities: the joints of a rigid part move apart with "
          << rate
          << " m/s. Give all joints of a rigid part velocities of one rigid "
             "motion, and of one that its supports allow.";
        throw InputError(message.str());
      }
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      linear_solver.right_side()[i] = -rates[i];
    solve_for_increment();
    for (const int multiplier : numbering.multipliers())
      increment[multiplier] = 0;
    state.velocity->Update(1., increment, 1.);
  }

  bool Newton::has_empty_row() const
  {
    const std::vector<double> sizes = matrix->row_sizes();
    int                       mine = std::count(sizes.begin(), sizes.end(), 0.);
    int                       all  = 0;
    system.numbering().communicator().SumAll(&mine, &all, 1);
    return all > 0;
  }

  void Newton::refuse_empty_rows() const
  {
    if (!has_empty_row())
      return;
    std::vector<double> emptiness;
    for (const double size : matrix->row_sizes())
      emptiness.push_back(size == 0 ? 1. : 0.);
    throw InputError(
      "Nothing resists the " + system.numbering().describe_largest(emptiness) +
      ": no mass, no strut and no connector. Give the joint a mass, "
      "connect it or leave it out.");
  }

  void Newton::drop_factorization()
  {
    factorized_dt = -1;
  }

  const PhaseTimes &Newton::times() const
  {
    return phase_times;
  }

  LinearSolver &Newton::solver()
  {
    return linear_solver;
  }

  TangentMatrix &Newton::tangent()
  {
    return *matrix;
  }

  ResidualNorm Newton::timed_residual(const Step &step)
  {
    const Stopwatch watch(phase_times.residual);
    return system.residual(step);
  }

  bool Newton::factorize(const TimeIntegrator &integrator, const Step &step)
  {
    {
      const Stopwatch watch(phase_times.tangent);
      system.tangent(step, integrator.factors(step.dt), *matrix);
    }
    const Stopwatch watch(phase_times.factorize);
    factorized_dt = linear_solver.factorize() ? step.dt : -1;
    return factorized_dt >= 0;
  }

  void Newton::solve_increment(const State &trial)
  {
    const Stopwatch     watch(phase_times.solve);
    const DofNumbering &numbering = system.numbering();
    double             *rhs       = linear_solver.right_side().Values();
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      rhs[i] = -trial.residual[i];
    system.prescribed_gap(trial, rhs);
    solve_for_increment();
  }

  void Newton::solve_for_increment()
  {
    const DofNumbering  &numbering = system.numbering();
    const Epetra_Vector &solution  = linear_solver.solve();
    if (numbering.n_ranks() == 1)
      std::copy(solution.Values(),
                solution.Values() + numbering.n_owned(),
                increment.Values());
    else
      increment.Import(solution, numbering.importer(), Insert);
  }

  bool Newton::meets_conditions(const ResidualNorm &norm,
                                const State        &state) const
  {
    return norm.condition == 0 ||
      norm.condition <= system.condition_tolerance(state);
  }

  double Newton::in_force_units(const ResidualNorm &norm) const
  {
    const double moment = norm.moment / system.length_scale();
    // std::max would drop a NaN in its second place.
    return std::isfinite(moment) ? std::max(norm.force, moment) : moment;
  }
} // namespace auxfem
