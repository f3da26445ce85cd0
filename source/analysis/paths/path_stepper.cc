#include <auxfem/analysis/paths/path_stepper.h>
#include <auxfem/equations/mode_space.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Factors of a static tangent. */
    constexpr TangentFactors stiffness_alone = {1., 0., 0.};
  } // namespace

  PathStepper::PathStepper(TangentSolver          &solver,
                           const NewtonParameters &parameters)
    : solver(solver)
    , equations(solver.equations())
    , newton(solver, parameters)
    , space(solver)
    , path_metric(solver.model())
    , rotations(solver.model().numbering)
  {}

  PathPoint PathStepper::start(const Solution &solution, const bool is_reversed)
  {
    Solution         at{solution.state, equations.make_results()};
    const Evaluation instant =
      Evaluation::equilibrium(solution.state, at.state);
    solver.residual(instant, at.results);
    auto tangent = find_tangent(instant, at.results, nullptr);
    if (!tangent)
      throw ComputationError(
        "The path of equilibria cannot start, because its tangent cannot be "
        "computed: " +
        solver.last_failure() + '.');
    if (!std::isfinite(tangent->load_rate))
      throw InputError(
        "Analysis = static path: no load and no prescribed motion acts at "
        "Path/Time of the loads. Set it to a time at which there is one.");
    if (is_reversed)
      {
        scale(-1., tangent->direction);
        tangent->load_rate *= -1;
      }
    return {std::move(at), std::move(*tangent)};
  }

  PathStep PathStepper::step(const PathPoint   &from,
                             const PathTangent &prediction,
                             const double       length)
  {
    Solution         end{from.solution.state, equations.make_results()};
    const Evaluation step =
      Evaluation::static_step(from.solution.state, end.state, length);
    predict(step, prediction, length);
    ArcLength arc_length(path_metric, prediction, length);
    PathStep  result = solve(step, end, prediction.direction, &arc_length);
    if (!result.point)
      return result;
    result.deviation      = arc_length.deviation();
    result.load_deviation = arc_length.load_deviation();
    PathTangent &tangent  = result.point->tangent;
    tangent.curvature     = tangent.direction;
    add_multiple(-1., prediction.direction, tangent.curvature);
    scale(1 / length, tangent.curvature);
    tangent.load_curvature =
      (tangent.load_rate - prediction.load_rate) / length;
    return result;
  }

  PathStep PathStepper::step_to_load(const PathPoint &from,
                                     const double     length,
                                     const double     load_factor)
  {
    Solution         end{from.solution.state, equations.make_results()};
    const Evaluation step =
      Evaluation::static_step(from.solution.state, end.state, length);
    predict(step, from.tangent, length);
    end.state.path->load_factor = load_factor;
    return solve(step, end, from.tangent.direction, nullptr);
  }

  void PathStepper::predict(const Evaluation  &step,
                            const PathTangent &prediction,
                            const double       length) const
  {
    rule.predict(step.from, step.dt, step.to);
    step.to.time = step.from.time + length;
    step.to.path->load_factor +=
      length * prediction.load_rate + prediction.load_deviation(length);
    Vector increment = prediction.deviation(length);
    add_multiple(length, prediction.direction, increment);
    rotations.follow(step);
    rotations.rotate(step, increment);
    rule.correct(step.from, increment, step.dt, step.to);
  }

  PathStep PathStepper::solve(const Evaluation &step,
                              Solution         &end,
                              const Vector     &sense,
                              AddedEquation    *arc_length)
  {
    newton.drop_factorization();
    const Newton::Result solved =
      newton.solve(rule, step, end.results, arc_length);
    PathStep result;
    result.iterations        = solved.iterations;
    result.relative_residual = solved.relative_residual;
    result.failure_reason    = solved.reason;
    if (!solved.converged)
      return result;
    auto tangent = find_tangent(step, end.results, &sense);
    if (!tangent)
      {
        result.failure_reason = solver.last_failure();
        return result;
      }
    equations.accept(step, end.results);
    result.point.emplace(PathPoint{std::move(end), std::move(*tangent)});
    return result;
  }

  std::optional<PathTangent>
  PathStepper::find_tangent(const Evaluation        &evaluation,
                            const EvaluationResults &results,
                            const Vector            *sense)
  {
    solver.assemble(evaluation, results, stiffness_alone);
    if (!solver.factorize())
      return std::nullopt;
    evaluation.to.path->n_negative       = space.n_negative();
    evaluation.to.path->determinant_sign = space.determinant_sign();
    if (!evaluation.to.path->n_negative &&
        !evaluation.to.path->determinant_sign)
      throw ComputationError(
        "The tangent becomes unsymmetric on the path of equilibria, but " +
        solver.linear_solver().method() +
        " uses only its symmetric part and would miss bifurcations. Set "
        "Solver/Type to auto, klu or mumps.");
    auto response = load_response(solver, evaluation);
    if (!response)
      return std::nullopt;
    double rate = 1 / path_metric.length(*response);
    if (sense != nullptr && path_metric.product(*response, *sense) < 0)
      rate *= -1;
    scale(rate, *response);
    return PathTangent{std::move(*response), rate};
  }

  std::optional<double> PathStepper::find_softest_vector(Vector &mode)
  {
    constexpr unsigned int n_iterations = 12;
    return inverse_iteration(
      solver,
      path_metric.weights(),
      [this](const unsigned int i) { return space.is_free(i); },
      n_iterations,
      mode);
  }

  std::optional<std::pair<Vector, double>> PathStepper::softest_mode()
  {
    Vector     mode;
    const auto growth = find_softest_vector(mode);
    if (!growth)
      return std::nullopt;
    mode = space.shape(
      {mode.begin(), mode.begin() + equations.unknowns().layout.n_owned()});
    scale(1 / path_metric.length(mode), mode);
    return std::pair(std::move(mode), 1 / *growth);
  }

  bool PathStepper::is_neutral()
  {
    const Vector             &weights       = path_metric.weights();
    const std::vector<double> springs       = solver.matrix().diagonal();
    double                    local_largest = 0;
    for (unsigned int i = 0; i < springs.size(); ++i)
      if (space.is_free(i) && weights[i] > 0)
        local_largest =
          std::max(local_largest, std::abs(springs[i]) / weights[i]);
    const double largest = equations.unknowns().layout.largest(local_largest);
    const auto   found   = softest_mode();
    return !found || found->second <= round_off * largest;
  }

  std::optional<double> PathStepper::load_projection(const PathPoint &point)
  {
    const Unknowns      &unknowns = equations.unknowns();
    const UnknownLayout &layout   = unknowns.layout;
    const Vector         loads    = loads_at(point);
    Vector               left_vector;
    solver.matrix().transpose();
    const auto growth = find_softest_vector(left_vector);
    solver.matrix().transpose();
    if (!growth)
      return std::nullopt;
    std::vector<double> sums(3, 0.);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (space.is_free(i))
        {
          const double component = left_vector[i] / unknowns.unit(i),
                       force     = loads[i] * unknowns.unit(i);
          sums[0] += component * force;
          sums[1] += component * component;
          sums[2] += force * force;
        }
    sums = layout.sum(sums);
    return std::abs(sums[0]) / std::sqrt(sums[1] * sums[2]);
  }

  Vector PathStepper::loads_at(const PathPoint &point) const
  {
    const UnknownLayout &layout = equations.unknowns().layout;
    State                at     = point.solution.state;
    Vector               loads =
      load_direction(equations,
                     Evaluation::equilibrium(point.solution.state, at));
    Vector motions(layout.n_local(), 0.), motion_forces(layout.n_owned());
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (space.is_prescribed(i))
        motions[i] = loads[i];
    layout.update_ghosts(motions.data());
    solver.matrix().multiply_blocks(motions.data(), motion_forces.data());
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      loads[i] -= motion_forces[i];
    return loads;
  }

  namespace
  {
    /** Smallest step length over the first. */
    constexpr double min_length_ratio = 1e-6;

    /**
     * Largest accepted deviation from the tangent over the resolution.
     * @tuned judgement: the next step is then half as long
     */
    constexpr double max_deviation = 4;

    /**
     * Smallest accepted cosine between the tangents of two points; below, the
     * second may lie on another branch.
     * @tuned judgement: 37 degrees
     */
    constexpr double min_turn_cosine = 0.8;

    /**
     * Number of Newton iterations at which the step length does not change.
     * @tuned judgement
     */
    constexpr double target_iterations = 8;

    /**
     * Factor by which the length limit after a failure grows with every point.
     */
    constexpr double limit_growth = 1.1;
  } // namespace

  PathStepLength::PathStepLength(const double resolution, const double first)
    : resolution(resolution)
    , next_length(first)
    , min_length(min_length_ratio * first)
  {}

  void PathStepLength::reached(const double distance, const double load_factor)
  {
    largest_distance = std::max(largest_distance, distance);
    largest_load     = std::max(largest_load, std::abs(load_factor));
  }

  bool PathStepLength::judge(const PathStep &step,
                             const double    distance,
                             const double    turn)
  {
    const double relative_deviation =
                   step.deviation / std::max(largest_distance, distance),
                 relative_load_deviation = step.load_deviation /
      std::max(largest_load, std::abs(step.point->load_factor()));
    const double deviation =
      std::max(relative_deviation, relative_load_deviation) / resolution;
    // The deviation is proportional to the square of the length.
    const double length_factor = 0.9 / std::sqrt(std::max(deviation, 1e-6));
    const bool accepted = deviation <= max_deviation && turn >= min_turn_cosine;
    if (!accepted)
      next_length *= std::clamp(length_factor, 0.1, 0.5);
    else
      {
        next_length *= std::clamp(std::min(length_factor,
                                           target_iterations / step.iterations),
                                  0.3,
                                  2.);
        next_length = std::min(next_length, length_limit);
        length_limit *= limit_growth;
      }
    return accepted;
  }

  void PathStepLength::restart_branch(const double first)
  {
    next_length  = first;
    min_length   = min_length_ratio * first;
    length_limit = std::numeric_limits<double>::infinity();
  }

  void PathStepLength::failed()
  {
    length_limit = next_length / 1.5;
    next_length /= 3;
  }

  void PathStepLength::serialize(CheckpointArchive &archive)
  {
    archive.values("path: length of steps",
                   next_length,
                   min_length,
                   length_limit,
                   largest_distance,
                   largest_load);
  }
} // namespace auxfem
