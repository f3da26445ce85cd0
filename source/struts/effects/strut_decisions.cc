#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/load_history.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  EffectDefinition inertia_effect()
  {
    return {"inertia",
            &EffectSwitches::inertia,
            &SimulatedEffects::inertia,
            [](const RunPlan &plan) -> EffectCause {
              return {plan.time.scheme->is_dynamic(),
                      "time scheme " + plan.time.scheme->name()};
            }};
  }

  namespace
  {
    /**
     * Relative reduction of the @p frequency (1/s) of bending waves by rotary
     * inertia, (k r)^2 / 2 with k^4 = frequency^2 rho A / EI.
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

  EffectDefinition large_rotation_effect()
  {
    return {"large rotation",
            &EffectSwitches::large_rotation,
            &SimulatedEffects::large_rotation,
            [](const RunPlan &) -> EffectCause {
              return {true, "on by default"};
            }};
  }

  namespace
  {
    /** Compliance of struts by shear and bending. */
    struct Compliances
    {
      double shear   = 0; ///< L / kGA (m/N)
      double bending = 0; ///< L^3 / 12 EI (m/N)
    };

    /** Compliances of a strut of @p length across the axis with the larger
     * share of shear. */
    Compliances compliances(const Section     &section,
                            const double       length,
                            const unsigned int dimension)
    {
      const auto across = [length](const double shear, const double bending) {
        return Compliances{length / shear,
                           length * length * length / (12 * bending)};
      };
      const Compliances in_plane =
        across(section.shear_stiffness_2(), section.bending_stiffness_3());
      if (dimension == 2)
        return in_plane;
      const Compliances other =
        across(section.shear_stiffness_3(), section.bending_stiffness_2());
      return other.shear * in_plane.bending > in_plane.shear * other.bending
        ? other
        : in_plane;
    }

    /**
     * Largest ratio of shear to bending compliance of the struts of a section.
     */
    std::optional<EffectMeasure> measure_shear(const RunPlan &plan,
                                               const Lattice &lattice)
    {
      std::vector<Compliances> section_compliances(plan.scene.sections.size());
      for (const Strut &strut : lattice.struts)
        if (!strut.is_rigid())
          {
            const Compliances added =
              compliances(plan.scene.sections[strut.section].section,
                          lattice.length(strut),
                          lattice.dimension);
            section_compliances[strut.section].shear += added.shear;
            section_compliances[strut.section].bending += added.bending;
          }
      double largest = 0;
      for (const Compliances &sum : section_compliances)
        if (sum.bending > 0)
          largest = std::max(largest, sum.shear / sum.bending);
      return EffectMeasure{std::min(1., largest), "the bending compliance"};
    }
  } // namespace

  EffectDefinition shear_flexibility_effect()
  {
    return {"shear flexibility",
            &EffectSwitches::shear_flexibility,
            &SimulatedEffects::shear_flexibility,
            [](const RunPlan &plan) -> EffectCause {
              return {!plan.scene.sections.empty(), "no elastic struts"};
            },
            measure_shear};
  }

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
      const LoadHistory history           = load_history(plan);
      const bool        is_dynamic        = plan.time.scheme->is_dynamic();
      double            stiffness_damping = 0, mass_damping = 0;
      for (const SectionDefinition &definition : plan.scene.sections)
        {
          stiffness_damping =
            std::max(stiffness_damping,
                     definition.section.stiffness_proportional_damping);
          mass_damping =
            std::max(mass_damping,
                     is_dynamic ? definition.section.mass_proportional_damping
                                : 0.);
        }
      // Under constant loads the natural frequency decides, which is unknown
      // here.
      if (!(history.rate > 0) && mass_damping > 0)
        return std::nullopt;
      const double damping_force_ratio = stiffness_damping * history.rate +
        (mass_damping > 0 ? mass_damping / history.rate : 0.);
      return EffectMeasure{history.lost(plan, damping_force_ratio),
                           "the struts' forces"};
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
              const bool has_damping =
                std::any_of(plan.scene.sections.begin(),
                            plan.scene.sections.end(),
                            [](const SectionDefinition &definition) {
                              return is_damped(definition.section);
                            });
              return {has_damping,
                      has_damping ? "a section has damping"
                                  : "no section has damping"};
            },
            measure_strut_damping,
            [](const SimulatedEffects &before) -> std::string {
              if (before.large_rotation)
                return "it matters where struts snap";
              // The measure includes the loads but not free or resonant
              // vibrations.
              return before.inertia ? "it matters where struts swing" : "";
            }};
  }
} // namespace auxfem
