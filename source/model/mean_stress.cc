#include <auxfem/mathematics/voigt.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/scene/infinite_lattice.h>

#include <utility>

namespace auxfem
{
  std::vector<WeightedUnknown> mean_stress_terms(const LatticeModel &model,
                                                 const unsigned int  i,
                                                 const unsigned int  j)
  {
    const Lattice     &lattice     = model.lattice;
    const Periodicity &periodicity = *lattice.periodicity;
    const double       factor      = periodicity.length() /
      (periodicity.volume() * depth_of_continuum(model.plan.scene));
    std::vector<WeightedUnknown> terms;
    for (unsigned int r = 0; r < model.relations.size(); ++r)
      {
        const int multiplier =
          model.numbering.constraints().relation_multiplier(r);
        if (!model.numbering.layout().is_owned(multiplier))
          continue;
        for (const LinearRelation::Term &term : model.relations[r].terms)
          if (term.motion.joint == lattice.joint_of_axis(j) &&
              term.motion.component == i)
            terms.push_back({multiplier, factor * term.coefficient});
      }
    return terms;
  }

  std::vector<WeightedUnknown> symmetric_stress_terms(const LatticeModel &model,
                                                      const unsigned int  i)
  {
    const auto [a, b] = axes_of_component(i, model.lattice.dimension);
    std::vector<WeightedUnknown> terms;
    for (const auto &[k, l] : {std::pair(a, b), std::pair(b, a)})
      for (const WeightedUnknown &term : mean_stress_terms(model, k, l))
        terms.push_back({term.unknown, term.weight / 2});
    return terms;
  }

  double sum_of_owned(const std::vector<WeightedUnknown> &terms,
                      const double                       *values)
  {
    double sum = 0;
    for (const WeightedUnknown &term : terms)
      sum += term.weight * values[term.unknown];
    return sum;
  }
} // namespace auxfem
