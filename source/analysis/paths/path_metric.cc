#include <auxfem/analysis/paths/path_metric.h>

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
    for (double &of_unknown : weight)
      of_unknown /= n_nodes;
  }

  double PathMetric::product(const Vector &one, const Vector &other) const
  {
    double mine = 0;
    for (unsigned int i = 0; i < weight.size(); ++i)
      mine += weight[i] * one[i] * other[i];
    return layout.sum(mine);
  }

  double PathMetric::length(const Vector &increment) const
  {
    return std::sqrt(product(increment, increment));
  }
} // namespace auxfem
