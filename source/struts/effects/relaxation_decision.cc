#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/load_history.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    bool relaxes(const SectionDefinition &definition)
    {
      return definition.section.law != nullptr && !definition.section.yields();
    }

    /**
     * Stiffness at the end of a ramp of @p duration (s) that exceeds the one
     * after complete relaxation, as a part of it: the sum of r (1 - e^(-a)) / a
     * over the relaxing parts, a = duration over relaxation time.
     */
    double excess_at_ramp(const SectionLaw &law,
                          const StrainType  type,
                          const double      duration)
    {
      double excess = 0;
      for (const auto &[time, part] : law.relaxing_ratios(type))
        excess += part * -std::expm1(-duration / time) * time / duration;
      return excess / (excess + law.long_time_ratio(type));
    }

    std::optional<EffectMeasure> measure_relaxation(const RunPlan &plan,
                                                    const Lattice & /*lattice*/)
    {
      const LoadHistory history = load_history(plan);
      double            largest = 0;
      for (const SectionDefinition &definition : plan.scene.sections)
        if (relaxes(definition) && plan.time.static_start &&
            !definition.section.law->starts_relaxed())
          largest = std::max(
            largest,
            1 - definition.section.law->long_time_ratio(StrainType::normal));
      if (!(history.rate > 0))
        return EffectMeasure{largest, "the struts' stiffness"};
      for (const SectionDefinition &definition : plan.scene.sections)
        if (relaxes(definition))
          for (const StrainType type : {StrainType::normal, StrainType::shear})
            largest = std::max(largest,
                               excess_at_ramp(*definition.section.law,
                                              type,
                                              1 / history.rate));
      return EffectMeasure{history.lost(plan, largest),
                           "the struts' stiffness"};
    }
  } // namespace

  EffectDefinition strut_relaxation_effect()
  {
    return {"strut relaxation",
            &EffectSwitches::strut_relaxation,
            &SimulatedEffects::strut_relaxation,
            [](const RunPlan &plan) -> EffectCause {
              if (plan.analysis == Analysis::static_path)
                return {false, no_rates_on_paths};
              return {std::any_of(plan.scene.sections.begin(),
                                  plan.scene.sections.end(),
                                  relaxes),
                      "no material relaxes"};
            },
            measure_relaxation,
            [](const SimulatedEffects &before) -> std::string {
              // The measure includes the loads but not free or resonant
              // vibrations.
              return before.inertia ? "it matters where struts swing" : "";
            }};
  }
} // namespace auxfem
