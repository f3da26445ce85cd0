#include <auxfem/model/effect_definition.h>

namespace auxfem
{
  EffectDefinition contact_effect()
  {
    return {"contact",
            &EffectSwitches::contact,
            &SimulatedEffects::contact,
            [](const Scene &scene) -> EffectCause {
              if (!scene.plates.empty())
                return {true, "plates are given"};
              // Else struts are watched (analysis/watches/crossing_watch.cc).
              return {scene.effects.contact == Switch::on,
                      "no plates; struts that touch are told"};
            }};
  }
} // namespace auxfem
