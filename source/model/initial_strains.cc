#include <auxfem/mesh/sets.h>
#include <auxfem/model/initial_strains.h>
#include <auxfem/model/load_history.h>
#include <auxfem/parameters/errors.h>

namespace auxfem
{
  namespace
  {
    using Cause = InitialStrainDefinition::Cause;

    InitialStrain::Kind kind_of(const Cause cause)
    {
      switch (cause)
        {
          case Cause::gradient_2:
            return InitialStrain::Kind::curvature_3;
          case Cause::gradient_3:
            return InitialStrain::Kind::curvature_2;
          default:
            return InitialStrain::Kind::axial;
        }
    }

    /**
     * Strain over load. Fibres at y, z from axes 3 and 2 have the strain
     * epsilon - y kappa_3 + z kappa_2.
     */
    double factor_of(const Cause cause, const Section &section)
    {
      switch (cause)
        {
          case Cause::temperature:
          case Cause::gradient_3:
            return *section.thermal_expansion;
          case Cause::gradient_2:
            return -*section.thermal_expansion;
          default:
            return -1 / section.axial_stiffness();
        }
    }

    /** Refuses a strut whose material does not know the load. */
    void check_strut(const InitialStrainDefinition &definition,
                     const RunPlan                 &plan,
                     const Lattice                 &lattice,
                     const unsigned int             strut)
    {
      const Strut &chosen = lattice.struts[strut];
      const auto   refuse = [&](const std::string &why) {
        throw InputError(definition.path + "/Struts: strut " +
                         std::to_string(strut) + " " + why);
      };
      if (chosen.is_rigid())
        refuse("is rigid and has no strain. Leave it out of the set");
      const SectionDefinition &section = plan.scene.sections[chosen.section];
      if (definition.cause == Cause::pretension && section.section.taper)
        refuse("has a Taper, so that a pretension alone would not give it one "
               "force. Divide it into several struts, or cool it by a "
               "temperature");
      if (definition.cause != Cause::pretension &&
          !section.section.thermal_expansion)
        refuse("has no Thermal expansion. Set " + section.material_path +
               "/Thermal expansion, e.g. 12e-6 1/K for steel");
      if (plan.analysis == Analysis::buckling)
        throw InputError(
          definition.path +
          ": Analysis = buckling does not know the forces of temperature and "
          "pretension. Let them grow in a simulation with Scheme = static and "
          "an imperfection, or remove the load");
      if (is_linearized(plan.analysis) && !plan.time.static_start)
        throw InputError(
          definition.path +
          ": temperature and pretension act in the small motions about an "
          "equilibrium only. Set About = static equilibrium, or remove the "
          "load");
      if (section.section.stiffness_proportional_damping > 0)
        refuse("has " + section.material_path +
               "/Stiffness-proportional damping, which struts with a "
               "temperature or pretension cannot have yet. Use "
               "Mass-proportional damping or Law = viscoelastic");
    }
  } // namespace

  std::vector<bool> sections_with_initial_strains(const RunPlan &plan,
                                                  const Lattice &lattice)
  {
    std::vector<bool> have(plan.scene.sections.size(), false);
    for (const InitialStrainDefinition &definition : plan.scene.initial_strains)
      for (const unsigned int strut :
           struts_of(definition, lattice, plan.scene.context))
        {
          check_strut(definition, plan, lattice, strut);
          have[lattice.struts[strut].section] = true;
        }
    return have;
  }

  InitialStrains make_initial_strains(const RunPlan              &plan,
                                      const Lattice              &lattice,
                                      const std::vector<Section> &sections)
  {
    InitialStrains result;
    result.raised_from_zero =
      !plan.time.scheme->is_dynamic() && !plan.time.static_start;
    for (const InitialStrainDefinition &definition : plan.scene.initial_strains)
      {
        InitialStrain    strain{definition.name,
                             kind_of(definition.cause),
                             proportional(definition.history, plan),
                             std::vector<double>(lattice.struts.size(), 0.)};
        PositionFunction factor =
          load_distribution(definition, lattice, plan.scene.context);
        for (const unsigned int strut :
             struts_of(definition, lattice, plan.scene.context))
          strain.factors[strut] =
            factor.value_at(lattice.centroid(lattice.struts[strut])) *
            factor_of(definition.cause,
                      sections[lattice.struts[strut].section]);
        result.strains.push_back(std::move(strain));
      }
    return result;
  }
} // namespace auxfem
