#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/equations/mode_space.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/time/large_rotation_error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace auxfem
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /**
     * Whether a @p rotation (rad) alone exceeds the allowed error, by the
     * difference of its sine and cosine from angle and one.
     */
    bool is_large(const double rotation, const double allowed)
    {
      /**
       * Rotation above which the error of small displacements is too large to
       * be computed.
       * @tuned [rad] theory: the cosine then differs from one by 1.1 %
       */
      constexpr double small_angle = 0.15;
      return !(rotation < small_angle && rotation * rotation / 2 <= allowed);
    }

    /**
     * Newton's method determines the error to a tenth of itself, or to a
     * hundredth of the allowed one.
     */
    constexpr unsigned int most_iterations = 8;
    constexpr double       accuracy = 0.1, accuracy_of_tolerance = 0.01;

    State at_rest(const Equations &equations)
    {
      State rest = equations.initial_state();
      for (std::optional<Vector> *rates : {&rest.velocity, &rest.acceleration})
        if (*rates)
          (*rates)->assign((*rates)->size(), 0.);
      return rest;
    }

    /** Times at which loads are sampled. */
    std::vector<TimeLimit> times_of_loads(const RunPlan &plan)
    {
      constexpr unsigned int n_times = 4, n_events = 8;
      std::vector<TimeLimit> times;
      for (unsigned int i = 1; i <= n_times; ++i)
        times.push_back({plan.time.end_time * i / n_times, TimeSide::before});
      const std::vector<StepEnd> ends = step_ends(plan);
      for (std::size_t i = 0; i < ends.size() && i < n_events; ++i)
        if (ends[i].time < plan.time.end_time)
          for (const TimeSide side : {TimeSide::before, TimeSide::after})
            times.push_back({ends[i].time, side});
      return times;
    }

    /** Largest translation of joints over all ranks (m). */
    double largest_joint_translation(const LatticeModel &model,
                                     const Vector       &motion)
    {
      const DofNumbering &numbering = model.numbering;
      double              mine      = 0;
      for (unsigned int joint = 0; joint < model.lattice.joints.size(); ++joint)
        for (unsigned int c = 0; c < model.lattice.dimension; ++c)
          if (numbering.joint_has(joint, c))
            if (const int i = numbering.joint_unknown(joint, c); i >= 0)
              mine = std::max(mine, std::abs(motion[i]));
      return numbering.layout().largest(mine);
    }

    /**
     * Translation of @p error over @p motion, see
     * LargeRotationError::translation.
     */
    double relative_translation(const LatticeModel &model,
                                const Vector       &error,
                                const Vector       &motion)
    {
      // Part of the largest translation of all nodes.
      constexpr double smallest_joint_fraction = 0.1;
      const double joint_translation = largest_joint_translation(model, motion),
                   node_translation  = largest_motion(model, motion).first;
      return joint_translation >= smallest_joint_fraction * node_translation
        ? largest_joint_translation(model, error) / joint_translation
        : largest_motion(model, error).first / node_translation;
    }

    std::string location_of(const LatticeModel &model, const Vector &error)
    {
      const DofNumbering &numbering = model.numbering;
      std::vector<double> sizes(numbering.layout().n_owned());
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::abs(error[i]) *
          (numbering.unknowns().is_rotation[i] ? model.mean_strut_length : 1.);
      return describe_largest(numbering, sizes);
    }
  } // namespace

  std::string small_displacement_error_text(const double error)
  {
    return "the estimated error of small displacements is " +
      percentage_text(error);
  }

  std::string LargeRotationError::reason(const double allowed) const
  {
    if (is_large(rotation, allowed))
      return "rotations reach " + rounded_text(rotation, 2) + " rad";
    if (!std::isfinite(relative))
      return "the error of small displacements cannot be estimated";
    if (relative > allowed)
      return small_displacement_error_text(relative) + ", largest in the " +
        location;
    return is_unstable ? "the stiffness is not positive" : "";
  }

  LargeRotationErrorEstimator::LargeRotationErrorEstimator(
    const Equations &small,
    const Equations &exact,
    const double     allowed)
    : plan(exact.model().plan)
    , small(small)
    , exact(exact)
    , allowed(allowed)
    , inertia(plan.time.scheme->is_dynamic()
                ? std::pow(2 / plan.time.end_time, 2)
                : 0.)
  {}

  double LargeRotationErrorEstimator::size(const Vector &motion) const
  {
    const LatticeModel       &model  = exact.model();
    const OwnedRows          &rows   = model.rows;
    const double              length = model.mean_strut_length;
    const std::vector<double> all    = model.numbering.layout().sum(
      {sum_of_squares(motion.data(), rows.free_translations) +
            length * length * sum_of_squares(motion.data(), rows.free_rotations),
          double(rows.free_translations.size() + rows.free_rotations.size())});
    return all[1] > 0 ? std::sqrt(all[0] / all[1]) : 0;
  }

  bool
  LargeRotationErrorEstimator::factorize_at_rest(TangentSolver &solver) const
  {
    const State       before     = at_rest(exact);
    State             now        = before;
    EvaluationResults results    = exact.make_results();
    const Evaluation  evaluation = Evaluation::equilibrium(before, now);
    try
      {
        solver.residual(evaluation, results);
        solver.assemble(evaluation, results, {1., 0., inertia});
        return solver.factorize(Exactness::approximate);
      }
    catch (const ComputationError &)
      {
        // A load is not finite at t = 0; the run itself reports it.
        return false;
      }
  }

  std::optional<Vector>
  LargeRotationErrorEstimator::linear_answer(const TimeLimit &time,
                                             TangentSolver   &solver) const
  {
    const State rest             = at_rest(exact);
    State       loaded           = rest;
    loaded.time                  = time.time;
    EvaluationResults results    = exact.make_results();
    Evaluation        evaluation = Evaluation::equilibrium(rest, loaded);
    evaluation.event_at_to       = time;
    Vector motion(loaded.displacement.size(), 0.);
    try
      {
        solver.residual(evaluation, results);
        find_right_side(exact.model(), evaluation, motion.data());
      }
    catch (const ComputationError &)
      {
        // A load is not finite; the run itself reports it when it gets there.
        return {};
      }
    return solver.solve(motion) ? std::optional<Vector>(motion) : std::nullopt;
  }

  std::optional<State> LargeRotationErrorEstimator::static_answer()
  {
    TangentSolver solver(exact, plan.solver, work);
    if (!factorize_at_rest(solver))
      return {};
    State  answer  = at_rest(small);
    double largest = 0;
    for (const TimeLimit &time : times_of_loads(plan))
      if (std::optional<Vector> motion = linear_answer(time, solver);
          motion && size(*motion) > largest)
        {
          largest             = size(*motion);
          answer.displacement = std::move(*motion);
        }
    if (largest == 0)
      return {};
    EvaluationResults results    = small.make_results();
    const State       before     = answer;
    const Evaluation  evaluation = Evaluation::equilibrium(before, answer);
    small.residual(evaluation, results);
    small.accept(evaluation, results);
    return answer;
  }

  State LargeRotationErrorEstimator::exact_state(const Vector &motion,
                                                 const Vector &error) const
  {
    Vector moved = motion;
    add_multiple(1., error, moved);
    State state = displaced(at_rest(exact), exact.model().numbering, moved, 1.);
    if (state.acceleration)
      add_multiple(inertia, error, *state.acceleration);
    return state;
  }

  bool LargeRotationErrorEstimator::find_error(const Vector &motion,
                                               const bool uses_rest_stiffness,
                                               TangentSolver &solver,
                                               Vector        &error) const
  {
    std::fill(error.begin(), error.end(), 0.);
    const DofNumbering &numbering = exact.model().numbering;
    State       linear = displaced(at_rest(small), numbering, motion, 1.);
    const State before = linear;
    {
      EvaluationResults results = small.make_results();
      small.residual(Evaluation::equilibrium(before, linear), results);
    }
    EvaluationResults results = exact.make_results();
    double            last = infinity, before_last = infinity;
    bool              is_reducing = uses_rest_stiffness;
    for (unsigned int i = 0; i < most_iterations; ++i)
      {
        State            now        = exact_state(motion, error);
        const State      start      = now;
        const Evaluation evaluation = Evaluation::equilibrium(start, now);
        solver.residual(evaluation, results);
        if (!is_reducing)
          solver.assemble(evaluation, results, {1., 0., inertia});
        Vector change(error.size(), 0.);
        for (unsigned int row = 0; row < numbering.layout().n_owned(); ++row)
          if (numbering.unknowns().kinds[row] != UnknownKind::prescribed)
            change[row] = linear.residual[row] - now.residual[row];
        if ((!is_reducing && !solver.factorize(Exactness::approximate)) ||
            !solver.solve(change))
          return false;
        add_multiple(1., change, error);
        const double change_size = size(change);
        if (change_size <=
            std::max(accuracy * size(error),
                     accuracy_of_tolerance * allowed * size(motion)))
          return true;
        is_reducing = plan.newton.jacobian_reuse_threshold * change_size <=
          (uses_rest_stiffness ? before_last : last);
        if (uses_rest_stiffness && !is_reducing)
          return false;
        before_last = std::exchange(last, change_size);
      }
    return false;
  }

  bool LargeRotationErrorEstimator::is_positive(State          state,
                                                TangentSolver &solver) const
  {
    const State       before     = state;
    EvaluationResults results    = exact.make_results();
    const Evaluation  evaluation = Evaluation::equilibrium(before, state);
    solver.residual(evaluation, results);
    solver.assemble(evaluation, results, {1., 0., inertia});
    if (!solver.factorize(Exactness::approximate))
      return false;
    if (const auto modes = solver.new_negative_modes())
      return modes->n == 0;
    return ModeSpace(solver).determinant_sign().value_or(1) > 0;
  }

  LargeRotationError LargeRotationErrorEstimator::at(const Vector &motion)
  {
    const LatticeModel &model = exact.model();
    LargeRotationError  result;
    result.rotation = largest_motion(model, motion).second;
    result.relative = result.translation = infinity;
    if (is_large(result.rotation, allowed))
      return result;
    TangentSolver solver(exact, plan.solver, work);
    Vector        error(motion.size(), 0.);
    if (!factorize_at_rest(solver) ||
        !(find_error(motion, /*uses_rest_stiffness=*/true, solver, error) ||
          find_error(motion, /*uses_rest_stiffness=*/false, solver, error)))
      return result;
    result.relative    = size(error) / size(motion);
    result.translation = relative_translation(model, error, motion);
    result.location    = location_of(model, error);
    if (result.relative <= allowed)
      result.is_unstable = !is_positive(exact_state(motion, error), solver);
    return result;
  }
} // namespace auxfem
