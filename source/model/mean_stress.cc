#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/scene/infinite_lattice.h>

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
} // namespace auxfem
