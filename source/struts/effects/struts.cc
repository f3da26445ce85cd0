#include <auxfem/equations/make_effects.h>
#include <auxfem/struts/effects/beam_forces.h>
#include <auxfem/struts/effects/strut_inertia.h>

#include <algorithm>

namespace auxfem
{
  std::unique_ptr<StrutForces>
  StrutForces::make(const Lattice              &lattice,
                    const DofNumbering         &numbering,
                    const DofNumbering::Group  &group,
                    const std::vector<Section> &sections,
                    const StrutModel           &model)
  {
    return (lattice.dimension == 2
              ? make_plane_struts
              : make_space_struts)(lattice, numbering, group, sections, model);
  }

  namespace
  {
    /** Returns whether strut damping is simulated and a section has it. */
    bool has_damping(const LatticeModel &model, double Section::*damping)
    {
      return model.plan.simulated.strut_damping &&
        std::any_of(model.sections.begin(),
                    model.sections.end(),
                    [damping](const Section &section) {
                      return section.*damping > 0;
                    });
    }
  } // namespace

  std::vector<std::unique_ptr<StrutForces>>
  make_strut_forces(const LatticeModel &model,
                    const Lattice      &lattice,
                    const DofNumbering &numbering,
                    const double        high_frequency_damping)
  {
    StrutModel beams{model.plan.simulated.large_rotation,
                     model.plan.simulated.shear_flexibility,
                     has_damping(model,
                                 &Section::stiffness_proportional_damping),
                     high_frequency_damping,
                     model.plan.simulated.inertia &&
                       model.plan.simulated.rotary_inertia,
                     nullptr,
                     &model.initial_strains};
    std::vector<std::unique_ptr<StrutForces>> forces;
    for (const DofNumbering::Group &group : numbering.groups())
      {
        beams.law = model.laws[group.law];
        forces.push_back(
          StrutForces::make(lattice, numbering, group, model.sections, beams));
      }
    return forces;
  }

  std::vector<std::unique_ptr<Effect>>
  make_strut_inertia(const LatticeModel &model,
                     const Lattice      &lattice,
                     const DofNumbering &numbering)
  {
    std::vector<std::unique_ptr<Effect>> inertia;
    if (!model.plan.simulated.inertia)
      return inertia;
    const InertiaModel inertia_model{
      model.plan.simulated.large_rotation,
      model.plan.simulated.rotary_inertia,
      has_damping(model, &Section::mass_proportional_damping)};
    for (const DofNumbering::Group &group : numbering.groups())
      inertia.push_back(make_strut_inertia(lattice,
                                           numbering,
                                           group,
                                           model.sections,
                                           inertia_model));
    return inertia;
  }
} // namespace auxfem
