#include <auxfem/analysis/newton.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/stopwatch.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
    , linear_solver(solver, *matrix, system)
    , increment(system.numbering().local_map())
  {}

  Newton::Result Newton::solve(const ImplicitScheme &scheme, const Step &step)
  {
    Result       result;
    ResidualNorm norm      = timed_residual(step);
    double       size      = in_force_units(norm);
    double       reduction = std::numeric_limits<double>::infinity();
    // Prescribed unknowns may still have to move to their place.
    bool is_in_place = scheme.is_dynamic();

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
            if (!factorize(scheme, step))
              {
                result.reason = "the tangent is singular";
                return result;
              }
            ++result.factorizations;
          }
        result.linear_iterations += solve_increment(step);
        if (!linear_solver.failure().empty())
          {
            result.reason = linear_solver.failure();
            return result;
          }
        if (!system.is_linear() &&
            system.largest_motion(increment).second > half_turn)
          {
            result.reason =
              "an iteration turned a section by more than half a turn";
            return result;
          }
        system.rotations().turn(step, increment);
        scheme.correct(increment, step.dt, step.to);
        is_in_place = true;
        ++result.iterations;

        const double before = size;
        norm                = timed_residual(step);
        size                = in_force_units(norm);
        reduction           = before / size;
      }
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

  bool Newton::factorize(const ImplicitScheme &scheme, const Step &step)
  {
    {
      const Stopwatch watch(phase_times.tangent);
      system.tangent(step, scheme.factors(step.dt), *matrix);
    }
    const Stopwatch watch(phase_times.factorize);
    factorized_dt = linear_solver.factorize() ? step.dt : -1;
    return factorized_dt >= 0;
  }

  unsigned int Newton::solve_increment(const Step &step)
  {
    const Stopwatch     watch(phase_times.solve);
    const unsigned long before = linear_solver.n_iterations();
    system.right_side(step, linear_solver.right_side().Values());
    linear_solver.solve(increment);
    return linear_solver.n_iterations() - before;
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
