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
    /** Elastic forces below this part of the loads are round-off of the answer:
     * rigid parts and supports bear the loads. */
    constexpr double no_elastic_force = 1e-10;

    [[noreturn]] void fail_to_buckle(const std::string &why)
    {
      throw ComputationError(why + '.');
    }

    /** K and K' of an equilibrium, and what is done with them. */
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
        refuse_loads_that_follow(loads.time);
        if (!factorize(0))
          throw InputError("the stiffness is singular: " + solver.why() + '.');
        if (const auto n_negative = space.n_negative();
            n_negative && *n_negative > 0)
          throw InputError(
            "the state without the loads is not stable: its stiffness has " +
            std::to_string(*n_negative) +
            " negative modes. Take smaller loads at t = 0, or Modes/About "
            "= rest.");
        find_change(linear_answer(loads.time), loads.is_reversed ? -1. : 1.);
        refuse_asymmetry();
      }

      /** K + factor K' becomes the matrix of the solver. Returns whether it can
       * be factorized. */
      bool factorize(const double factor)
      {
        TangentMatrix &matrix = solver.matrix();
        matrix.reset();
        matrix.add_multiple(1., stiffness);
        if (factor != 0)
          matrix.add_multiple(factor, change);
        return solver.factorize();
      }

      /** How many factors there are between 0 and @p factor, after which
       * factorize(0) is due; nothing where that is not known. */
      std::optional<unsigned long> n_until(const double factor)
      {
        if (!factorize(factor))
          return std::nullopt;
        return space.n_negative();
      }

      /** Those nearest to zero above it, after factorize(0). */
      Eigenpairs lowest(const unsigned int n)
      {
        Eigenpairs found = nearest_eigenpairs(problem(), n);
        if (!found.why.empty())
          return found;
        std::vector<Vector> shapes;
        for (const Eigenpair &pair : found.pairs)
          shapes.push_back(pair.vector);
        return improved(shapes);
      }

      /** Modes that there can be at most. Collective. */
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

      /** After factorize(0). */
      BucklingMode mode(const Eigenpair &pair)
      {
        // Once more, for the forces of constraints.
        std::vector<double> x(layout.n_owned());
        multiply_change(pair.vector.data(), x.data());
        if (!space.solve(x.data()))
          fail_to_buckle(solver.why());
        BucklingMode        mode{0., 0., space.shape(x)};
        std::vector<double> forces(layout.n_owned()), changes(layout.n_owned()),
          of_free(layout.n_owned());
        stiffness.multiply(mode.shape.data(), forces.data());
        space.multiply(stiffness, mode.shape.data(), of_free.data());
        multiply_change(mode.shape.data(), changes.data());
        std::vector<double> sums = {0., 0., 0., 0.};
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            sums[0] += mode.shape[i] * of_free[i];
            sums[1] += mode.shape[i] * changes[i];
          }
        sums        = layout.sum(sums);
        mode.factor = sums[0] / sums[1];
        double left = 0, all = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          if (!space.is_prescribed(i))
            {
              left += std::pow(forces[i] - mode.factor * changes[i], 2);
              all += std::pow(mode.factor * changes[i], 2);
            }
        mode.residual = std::sqrt(layout.sum(left) / layout.sum(all));
        for (double &value : mode.shape)
          value /= std::sqrt(sums[0]);
        return mode;
      }

      /**
       * As many pairs at most by rising factor, of shapes near those of modes,
       * after factorize(0).
       *
       * Lengths by K lose digits where struts are much stiffer along their axes
       * than across, and an iteration magnifies what shapes have of modes of
       * the reversed loads, where these have smaller factors. Two iterates of
       * each shape tell these apart.
       */
      Eigenpairs improved(const std::vector<Vector> &shapes)
      {
        constexpr unsigned int n_iterations = 2;
        const auto             products =
          iterated_products(problem(), shapes, n_iterations);
        if (!products)
          fail_to_buckle(solver.why());
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
      double motion_of_answer() const
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

      State with_loads_of(const double time) const
      {
        State loaded = state;
        loaded.time  = time;
        return loaded;
      }

      /** Of loads that keep their directions the tangent knows nothing. */
      void refuse_loads_that_follow(const double time)
      {
        TangentMatrix loaded(equations.pattern());
        find_tangent(with_loads_of(time), loaded);
        loaded.add_multiple(-1., stiffness);
        constexpr double round_off = 1e-13;
        if (!stiffness.is_symmetric() ||
            space.largest_free(loaded.row_sizes()) >
              round_off * space.largest_free(stiffness.row_sizes()))
          throw InputError(
            "the stiffness depends on loads that follow their joints. "
            "Buckling loads are computed for loads that keep their "
            "directions: set Direction = fixed, or leave these loads out.");
      }

      /** To what the loads of @p time change, after factorize(0). */
      Vector linear_answer(const double time)
      {
        State      loaded      = with_loads_of(time);
        Evaluation evaluation  = Evaluation::equilibrium(state, loaded);
        evaluation.event_at_to = {time, TimeSide::before};
        solver.residual(evaluation, results);
        Vector answer(layout.n_local(), 0.);
        find_right_side(solver.model(), evaluation, answer.data());
        double mine = 0;
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          mine = std::max(mine, std::abs(answer[i]));
        largest_load = layout.largest(mine);
        if (largest_load == 0)
          {
            std::ostringstream why;
            why << "no load and no prescribed motion acts at t = " << time
                << " s"
                << (state.time == time ? ""
                                       : " other than in the state that is "
                                         "looked at")
                << ". Set Modes/Time of the loads to a time at which there is "
                   "one.";
            throw InputError(why.str());
          }
        if (!solver.solve(answer))
          fail_to_buckle(solver.why());
        return answer;
      }

      void find_change(const Vector &answer, const double sign)
      {
        const LatticeModel &model           = solver.model();
        const auto [displacement, rotation] = largest_motion(model, answer);
        motion                              = loads_elastic_parts(answer)
                                       ? std::max(rotation, displacement / model.mean_strut_length)
                                       : 0.;
        find_multiplier_change(answer, sign);
        if (motion > 0)
          add_strut_and_connector_change(answer,
                                         sign * finite_difference_step /
                                           motion);
        leave_out_constraints(change);
      }

      bool loads_elastic_parts(const Vector &answer) const
      {
        std::vector<double> forces(layout.n_owned());
        space.multiply(stiffness, answer.data(), forces.data());
        return space.largest_free(forces) > no_elastic_force * largest_load;
      }

      /** @param part of the answer by which states differ from the given one. */
      void add_strut_and_connector_change(const Vector &answer,
                                          const double  part)
      {
        const DofNumbering     &numbering = solver.model().numbering;
        State                   base      = state;
        const EvaluationResults at_base   = results_at(base);
        for (const auto &[steps, weight] :
             {std::pair(1, 8.), std::pair(2, -1.)})
          {
            State before = displaced(state, numbering, answer, -steps * part),
                  after  = displaced(state, numbering, answer, steps * part);
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
        EvaluationResults of_state = equations.make_results();
        const State       before   = at;
        solver.residual(Evaluation::equilibrium(before, at), of_state);
        return of_state;
      }

      /** What the forces of constraints add: tangents are linear in them. */
      void find_multiplier_change(const Vector &answer, const double sign)
      {
        State       forced = state;
        const auto &multipliers =
          solver.model().numbering.constraints().multipliers();
        for (const int i : multipliers)
          forced.displacement[i] += sign * answer[i];
        change.reset();
        if (layout.largest(double(multipliers.size())) == 0)
          return;
        find_tangent(forced, change);
        change.add_multiple(-1., stiffness);
      }

      /** Of moments that keep their axes in space, say. */
      void refuse_asymmetry() const
      {
        constexpr double round_off_of_change = 1e-6;
        Vector           x(layout.n_local()), y(layout.n_local());
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            x[i] = space.is_free(i) ? std::sin(1. + layout.global(i)) : 0.;
            y[i] = space.is_free(i) ? std::cos(3. * layout.global(i)) : 0.;
          }
        std::vector<double> of_x(layout.n_owned()), of_y(layout.n_owned());
        multiply_change(x.data(), of_x.data());
        multiply_change(y.data(), of_y.data());
        std::vector<double> sums = {0., 0., 0., 0.};
        for (unsigned int i = 0; i < layout.n_owned(); ++i)
          {
            sums[0] += y[i] * of_x[i];
            sums[1] += x[i] * of_y[i];
            sums[2] += of_x[i] * of_x[i] + of_y[i] * of_y[i];
            sums[3] += x[i] * x[i] + y[i] * y[i];
          }
        sums = layout.sum(sums);
        if (std::abs(sums[0] - sums[1]) >
            round_off_of_change * std::sqrt(sums[2] * sums[3]))
          throw InputError(
            "the stiffness under the loads is not symmetric, as that of "
            "moments in space is not. Buckling loads are computed for "
            "forces that keep their directions.");
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
        const auto take_free = [this](double *values) {
          for (unsigned int i = 0; i < layout.n_owned(); ++i)
            if (!space.is_free(i))
              values[i] = 0;
        };
        take_free(x);
        const bool is_solved = space.solve(x);
        take_free(x);
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
     * How many factors there are up to far beyond the lowest. Refuses loads
     * that make nothing buckle; nothing where that cannot be told.
     */
    std::optional<unsigned long> n_factors(Buckling &buckling)
    {
      constexpr double       factor_of_growth = 100, far_beyond = 1e4;
      constexpr unsigned int n_looks = 16;
      double                 factor  = buckling.small_factor();
      for (unsigned int i = 0; i < n_looks; ++i, factor *= factor_of_growth)
        {
          const auto n = buckling.n_until(factor);
          if (!n)
            return std::nullopt;
          if (*n > 0)
            return buckling.n_until(far_beyond * factor);
        }
      throw InputError(
        "the loads make nothing buckle. Try Modes/Reversed loads = true.");
    }

    /** Whether there are as many factors below the widest gap among the last
     * pairs, at least @p n, as were found. */
    bool are_all_found(Buckling                     &buckling,
                       const std::vector<Eigenpair> &pairs,
                       const unsigned int            n)
    {
      const unsigned int counted = before_widest_gap(pairs, n, 0.);
      const auto         n_all =
        buckling.n_until((pairs[counted - 1].value + pairs[counted].value) / 2);
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
    const unsigned int wanted = std::min(n, n_possible);
    for (unsigned int attempt = 0; attempt < n_attempts_to_find_all; ++attempt)
      {
        if (!buckling.factorize(0))
          fail_to_buckle(solver.why());
        const unsigned int n_asked =
          std::min((wanted << attempt) + n_guard_modes, n_possible);
        const Eigenpairs near = buckling.lowest(n_asked);
        if (near.pairs.empty() || !near.why.empty())
          fail_to_buckle(near.why.empty() ? "no mode was found" : near.why);
        const unsigned int n_modes =
          std::min<std::size_t>(wanted, near.pairs.size());
        const bool can_count = n_all && n_modes < near.pairs.size();
        if (can_count && !are_all_found(buckling, near.pairs, n_modes))
          continue;
        if (!buckling.factorize(0))
          fail_to_buckle(solver.why());
        BucklingModes found;
        found.motion = buckling.motion_of_answer();
        // All there are need no count.
        found.is_counted = can_count || (n_all && near.pairs.size() == *n_all);
        found.n_possible = n_possible;
        for (unsigned int i = 0; i < n_modes; ++i)
          found.modes.push_back(buckling.mode(near.pairs[i]));
        return found;
      }
    fail_to_buckle(
      "the count of modes by the inertia of the stiffness is another than "
      "the number that was found. Set Modes/Number to another value");
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
      fail_to_buckle(solver.why());
    for (const Eigenpair &pair : buckling.improved(shapes).pairs)
      finer.values.push_back(pair.value);
    const CountLimit known = limit_below_last(finer.values, 0.);
    if (coarse.is_counted && known.limit > 0)
      if (const auto n = buckling.n_until(known.limit); n && *n > known.n_below)
        finer.n_missing = *n - known.n_below;
    return finer;
  }
} // namespace auxfem
