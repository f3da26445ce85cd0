#include <auxfem/model/effect_definition.h>

namespace auxfem
{
  const std::vector<EffectDefinition> &effect_definitions()
  {
    static const std::vector<EffectDefinition> definitions = {
      large_rotation_effect(),
      shear_flexibility_effect(),
      inertia_effect(),
      rotary_inertia_effect(),
      connector_viscosity_effect(),
      strut_damping_effect(),
      gravity_effect(),
      hinges_effect(),
      contact_effect()};
    return definitions;
  }
} // namespace auxfem
