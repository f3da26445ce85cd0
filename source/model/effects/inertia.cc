#include <auxfem/model/effect_definition.h>

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
} // namespace auxfem
