#ifndef auxfem_scene_effect_switches_h
#define auxfem_scene_effect_switches_h

#include <auxfem/parameters/subsection_schema.h>

namespace auxfem
{
  /** On, off, or decided from the scene. */
  enum class Switch
  {
    automatic,
    on,
    off
  };

  /** `Effects`: what is simulated. */
  struct EffectSwitches
  {
    Switch large_rotation      = Switch::automatic;
    Switch shear_flexibility   = Switch::automatic;
    Switch inertia             = Switch::automatic;
    Switch rotary_inertia      = Switch::automatic;
    Switch connector_viscosity = Switch::automatic;
    Switch strut_damping       = Switch::automatic;
    Switch gravity             = Switch::automatic;
    Switch hinges              = Switch::automatic;
    Switch contact             = Switch::automatic;
    /** Relative change of the answer that may be given away. */
    double tolerance = 1e-3;
  };

  /** `Effects`. */
  SubsectionSchema effects_schema();

  /** The values of that subsection. */
  EffectSwitches read_effects(ParameterValues &values);
} // namespace auxfem

#endif
