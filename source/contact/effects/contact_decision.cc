#include <auxfem/model/effect_decisions.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    bool is_thick(const SectionDefinition &definition)
    {
      const auto &halves = definition.section.half_thicknesses;
      return std::max(halves[0], halves[1]) > 0;
    }

    /** Whether the analysis follows contact from state to state. */
    bool follows_contact(const Analysis analysis)
    {
      return analysis != Analysis::static_path &&
        analysis != Analysis::buckling;
    }

    EffectCause cause_of_contact(const RunPlan &plan)
    {
      if (!plan.scene.plates.empty())
        return {true, "plates are given"};
      if (plan.scene.lattice.struts_may_cross)
        return {false, "Lattice/Struts may cross = true"};
      if (plan.effects.large_rotation == Switch::off)
        return {false, struts_hardly_move};
      if (std::none_of(plan.scene.sections.begin(),
                       plan.scene.sections.end(),
                       is_thick))
        return {false, "no section has a thickness"};
      if (plan.effects.contact == Switch::automatic &&
          !follows_contact(plan.analysis))
        return {false, "touching struts are reported"};
      return {true, "struts may touch: forces where they are near"};
    }
  } // namespace

  EffectDefinition contact_effect()
  {
    return {"contact",
            &EffectSwitches::contact,
            &SimulatedEffects::contact,
            cause_of_contact};
  }
} // namespace auxfem
