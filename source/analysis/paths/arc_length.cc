#include <auxfem/analysis/paths/arc_length.h>
#include <auxfem/equations/prescribed_motion.h>

#include <cmath>

namespace auxfem
{
  void multiply(const double factor, Vector &values)
  {
    for (double &value : values)
      value *= factor;
  }

  Vector load_direction(const Equations  &equations,
                        const Evaluation &evaluation)
  {
    Vector loads = equations.load_derivative(evaluation);
    multiply(-1., loads);
    const Unknowns &unknowns = equations.unknowns();
    for (unsigned int i = 0; i < unknowns.layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        loads[i] = 0;
    find_motion_derivative(equations.model(), evaluation, loads.data());
    return loads;
  }

  std::optional<Vector> load_response(TangentSolver    &solver,
                                      const Evaluation &evaluation)
  {
    Vector response = load_direction(solver.equations(), evaluation);
    if (!solver.solve(response))
      return std::nullopt;
    return response;
  }

  Vector PathTangent::deviation(const double length) const
  {
    Vector deviation = bend;
    deviation.resize(direction.size(), 0.);
    multiply(length * length / 2, deviation);
    return deviation;
  }

  double PathTangent::deviation_of_load(const double length) const
  {
    return length * length / 2 * load_bend;
  }

  ArcLength::ArcLength(const PathMetric  &metric,
                       const PathTangent &tangent,
                       const double       length)
    : metric(metric)
    , direction(tangent.direction)
    , off_tangent(tangent.deviation(length))
    , load_off_tangent(tangent.deviation_of_load(length))
  {}

  bool ArcLength::complete(TangentSolver    &solver,
                           const Evaluation &evaluation,
                           Vector           &increment)
  {
    const auto response = load_response(solver, evaluation);
    if (!response)
      return false;
    const double load = -metric.product(direction, increment) /
      metric.product(direction, *response);
    if (!std::isfinite(load))
      return false;
    add_multiple(load, *response, increment);
    evaluation.to.path->load_factor += load;
    add_multiple(1., increment, off_tangent);
    load_off_tangent += load;
    return true;
  }

  double ArcLength::deviation() const
  {
    return metric.length(off_tangent);
  }

  double ArcLength::deviation_of_load() const
  {
    return std::abs(load_off_tangent);
  }
} // namespace auxfem
