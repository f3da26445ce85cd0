#include <auxfem/model/effect_definition.h>

namespace auxfem
{
  EffectDefinition large_rotation_effect()
  {
    return {"large rotation",
            &EffectSwitches::large_rotation,
            &SimulatedEffects::large_rotation,
            [](const RunPlan &) -> EffectCause {
              return {true, "on by default"};
            }};
  }
} // namespace auxfem
