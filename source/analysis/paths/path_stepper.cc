#include <auxfem/analysis/inverse_iteration.h>
#include <auxfem/analysis/paths/path_stepper.h>
#include <auxfem/equations/load_direction.h>
#include <auxfem/equations/prescribed_motion.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Of a static tangent. */
    constexpr TangentFactors stiffness_alone = {1., 0., 0.};
  } // namespace

  PathStepper::PathStepper(TangentSolver          &solver,
                           const NewtonParameters &parameters)
    : solver(solver)
    , equations(solver.equations())
    , newton(solver, parameters)
    , space(solver)
    , of_path(solver.model())
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
        "The path of equilibria has no beginning: " + solver.why() + '.');
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
    ArcLength arc_length(of_path, prediction, length);
    PathStep  result = solve(step, end, prediction.direction, &arc_length);
    if (!result.point)
      return result;
    result.deviation         = arc_length.deviation();
    result.deviation_of_load = arc_length.deviation_of_load();
    PathTangent &tangent     = result.point->tangent;
    tangent.bend             = tangent.direction;
    add_multiple(-1., prediction.direction, tangent.bend);
    scale(1 / length, tangent.bend);
    tangent.load_bend = (tangent.load_rate - prediction.load_rate) / length;
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
      length * prediction.load_rate + prediction.deviation_of_load(length);
    Vector increment = prediction.deviation(length);
    add_multiple(length, prediction.direction, increment);
    rotations.follow(step);
    rotations.rotate(step, increment);
    rule.correct(step.from, increment, step.dt, step.to);
  }

  PathStep PathStepper::solve(const Evaluation &step,
                              Solution         &end,
                              const Vector     &way,
                              AddedEquation    *arc_length)
  {
    newton.drop_factorization();
    const Newton::Result solved =
      newton.solve(rule, step, end.results, arc_length);
    PathStep result;
    result.iterations        = solved.iterations;
    result.relative_residual = solved.relative_residual;
    result.why_failed        = solved.reason;
    if (!solved.converged)
      return result;
    auto tangent = find_tangent(step, end.results, &way);
    if (!tangent)
      {
        result.why_failed = solver.why();
        return result;
      }
    equations.accept(step, end.results);
    result.point.emplace(PathPoint{std::move(end), std::move(*tangent)});
    return result;
  }

  std::optional<PathTangent>
  PathStepper::find_tangent(const Evaluation        &evaluation,
                            const EvaluationResults &results,
                            const Vector            *way)
  {
    solver.assemble(evaluation, results, stiffness_alone);
    if (!solver.factorize())
      return std::nullopt;
    evaluation.to.path->n_negative       = space.n_negative();
    evaluation.to.path->determinant_sign = space.determinant_sign();
    if (!evaluation.to.path->n_negative &&
        !evaluation.to.path->determinant_sign)
      throw ComputationError(
        "The path of equilibria comes to loads under which the tangent is not "
        "symmetric, and " +
        solver.linear_solver().method() +
        " takes its symmetric part: bifurcations would be missed. Set "
        "Solver/Type to auto, klu or mumps.");
    auto response = load_response(solver, evaluation);
    if (!response)
      return std::nullopt;
    double rate = 1 / of_path.length(*response);
    if (way != nullptr && of_path.product(*response, *way) < 0)
      rate *= -1;
    scale(rate, *response);
    return PathTangent{std::move(*response), rate};
  }

  std::optional<double> PathStepper::find_softest(Vector &mode)
  {
    constexpr unsigned int n_iterations = 12;
    return inverse_iteration(
      solver,
      of_path.weights(),
      [this](const unsigned int i) { return space.is_free(i); },
      n_iterations,
      mode);
  }

  std::optional<std::pair<Vector, double>> PathStepper::softest()
  {
    Vector     mode;
    const auto growth = find_softest(mode);
    if (!growth)
      return std::nullopt;
    mode = space.shape(
      {mode.begin(), mode.begin() + equations.unknowns().layout.n_owned()});
    scale(1 / of_path.length(mode), mode);
    return std::pair(std::move(mode), 1 / *growth);
  }

  bool PathStepper::is_neutral()
  {
    const Vector             &weights = of_path.weights();
    const std::vector<double> springs = solver.matrix().diagonal();
    double                    mine    = 0;
    for (unsigned int i = 0; i < springs.size(); ++i)
      if (space.is_free(i) && weights[i] > 0)
        mine = std::max(mine, std::abs(springs[i]) / weights[i]);
    const double largest = equations.unknowns().layout.largest(mine);
    const auto   found   = softest();
    return !found || found->second <= round_off * largest;
  }

  std::optional<double> PathStepper::part_of_loads(const PathPoint &point)
  {
    const Unknowns      &unknowns = equations.unknowns();
    const UnknownLayout &layout   = unknowns.layout;
    const Vector         loads    = loads_at(point);
    Vector               left;
    solver.matrix().transpose();
    const auto growth = find_softest(left);
    solver.matrix().transpose();
    if (!growth)
      return std::nullopt;
    std::vector<double> sums(3, 0.);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (space.is_free(i))
        {
          const double way   = left[i] / unknowns.unit(i),
                       force = loads[i] * unknowns.unit(i);
          sums[0] += way * force;
          sums[1] += way * way;
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
    Vector motions(layout.n_local(), 0.), of_motions(layout.n_owned());
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (space.is_prescribed(i))
        motions[i] = loads[i];
    layout.update_ghosts(motions.data());
    solver.matrix().multiply_blocks(motions.data(), of_motions.data());
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      loads[i] -= of_motions[i];
    return loads;
  }
} // namespace auxfem
