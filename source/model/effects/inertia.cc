#include <auxfem/model/effect_definition.h>

namespace auxfem
{
  EffectDefinition inertia_effect()
  {
    return {"inertia",
            &EffectSwitches::inertia,
            &SimulatedEffects::inertia,
            [](const Scene &scene) -> EffectCause {
              return {scene.time.scheme->is_dynamic(),
                      "time scheme " + scene.time.scheme->name()};
            }};
  }
} // namespace auxfem
