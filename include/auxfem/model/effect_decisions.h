#ifndef auxfem_model_effect_decisions_h
#define auxfem_model_effect_decisions_h

#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** One line of "what is simulated": an effect, whether it is on, and why. */
  struct EffectDecision
  {
    std::string name;
    bool        on;
    std::string reason;
  };

  /** Which physics a run simulates. */
  struct SimulatedEffects
  {
    bool large_rotation, shear_flexibility, inertia, rotary_inertia,
      connector_viscosity, strut_damping, gravity, hinges;

    /** The same in words, in the order of the `Effects` subsection. */
    std::vector<EffectDecision> decisions;
  };

  /** Settles every `auto` from what the scene contains. */
  SimulatedEffects decide_effects(const Scene &scene);
} // namespace auxfem

#endif
