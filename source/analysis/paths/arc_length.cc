#include <auxfem/analysis/paths/arc_length.h>
#include <auxfem/equations/load_direction.h>
#include <auxfem/model/unknown_records.h>

#include <cmath>

namespace auxfem
{
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
    scale(length * length / 2, deviation);
    return deviation;
  }

  void PathTangent::serialize(const DofNumbering &numbering,
                              CheckpointArchive  &archive)
  {
    const UnknownRecords unknowns(numbering);
    archive.values("path: change of the load factor", load_rate, load_bend);
    unknowns.serialize("path: direction", direction, archive);
    bend.resize(direction.size(), 0.);
    unknowns.serialize("path: bend", bend, archive);
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
    last_load = load;
    return true;
  }

  void ArcLength::take_back(const Evaluation &evaluation,
                            const Vector     &way_back,
                            const double      part)
  {
    evaluation.to.path->load_factor -= part * last_load;
    add_multiple(1., way_back, off_tangent);
    load_off_tangent -= part * last_load;
  }
} // namespace auxfem
