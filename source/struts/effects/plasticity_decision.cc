#include <auxfem/model/effect_decisions.h>

namespace auxfem
{
  EffectDefinition plasticity_effect()
  {
    return {"plasticity",
            &EffectSwitches::plasticity,
            &SimulatedEffects::plasticity,
            [](const RunPlan &plan) -> EffectCause {
              const bool is_given = yields(plan.scene.sections);
              return {is_given,
                      is_given ? "a material yields" : "no material yields"};
            }};
  }
} // namespace auxfem
