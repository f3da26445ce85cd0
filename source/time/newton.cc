#include <auxfem/algebra/direct_solver.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/newton.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /**
     * Larger rotation increments have left the neighbourhood of the state at
     * the start and would lead to another solution.
     */
    constexpr double half_revolution = dealii::numbers::PI;

    /**
     * Largest rotation of a section in one iteration (rad) where tangents
     * predict far larger motions: that of a straight cable from an unstressed
     * lattice that resists by tension only, and those of yielding struts.
     */
    constexpr double largest_limited_rotation = small_rotation;

    /**
     * Largest rotation increment of a step (rad) with a discrete gradient,
     * whose mean forces are singular at half a revolution.
     */
    constexpr double largest_rotation_increment = 1;

    /**
     * Part of the force scale below which a stagnating residual may be
     * round-off.
     */
    constexpr double stagnation_threshold = 1e-6;

    /**
     * Safety factor on a residual that is predicted by the last reduction and
     * not computed.
     * @tuned judgement
     */
    constexpr double residual_safety_factor = 10;

    /** Largest number of halvings in a line search, without and with inertia.
     */
    constexpr unsigned int max_static_halvings = 5, max_dynamic_halvings = 10;

    bool has_yielding_struts(const LatticeModel &model)
    {
      return std::any_of(model.laws.begin(),
                         model.laws.end(),
                         [](const auto &law) { return law && law->yields(); });
    }

    bool has_kinked_laws(const Scene &scene)
    {
      const auto has_kinks = [](const auto &definition) {
        return definition.law && definition.law->has_kinks();
      };
      return std::any_of(scene.connectors.begin(),
                         scene.connectors.end(),
                         has_kinks) ||
        std::any_of(scene.joints.begin(), scene.joints.end(), has_kinks);
    }

    /** Largest rotation increment of the step (rad) over all ranks. */
    double largest_increment(const LatticeModel &model, const Evaluation &step)
    {
      const double *before = step.from.displacement.data();
      const double *now    = step.to.displacement.data();
      double        mine   = 0;
      for (const int i : *step.to.plane_rotations)
        mine = std::max(mine, std::abs(now[i] - before[i]));
      for (const std::array<int, 3> &at : *step.to.space_rotations)
        mine = std::max(
          mine,
          (vector_at(now, at.data()) - vector_at(before, at.data())).norm());
      return model.numbering.layout().largest(mine);
    }
  } // namespace

  Newton::Newton(TangentSolver &solver, const NewtonParameters &parameters)
    : solver(solver)
    , parameters(parameters)
    , rows(solver.equations(), parameters.tolerance)
    , is_linear(solver.equations().is_linear())
    , yields(has_yielding_struts(solver.model()))
    , has_kinked_laws(auxfem::has_kinked_laws(solver.model().plan.scene))
    , supports_rest(supports_are_at_rest(solver.model()))
    , estimates_stages(parameters.estimates_stages &&
                       solver.equations().stages_need_no_residual() &&
                       solver.model().numbering.constraints().n_multipliers() ==
                         0)
    , rotations(solver.model().numbering)
  {}

  Newton::Result Newton::solve(const ImplicitScheme &scheme,
                               const Evaluation     &evaluation,
                               EvaluationResults    &results,
                               AddedEquation *const  added)
  {
    Result result;
    exactness = is_linear || has_failed || !keeps_factorization(scheme)
      ? Exactness::exact
      : Exactness::approximate;
    is_slack  = allows_slack && evaluation.from.largest_force == 0;
    // Stays set unless the iteration converges.
    has_failed = true;
    has_kinks =
      yields || has_kinked_laws || solver.equations().has_contact_candidates();
    solver.residual(evaluation, results);
    double norm = in_force_units(results);
    if (yields && scheme.is_dynamic() && added == nullptr)
      norm = try_old_positions(scheme, evaluation, results, norm);
    const bool   begins_anew    = has_kinks && !earlier_tangent_serves;
    unsigned int n_new_tangents = 0;
    double       reduction =
      begins_anew ? 0 : std::numeric_limits<double>::infinity();
    // Prescribed unknowns may not have reached their positions yet.
    bool supports_in_place = supports_rest ||
      (scheme.is_dynamic() && prescribes_all(solver.model(), evaluation));
    // Whether the residual norm grew in the iteration before.
    bool has_grown = false;
    // Excess of the last iterate; infinite if its norm was not small.
    double excess_before = std::numeric_limits<double>::infinity();

    const auto solved = [&](const double force) {
      result.converged            = true;
      has_failed                  = false;
      earlier_tangent_serves      = n_new_tangents <= (begins_anew ? 2 : 1);
      evaluation.to.largest_force = force;
      return result;
    };
    while (true)
      {
        // A diverged iterate must not set the force scale of later ones.
        const double force =
          std::max(evaluation.from.largest_force, results.force_scale);
        if (!std::isfinite(norm) || !std::isfinite(results.force_scale))
          {
            result.relative_residual = std::numeric_limits<double>::quiet_NaN();
            result.reason =
              solver.equations().nonfinite_reason(evaluation, results);
            if (result.reason.empty())
              result.reason = "the residual is not finite";
            return result;
          }
        result.relative_residual = force > 0 ? norm / force : 0.;
        const auto stagnates     = [&] {
          return result.iterations == 0
                ? norm <= stagnation_threshold * force
                : reduction < parameters.jacobian_reuse_threshold;
        };
        if (supports_in_place && meets_constraints(results, evaluation.to) &&
            is_small(evaluation, results, norm, force, stagnates()))
          {
            const double excess = rows.excess(evaluation, results);
            // The strong rows that dominate the norm may have reached
            // round-off; from here on the weak rows measure the reduction.
            reduction     = excess_before / excess;
            excess_before = excess;
            // An equilibrium needs at least one iteration: the predictor may
            // be far off in soft directions.
            if ((scheme.is_dynamic() || result.iterations > 0) &&
                (excess <= 1 ||
                 (stagnates() &&
                  rows.excess_beyond_round_off(evaluation, results) <= 1)))
              return solved(force);
          }
        else
          excess_before = std::numeric_limits<double>::infinity();
        if (result.iterations == parameters.maximum_iterations)
          {
            result.reason = "Newton's method has not converged in " +
              std::to_string(result.iterations) + " iterations";
            return result;
          }

        if (!prepare(scheme, evaluation, results, reduction))
          {
            result.reason = solver.last_failure();
            return result;
          }
        n_new_tangents += stored->is_fresh ? 1 : 0;
        result.reason = iterate(scheme, evaluation, added);
        if (!result.reason.empty())
          return result;
        // A shorter increment would leave supports on their way.
        const bool can_be_shortened = supports_in_place;
        supports_in_place           = true;
        if (result.iterations == 0 && !scheme.is_dynamic())
          first_increment = last_increment;
        ++result.iterations;
        if (added == nullptr && result.iterations == 1 &&
            can_skip_residual(evaluation, norm, force))
          {
            solver.find_stage_results(evaluation, results);
            return solved(force);
          }

        const double before = norm;
        solver.residual(evaluation, results);
        norm                = in_force_units(results);
        const bool is_worse = !(norm < before);
        if (is_worse && can_be_shortened &&
            (has_kinks || (has_grown && !scheme.is_dynamic())) &&
            before > stagnation_threshold * force)
          norm = backtrack(scheme, evaluation, results, added, before, norm);
        has_grown = is_worse;
        reduction = before / norm;
        stored->reduction.reset();
        if (result.iterations == 1 && (is_linear || !stored->is_fresh))
          stored->reduction = reduction;
      }
  }

  double Newton::try_old_positions(const ImplicitScheme &scheme,
                                   const Evaluation     &evaluation,
                                   EvaluationResults    &results,
                                   const double          norm)
  {
    const State &from = evaluation.from;
    if (!(norm > from.largest_force) || from.largest_force == 0)
      return norm;
    const State predicted = evaluation.to;
    const auto &kinds     = solver.equations().unknowns().kinds;
    increment.resize(from.displacement.size());
    for (unsigned int i = 0; i < increment.size(); ++i)
      increment[i] = kinds[i] == UnknownKind::prescribed
        ? 0
        : from.displacement[i] - predicted.displacement[i];
    scheme.correct(from, increment, evaluation.dt, evaluation.to);
    rotations.follow(evaluation);
    solver.residual(evaluation, results);
    const double old_norm = in_force_units(results);
    if (old_norm < norm)
      return old_norm;
    evaluation.to = predicted;
    solver.residual(evaluation, results);
    return norm;
  }

  void Newton::restart()
  {
    has_failed             = false;
    allows_slack           = false;
    earlier_tangent_serves = true;
    if (is_linear && stored)
      stored->reduction.reset();
    else
      stored.reset();
    solver.restart();
  }

  void Newton::factorize_ahead(const ImplicitScheme &scheme,
                               const Evaluation     &evaluation,
                               EvaluationResults    &results)
  {
    if (is_linear || !keeps_factorization(scheme))
      return;
    exactness = Exactness::approximate;
    solver.residual(evaluation, results);
    prepare(scheme,
            evaluation,
            results,
            std::numeric_limits<double>::infinity());
  }

  bool Newton::keeps_factorization(const ImplicitScheme &scheme) const
  {
    return parameters.keep_factorization && (scheme.is_dynamic() || !yields);
  }

  bool Newton::prepare(const ImplicitScheme    &scheme,
                       const Evaluation        &evaluation,
                       const EvaluationResults &results,
                       const double             reduction)
  {
    const TangentFactors factors =
      scheme.factors(evaluation.from, evaluation.dt);
    const auto matches_step = [&](const StoredFactorization &tangent) {
      return tangent.kind == evaluation.kind && tangent.dt == evaluation.dt &&
        tangent.factors == factors &&
        tangent.pattern_version == solver.equations().pattern().version();
    };
    if (stored && matches_step(*stored) &&
        (is_linear ||
         (keeps_factorization(scheme) &&
          reduction >= parameters.jacobian_reuse_threshold)))
      {
        stored->is_fresh = false;
        return true;
      }
    // The symmetric part is too far from the tangent if it does not even serve
    // at its own state.
    if (stored && stored->is_fresh && !stored->is_exact &&
        reduction < parameters.jacobian_reuse_threshold)
      exactness = Exactness::exact;
    stored.reset();
    solver.assemble(evaluation, results, factors);
    if (!solver.factorize(exactness))
      return false;
    adopt_factorization(evaluation, factors);
    return true;
  }

  bool Newton::allow_slack(const State &start)
  {
    // Moving supports would not reach their positions with limited increments.
    if (allows_slack || is_linear || !supports_rest || start.largest_force > 0)
      return false;
    allows_slack = true;
    return true;
  }

  void Newton::adopt_factorization(const Evaluation     &evaluation,
                                   const TangentFactors &factors)
  {
    stored = StoredFactorization{evaluation.kind,
                                 evaluation.dt,
                                 factors,
                                 solver.matrix().version(),
                                 solver.linear_solver().is_exact(),
                                 /*is_fresh=*/true};
#ifndef DEBUG // where solutions are checked by it
    // Linear equations keep the factorization for the whole run.
    if (is_linear)
      solver.matrix().release();
#endif
  }

  std::string Newton::iterate(const ImplicitScheme &scheme,
                              const Evaluation     &evaluation,
                              AddedEquation *const  added)
  {
    const LatticeModel &model = solver.model();
    increment.resize(evaluation.to.displacement.size());
    find_right_side(model, evaluation, increment.data());
    if (!solver.solve(increment) ||
        (added != nullptr && !added->complete(solver, evaluation, increment)))
      return solver.last_failure();
    if (!is_linear)
      {
        const double turn       = largest_motion(model, increment).second;
        const bool   is_limited = is_slack || (yields && scheme.is_dynamic());
        if (is_limited && turn > largest_limited_rotation)
          scale(largest_limited_rotation / turn, increment);
        else if (!(turn <= half_revolution))
          return "an iteration turned a section by more than half a turn";
      }
    if (!scheme.is_dynamic() || has_kinks)
      last_increment = increment;
    rotations.rotate(evaluation, increment);
    scheme.correct(evaluation.from, increment, evaluation.dt, evaluation.to);
    if (evaluation.kind == Evaluation::Kind::discrete_gradient &&
        !(largest_increment(model, evaluation) <= largest_rotation_increment))
      return "the step turns a section by more than 1 rad, too far for mean "
             "forces";
    return "";
  }

  double Newton::backtrack(const ImplicitScheme &scheme,
                           const Evaluation     &evaluation,
                           EvaluationResults    &results,
                           AddedEquation *const  added,
                           const double          before,
                           const double          full)
  {
    // Without inertia only whole increments lead away from where all of them
    // enlarge the norm; with it contact is met after a small part of one.
    const unsigned int n_halvings =
      scheme.is_dynamic() ? max_dynamic_halvings : max_static_halvings;
    double length = 1, best_length = 1, best = scheme.is_dynamic() ? full : 0;
    for (unsigned int i = 0; i < n_halvings; ++i)
      {
        length /= 2;
        const double norm =
          undo_increment(scheme, evaluation, results, added, length);
        if (norm < before)
          return norm;
        if (norm < best)
          {
            best        = norm;
            best_length = length;
          }
      }
    return best_length == length ? best
                                 : undo_increment(scheme,
                                                  evaluation,
                                                  results,
                                                  added,
                                                  length - best_length);
  }

  double Newton::undo_increment(const ImplicitScheme &scheme,
                                const Evaluation     &evaluation,
                                EvaluationResults    &results,
                                AddedEquation *const  added,
                                const double          part)
  {
    solver.count_backtrack();
    increment = last_increment;
    scale(-part, increment);
    if (added != nullptr)
      added->undo_increment(evaluation, increment, part);
    rotations.rotate(evaluation, increment);
    scheme.correct(evaluation.from, increment, evaluation.dt, evaluation.to);
    solver.residual(evaluation, results);
    return in_force_units(results);
  }

  bool Newton::is_small(const Evaluation        &evaluation,
                        const EvaluationResults &results,
                        const double             norm,
                        const double             scale,
                        const bool               stagnates) const
  {
    const double allowed = parameters.tolerance * scale;
    // The round-off floor must be that of the iterate: a static step starts
    // without motion, hence without round-off.
    return norm <= allowed ||
      (stagnates &&
       norm <=
         allowed + solver.equations().round_off_floor(evaluation, results));
  }

  bool Newton::can_skip_residual(const Evaluation &evaluation,
                                 const double      norm,
                                 const double      scale) const
  {
    return estimates_stages && !has_kinks && stored->reduction &&
      evaluation.kind == Evaluation::Kind::stage && !evaluation.ends_step &&
      residual_safety_factor * norm <=
      *stored->reduction * parameters.tolerance * scale;
  }

  bool Newton::meets_constraints(const EvaluationResults &results,
                                 const State             &state) const
  {
    return results.constraint == 0 ||
      results.constraint <= constraint_tolerance(solver.equations(), state);
  }

  double Newton::in_force_units(const EvaluationResults &results) const
  {
    const double moment = results.moment / solver.model().mean_strut_length;
    // std::max would drop a NaN in its second argument.
    return std::isfinite(moment) ? std::max(results.force, moment) : moment;
  }
} // namespace auxfem
