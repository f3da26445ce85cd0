#include <auxfem/algebra/ritz_pairs.h>
#include <auxfem/analysis/small_motions/buckling_modes.h>
#include <auxfem/equations/mode_space.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /**
     * Elastic forces below this fraction of the loads are round-off: rigid
     * parts and supports carry the loads.
     */
    constexpr double no_elastic_force = 1e-10;

    [[noreturn]] void throw_buckling_error(const std::string &why)
    {
      throw ComputationError(why + '.');
    }

    /** Stiffness K and geometric stiffness K' of an equilibrium. */
    class Buckling
    {
    public:
      Buckling(TangentSolver       &solver,
               const State         &state,
               const BucklingLoads &loads)
        : solver(solver)
        , space(solver)
        , equations(solver.equations())
        , layout(equations.unknowns().layout)
        , state(state)
        , results(equations.make_results())
        , stiffness(equations.pattern())
        , change(equations.pattern())
      {
        find_tangent(state, stiffness);
        require_no_follower_loads();
        if (!factorize(0))
          throw InputError(
            "the stiffness is singular: " + solver.last_failure() + '.');
        if (const auto n_negative = space.n_negative();
            n_negative && *n_negative > 0)
          throw InputError(
            "the state without the loads is not stable: its stiffness has " +
            std::to_string(*n_negative) +
            " negative eigenvalues. Reduce the loads at t = 0, or set "
            "Modes/About = rest.");
        find_change(linear_response(loads.time), loads.is_reversed ? -1. : 1.);
        require_symmetry();
      }

      /**
       * Factorizes K + factor K' in the solver. Returns false if that fails.
       */
      bool factorize(const double factor)
      {
        TangentMatrix &matrix = solver.matrix();
        matrix.reset();
        matrix.add_multiple(1., stiffness);
        if (factor != 0)
          matrix.add_multiple(factor, change);
        return solver.factorize();
      }

      /**
       * Number of factors between 0 and @p factor; empty if unknown. The caller
       * must call factorize(0) afterwards.
       */
      std::optional<unsigned long> count_below(const double factor)
      {
        if (!factorize(factor))
          return std::nullopt;
        return space.n_negative();
      }

      /** Smallest positive factors; requires factorize(0). */
      Eigenpairs lowest(const unsigned int n)
      {
        Eigenpairs found = nearest_eigenpairs(problem(), n);
        if (!found.failure_reason.empty())
          return found;
        std::vector<Vector> shapes;
        for (const Eigenpair &pair : found.pairs)
          shapes.push_back(pair.vector);
        return improved(shapes);
      }

      /** Upper bound of the number of modes. Collective. */
      unsigned int n_with_change() const
      {
        const std::vector<double> sizes   = change.row_sizes();
        const double              largest = space.largest_free(sizes);
        double                    n       = 0;
        for (unsigned int i = 0; i < sizes.size(); ++i)
          if (space.is_free(i) && sizes[i] > sqrt_round_off * largest)
            ++n;
        return std::min<unsigned int>(space.n_free(), layout.sum(n));
      }

      /** A factor far below the lowest: the smallest K_ii / |K'_ii|. */
      double small_factor() const
      {
        const std::vector<double> springs = stiffness.diagonal(),
                                  changes = change.diagonal();
        double largest                    = 0;
        for (unsigned int i = 0; i < springs.size(); ++i)
          if (space.is_free(i) && springs[i] > 0)
            largest = std::max(largest, std::abs(changes[i]) / springs[i]);
        largest = layout.largest(largest);
        return largest > 0 ? 1e-6 / largest : 1.;
      }

      /** Mode of an eigenpair; requires factorize(0). */
      BucklingMode mode(const Eigenpair &pair)
      {
        // One further iteration yields the constraint forces.
        std::vector<double> x(layout.n_owned());
        multiply_change(pair.vector.data(), x.data());
        if (!space.solve(x.data()))
          throw_buckling_error(solver.last_failure());
        BucklingMode        mode{0., 0., space.shape(x)};
        std::vector<double> forces(layout.n_owned()), changes(layout.n_owned()),
          free_forces(layout.n_owned());
        stiffness.multiply(mode.shape.data(), forces.data());
        space.multiply(stiffness, mode.shape.data(), free_forces.data());
        multiply_change(mode.shape.data(), changes.data());
        std::vector<double> sums = {0., 0., 0., 0.};
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            sums[0] += mode.shape[i] * free_forces[i];
            sums[1] += mode.shape[i] * changes[i];
          }
        sums                    = layout.sum(sums);
        mode.factor             = sums[0] / sums[1];
        double squared_residual = 0, squared_norm = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (!space.is_prescribed(i))
            {
              squared_residual +=
                std::pow(forces[i] - mode.factor * changes[i], 2);
              squared_norm += std::pow(mode.factor * changes[i], 2);
            }
        mode.residual =
          std::sqrt(layout.sum(squared_residual) / layout.sum(squared_norm));
        for (double &value : mode.shape)
          value /= std::sqrt(sums[0]);
        return mode;
      }

      /**
       * Improves shapes near those of modes; returns at most as many pairs, by
       * increasing factor. Requires factorize(0). Modes of the reversed loads
       * with smaller factors grow in an iteration; two iterates of each shape
       * separate them.
       */
      Eigenpairs improved(const std::vector<Vector> &shapes)
      {
        constexpr unsigned int n_iterations = 2;
        const auto             products =
          iterated_products(problem(), shapes, n_iterations);
        if (!products)
          throw_buckling_error(solver.last_failure());
        Eigenpairs      result;
        const RitzPairs ritz =
          ritz_pairs(products->by_mass, products->by_stiffness);
        for (std::size_t j = 0; j < ritz.values.size() &&
             result.pairs.size() < shapes.size() && ritz.values[j] > 0;
             ++j)
          result.pairs.push_back(
            {1 / ritz.values[j], products->combination(ritz.coefficients, j)});
        return result;
      }

      /** BucklingModes::motion. */
      double response_size() const
      {
        return motion;
      }

    private:
      ShiftedEigenproblem problem()
      {
        return {layout,
                /*shift=*/0.,
                [this](const double *x, double *y) { multiply_change(x, y); },
                [this](double *x) { return solve_free(x); },
                n_with_change(),
                [this](const double *x, double *y) {
                  space.multiply(stiffness, x, y);
                },
                /*only_above=*/true};
      }

      void find_tangent(const State &at, TangentMatrix &matrix)
      {
        State            now        = at;
        const Evaluation evaluation = Evaluation::equilibrium(at, now);
        solver.residual(evaluation, results);
        equations.tangent(evaluation, results, {1, 0, 0}, matrix);
      }

      State state_with_loads(const double time) const
      {
        State loaded = state;
        loaded.time  = time;
        return loaded;
      }

      /** Loads that turn with the structure have a stiffness of their own. */
      void require_no_follower_loads() const
      {
        const RunPlan &plan   = equations.model().plan;
        const auto    &loads  = plan.joint_loads();
        const bool     follow = !plan.scene.pressures.empty() ||
          std::any_of(loads.begin(),
                      loads.end(),
                      [](const JointLoadDefinition &load) {
                        return load.follows_joint && !load.is_zero();
                      });
        if (follow || !stiffness.is_symmetric())
          throw InputError(
            "loads follow their joints or struts, so the stiffness depends on "
            "them. Buckling analysis requires loads of fixed direction: set "
            "Direction = fixed, or remove these loads.");
      }

      /**
       * Linear response to the load increment up to @p time; requires
       * factorize(0).
       */
      Vector linear_response(const double time)
      {
        State      loaded      = state_with_loads(time);
        Evaluation evaluation  = Evaluation::equilibrium(state, loaded);
        evaluation.event_at_to = {time, TimeSide::before};
        solver.residual(evaluation, results);
        Vector response(layout.n_local(), 0.);
        find_right_side(solver.model(), evaluation, response.data());
        double local_largest = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          local_largest = std::max(local_largest, std::abs(response[i]));
        largest_load = layout.largest(local_largest);
        if (largest_load == 0)
          {
            std::ostringstream why;
            why << "no load and no prescribed motion acts at t = " << time
                << " s"
                << (state.time == time ? ""
                                       : " beyond those of the reference state")
                << ". Set Modes/Time of the loads to a time at which a "
                   "load acts.";
            throw InputError(why.str());
          }
        if (!solver.solve(response))
          throw_buckling_error(solver.last_failure());
        return response;
      }

      void find_change(const Vector &response, const double sign)
      {
        const LatticeModel &model           = solver.model();
        const auto [displacement, rotation] = largest_motion(model, response);
        motion                              = loads_elastic_parts(response)
                                       ? std::max(rotation, displacement / model.mean_strut_length)
                                       : 0.;
        find_multiplier_change(response, sign);
        if (motion > 0)
          add_strut_and_connector_change(response,
                                         sign * finite_difference_step /
                                           motion);
        clear_constraint_entries(change);
      }

      bool loads_elastic_parts(const Vector &response) const
      {
        std::vector<double> forces(layout.n_owned());
        space.multiply(stiffness, response.data(), forces.data());
        return space.largest_free(forces) > no_elastic_force * largest_load;
      }

      /** @param part fraction of the response that displaces the states */
      void add_strut_and_connector_change(const Vector &response,
                                          const double  part)
      {
        const DofNumbering     &numbering = solver.model().numbering;
        State                   base      = state;
        const EvaluationResults at_base   = results_at(base);
        for (const auto &[steps, weight] :
             {std::pair(1, 8.), std::pair(2, -1.)})
          {
            State before = displaced(state, numbering, response, -steps * part),
                  after  = displaced(state, numbering, response, steps * part);
            const EvaluationResults at_before = results_at(before),
                                    at_after  = results_at(after);
            equations.add_geometric_tangent({base,
                                             before,
                                             after,
                                             at_base,
                                             at_before,
                                             at_after,
                                             weight / (12 * std::abs(part))},
                                            change);
          }
      }

      EvaluationResults results_at(State &at)
      {
        EvaluationResults results_there = equations.make_results();
        const State       before        = at;
        solver.residual(Evaluation::equilibrium(before, at), results_there);
        return results_there;
      }

      /** Contribution of constraint forces, in which the tangent is linear. */
      void find_multiplier_change(const Vector &response, const double sign)
      {
        State       forced = state;
        const auto &multipliers =
          solver.model().numbering.constraints().multipliers();
        for (const int i : multipliers)
          forced.displacement[i] += sign * response[i];
        change.reset();
        if (layout.largest(double(multipliers.size())) == 0)
          return;
        find_tangent(forced, change);
        change.add_multiple(-1., stiffness);
      }

      /** Moments of fixed axes in space, for example, are not conservative. */
      void require_symmetry() const
      {
        constexpr double round_off_of_change = 1e-6;
        Vector           x(layout.n_local()), y(layout.n_local());
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            x[i] = space.is_free(i) ? std::sin(1. + layout.global(i)) : 0.;
            y[i] = space.is_free(i) ? std::cos(3. * layout.global(i)) : 0.;
          }
        std::vector<double> image_x(layout.n_owned()),
          image_y(layout.n_owned());
        multiply_change(x.data(), image_x.data());
        multiply_change(y.data(), image_y.data());
        std::vector<double> sums = {0., 0., 0., 0.};
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            sums[0] += y[i] * image_x[i];
            sums[1] += x[i] * image_y[i];
            sums[2] += image_x[i] * image_x[i] + image_y[i] * image_y[i];
            sums[3] += x[i] * x[i] + y[i] * y[i];
          }
        sums = layout.sum(sums);
        if (std::abs(sums[0] - sums[1]) >
            round_off_of_change * std::sqrt(sums[2] * sums[3]))
          throw InputError(
            "the stiffness under the loads is not symmetric, for example "
            "because of moments in space. Buckling analysis requires forces of "
            "fixed direction.");
      }

      /** @p y = -K' x between free unknowns. */
      void multiply_change(const double *x, double *y) const
      {
        space.multiply(change, x, y);
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          y[i] = -y[i];
      }

      /** K^-1 between free unknowns. */
      bool solve_free(double *x)
      {
        const auto zero_constrained = [this](double *values) {
          for (unsigned int i = 0; i < layout.n_owned(); ++i)
            if (!space.is_free(i))
              values[i] = 0;
        };
        zero_constrained(x);
        const bool is_solved = space.solve(x);
        zero_constrained(x);
        return is_solved;
      }

      TangentSolver       &solver;
      ModeSpace            space;
      const Equations     &equations;
      const UnknownLayout &layout;
      const State         &state;
      double               motion = 0, largest_load = 0;
      EvaluationResults    results;
      TangentMatrix        stiffness, change;
    };

    /**
     * Number of factors up to far beyond the lowest; empty if unknown. Throws
     * InputError if the loads cause no buckling.
     */
    std::optional<unsigned long> n_factors(Buckling &buckling)
    {
      constexpr double       factor_of_growth = 100, far_beyond = 1e4;
      constexpr unsigned int n_trials = 16;
      double                 factor   = buckling.small_factor();
      for (unsigned int i = 0; i < n_trials; ++i, factor *= factor_of_growth)
        {
          const auto n = buckling.count_below(factor);
          if (!n)
            return std::nullopt;
          if (*n > 0)
            return buckling.count_below(far_beyond * factor);
        }
      throw InputError(
        "the loads cause no buckling. Try Modes/Reversed loads = true.");
    }

    /**
     * Whether the number of factors below the widest gap among the last pairs,
     * beyond the first @p n, equals the number found.
     */
    bool are_all_found(Buckling                     &buckling,
                       const std::vector<Eigenpair> &pairs,
                       const unsigned int            n)
    {
      const unsigned int counted = count_before_widest_gap(pairs, n, 0.);
      const auto         n_all   = buckling.count_below(
        (pairs[counted - 1].value + pairs[counted].value) / 2);
      return n_all && *n_all == counted;
    }
  } // namespace

  BucklingModes buckling_modes(TangentSolver       &solver,
                               const State         &state,
                               const BucklingLoads &loads,
                               const unsigned int   n)
  {
    Buckling           buckling(solver, state, loads);
    const auto         n_all = n_factors(buckling);
    const unsigned int n_possible =
      std::min<unsigned long>(buckling.n_with_change(),
                              n_all.value_or(buckling.n_with_change()));
    const unsigned int n_requested = std::min(n, n_possible);
    for (unsigned int attempt = 0; attempt < n_attempts_to_find_all; ++attempt)
      {
        if (!buckling.factorize(0))
          throw_buckling_error(solver.last_failure());
        const unsigned int n_computed =
          std::min((n_requested << attempt) + n_guard_modes, n_possible);
        const Eigenpairs near = buckling.lowest(n_computed);
        if (near.pairs.empty() || !near.failure_reason.empty())
          throw_buckling_error(near.failure_reason.empty()
                                 ? "no mode was found"
                                 : near.failure_reason);
        const unsigned int n_modes =
          std::min<std::size_t>(n_requested, near.pairs.size());
        const bool can_count = n_all && n_modes < near.pairs.size();
        if (can_count && !are_all_found(buckling, near.pairs, n_modes))
          continue;
        if (!buckling.factorize(0))
          throw_buckling_error(solver.last_failure());
        BucklingModes found;
        found.motion = buckling.response_size();
        // A complete set needs no count.
        found.is_counted = can_count || (n_all && near.pairs.size() == *n_all);
        found.n_possible = n_possible;
        for (unsigned int i = 0; i < n_modes; ++i)
          found.modes.push_back(buckling.mode(near.pairs[i]));
        return found;
      }
    throw_buckling_error(
      "the inertia of the stiffness counts another number of modes than were "
      "found, so some may be missing. Set Modes/Number to another value");
  }

  FinerValues finer_factors(TangentSolver             &solver,
                            const State               &state,
                            const BucklingLoads       &loads,
                            const BucklingModes       &coarse,
                            const std::vector<Vector> &shapes)
  {
    Buckling    buckling(solver, state, loads);
    FinerValues finer;
    finer.n_possible = buckling.n_with_change();
    if (!buckling.factorize(0))
      throw_buckling_error(solver.last_failure());
    for (const Eigenpair &pair : buckling.improved(shapes).pairs)
      finer.values.push_back(pair.value);
    const CountLimit known = limit_below_last(finer.values, 0.);
    if (coarse.is_counted && known.limit > 0)
      if (const auto n = buckling.count_below(known.limit);
          n && *n > known.n_below)
        finer.n_missing = *n - known.n_below;
    return finer;
  }
} // namespace auxfem
