#include <auxfem/analysis/paths/arc_length.h>
#include <auxfem/equations/load_direction.h>
#include <auxfem/model/unknown_records.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    const std::string rates_record     = "path: change of the load factor",
                      direction_record = "path: direction",
                      bend_record      = "path: bend";
  } // namespace

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

  void PathTangent::save(const DofNumbering &numbering, Records &records) const
  {
    const UnknownRecords unknowns(numbering);
    records.keep(rates_record, {load_rate, load_bend});
    unknowns.keep(direction_record, direction, records);
    if (!bend.empty())
      unknowns.keep(bend_record, bend, records);
  }

  PathTangent PathTangent::saved(const DofNumbering &numbering,
                                 const Records      &records)
  {
    const UnknownRecords      unknowns(numbering);
    const std::vector<double> rates = records.values(rates_record, 2);
    PathTangent tangent{unknowns.values(direction_record, records), rates[0]};
    if (records.has(bend_record))
      tangent.bend = unknowns.values(bend_record, records);
    tangent.load_bend = rates[1];
    return tangent;
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
