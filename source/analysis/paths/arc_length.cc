#include <auxfem/analysis/paths/arc_length.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/model/unknown_records.h>

#include <cmath>

namespace auxfem
{
  PathMetric::PathMetric(const LatticeModel &model)
    : layout(model.numbering.layout())
    , weight(layout.n_owned(), 0.)
  {
    const Unknowns &unknowns       = model.numbering.unknowns();
    const double    arm            = model.mean_strut_length;
    double          n_translations = 0;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (unknowns.is_rotation[i])
        weight[i] = arm * arm;
      else if (unknowns.kinds[i] != UnknownKind::multiplier)
        {
          weight[i] = 1;
          ++n_translations;
        }
    const double n_nodes = layout.sum(n_translations) / model.lattice.dimension;
    for (double &entry : weight)
      entry /= n_nodes;
  }

  double PathMetric::product(const Vector &one, const Vector &other) const
  {
    double local_sum = 0;
    for (unsigned int i = 0; i < weight.size(); ++i)
      local_sum += weight[i] * one[i] * other[i];
    return layout.sum(local_sum);
  }

  double PathMetric::length(const Vector &increment) const
  {
    return std::sqrt(product(increment, increment));
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
    Vector deviation = curvature;
    deviation.resize(direction.size(), 0.);
    scale(length * length / 2, deviation);
    return deviation;
  }

  void PathTangent::serialize(const DofNumbering &numbering,
                              CheckpointArchive  &archive)
  {
    const UnknownRecords unknowns(numbering);
    archive.values("path: change of the load factor",
                   load_rate,
                   load_curvature);
    unknowns.serialize("path: direction", direction, archive);
    curvature.resize(direction.size(), 0.);
    unknowns.serialize("path: bend", curvature, archive);
  }

  ArcLength::ArcLength(const PathMetric  &metric,
                       const PathTangent &tangent,
                       const double       length)
    : metric(metric)
    , direction(tangent.direction)
    , off_tangent(tangent.deviation(length))
    , load_off_tangent(tangent.load_deviation(length))
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

  void ArcLength::undo_increment(const Evaluation &evaluation,
                                 const Vector     &undone_increment,
                                 const double      part)
  {
    evaluation.to.path->load_factor -= part * last_load;
    add_multiple(1., undone_increment, off_tangent);
    load_off_tangent -= part * last_load;
  }
} // namespace auxfem
