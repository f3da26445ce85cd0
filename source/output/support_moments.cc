#include <auxfem/output/effective_strains.h>
#include <auxfem/output/support_moments.h>

#include <deal.II/base/tensor.h>

namespace auxfem
{
  SupportMoments::SupportMoments(const Scene &scene, const Equations &equations)
    : equations(equations)
  {
    const std::vector<Support> &supports = equations.model().supports;
    for (const SupportDefinition &definition : scene.supports)
      for (unsigned int i = 0; i < supports.size(); ++i)
        if (definition.moment_point && supports[i].name == definition.name)
          parts.push_back({definition.name, i, *definition.moment_point});
  }

  std::vector<Column> SupportMoments::columns() const
  {
    std::vector<Column> result;
    const bool          planar = equations.model().lattice.dimension == 2;
    for (const Part &part : parts)
      for (unsigned int c = planar ? 2 : 0; c < 3; ++c)
        result.push_back(
          {part.name + ".moment" + (planar ? "" : "_" + axis_name(c)),
           "N m",
           "moment of the support on the lattice" +
             (planar ? "" : " along " + axis_name(c)) +
             ", with that of its forces, about its point"});
    return result;
  }

  dealii::Point<3> SupportMoments::position(const unsigned int joint,
                                            const State       &state) const
  {
    const LatticeModel &model    = equations.model();
    dealii::Point<3>    position = model.lattice.joints[joint];
    if (model.plan.simulated.large_rotation)
      for (unsigned int c = 0; c < model.lattice.dimension; ++c)
        position[c] +=
          state.displacement[model.numbering.joint_unknown(joint, c)];
    return position;
  }

  std::vector<double> SupportMoments::values(const State &state) const
  {
    const LatticeModel &model  = equations.model();
    const bool          planar = model.lattice.dimension == 2;
    std::vector<double> result;
    for (const Part &part : parts)
      {
        dealii::Tensor<1, 3> moment;
        for (const Support::PrescribedUnknown &prescribed :
             model.supports[part.support].unknowns)
          {
            if (!model.numbering.layout().is_owned(prescribed.unknown))
              continue;
            const double reaction = state.residual[prescribed.unknown];
            if (prescribed.component >= first_rotation)
              {
                moment[prescribed.component - first_rotation] += reaction;
                continue;
              }
            dealii::Tensor<1, 3> force;
            force[prescribed.component] = reaction;
            moment +=
              dealii::cross_product_3d(dealii::Tensor<1, 3>(
                                         position(prescribed.joint, state) -
                                         part.point),
                                       force);
          }
        for (unsigned int c = planar ? 2 : 0; c < 3; ++c)
          result.push_back(moment[c]);
      }
    return result;
  }
} // namespace auxfem
