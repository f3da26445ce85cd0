#include <auxfem/model/effect_definition.h>
#include <auxfem/model/load_course.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    bool is_damped(const Section &section)
    {
      return section.stiffness_proportional_damping > 0 ||
        section.mass_proportional_damping > 0;
    }

    std::optional<EffectMeasure> measure_strut_damping(const RunPlan &plan,
                                                       const Lattice & /**/)
    {
      const LoadCourse course       = load_course(plan);
      const bool       moves        = plan.time.scheme->is_dynamic();
      double           of_stiffness = 0, of_mass = 0;
      for (const SectionDefinition &definition : plan.scene.sections)
        {
          of_stiffness =
            std::max(of_stiffness,
                     definition.section.stiffness_proportional_damping);
          of_mass =
            std::max(of_mass,
                     moves ? definition.section.mass_proportional_damping : 0.);
        }
      // What does not change with time swings about in its own time.
      if (!(course.rate > 0) && of_mass > 0)
        return std::nullopt;
      const double of_forces =
        of_stiffness * course.rate + (of_mass > 0 ? of_mass / course.rate : 0.);
      return EffectMeasure{course.lost(plan, of_forces), "the struts' forces"};
    }
  } // namespace

  EffectDefinition strut_damping_effect()
  {
    return {"strut damping",
            &EffectSwitches::strut_damping,
            &SimulatedEffects::strut_damping,
            [](const RunPlan &plan) -> EffectCause {
              if (plan.analysis == Analysis::static_path)
                return {false, no_rates_on_paths};
              const bool given =
                std::any_of(plan.scene.sections.begin(),
                            plan.scene.sections.end(),
                            [](const SectionDefinition &definition) {
                              return is_damped(definition.section);
                            });
              return {given,
                      given ? "a section has damping"
                            : "no section has damping"};
            },
            measure_strut_damping,
            [](const SimulatedEffects &before) -> std::string {
              if (before.large_rotation)
                return "it matters where struts snap";
              // The measure sees the loads, not the swing they leave behind
              // or drive at its own frequency.
              return before.inertia ? "it matters where struts swing" : "";
            }};
  }
} // namespace auxfem
