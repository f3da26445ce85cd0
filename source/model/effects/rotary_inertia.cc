#include <auxfem/model/effect_definition.h>
#include <auxfem/model/load_course.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Part of the frequency @p frequency (1/s) of bending waves that rotary
     * inertia takes, (k r)^2 / 2 with k^4 = frequency^2 rho A / EI.
     * @param rotary_inertia per length (kg m)
     */
    double change_of_frequency(const Section &section,
                               const double   rotary_inertia,
                               const double   bending_stiffness,
                               const double   frequency)
    {
      const double mass = section.mass_per_length();
      return rotary_inertia / mass * frequency *
        std::sqrt(mass / bending_stiffness) / 2;
    }

    std::optional<EffectMeasure> measure_rotary_inertia(const RunPlan &plan,
                                                        const Lattice &lattice)
    {
      const double frequency = resolved_frequency(plan);
      double       largest   = 0;
      for (const SectionDefinition &definition : plan.scene.sections)
        {
          const Section &section = definition.section;
          if (!(section.density > 0))
            continue;
          const auto rotary = section.rotary_inertia_per_length();
          largest           = std::max(largest,
                             change_of_frequency(section,
                                                 rotary[2],
                                                 section.bending_stiffness_3(),
                                                 frequency));
          if (lattice.dimension == 3)
            largest =
              std::max(largest,
                       change_of_frequency(section,
                                           rotary[1],
                                           section.bending_stiffness_2(),
                                           frequency));
        }
      return EffectMeasure{std::min(1., largest),
                           "the highest frequency that steps resolve"};
    }
  } // namespace

  EffectDefinition rotary_inertia_effect()
  {
    return {"rotary inertia",
            &EffectSwitches::rotary_inertia,
            &SimulatedEffects::rotary_inertia,
            [](const RunPlan &plan) -> EffectCause {
              if (!plan.time.scheme->is_dynamic())
                return {false, "no inertia"};
              return {!plan.scene.sections.empty(), "no elastic struts"};
            },
            measure_rotary_inertia};
  }
} // namespace auxfem
