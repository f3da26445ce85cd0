#include <auxfem/scene/effect_switches.h>

namespace auxfem
{
  namespace
  {
    struct Effect
    {
      Choice entry;
      Switch EffectSwitches::*target;
    };

    Effect effect(const std::string &name,
                  Switch EffectSwitches::*target,
                  const std::string      &sentence)
    {
      return {{name, "auto", {"auto", "on", "off"}, sentence}, target};
    }

    const std::vector<Effect> effects = {
      effect(
        "Large rotation",
        &EffectSwitches::large_rotation,
        "Geometrically exact struts; off: small displacements. auto: small "
        "displacements as long as their estimated error is within the "
        "tolerance, else exact from the start."),
      effect("Shear flexibility",
             &EffectSwitches::shear_flexibility,
             "Shear deformation of the struts."),
      effect("Inertia", &EffectSwitches::inertia, "Inertia forces."),
      effect("Rotary inertia",
             &EffectSwitches::rotary_inertia,
             "Rotary inertia of the struts' cross-sections."),
      effect("Connector viscosity",
             &EffectSwitches::connector_viscosity,
             "Dashpots of the connectors; off: their long-time springs only."),
      effect("Strut damping",
             &EffectSwitches::strut_damping,
             "Stiffness- and mass-proportional damping of the struts."),
      effect("Gravity", &EffectSwitches::gravity, "Weight."),
      effect("Hinges",
             &EffectSwitches::hinges,
             "Hinges and rotational springs; off: all joints are rigid."),
      effect(
        "Contact",
        &EffectSwitches::contact,
        "Contact of struts with plates and with each other; off: they pass "
        "through each other, and those that touch are told. Where nothing is "
        "near there are no forces.")};

    const Quantity effects_tolerance = {
      "Tolerance",
      "1e-3",
      "1",
      Range{0, 1, false, true},
      "Relative change of the answer that may be given away by leaving an effect "
      "out where that saves time."};

    Switch switch_of(const std::string &word)
    {
      return word == "on" ? Switch::on
        : word == "off"   ? Switch::off
                          : Switch::automatic;
    }
  } // namespace



  SubsectionSchema effects_schema()
  {
    Parameters parameters;
    for (const Effect &effect : effects)
      parameters.push_back(effect.entry);
    parameters.push_back(effects_tolerance);
    return {"Effects",
            SubsectionSchema::Form::fixed,
            "What is simulated; auto: on if the scene needs it.",
            parameters};
  }



  EffectSwitches read_effects(ParameterValues &values)
  {
    EffectSwitches switches;
    for (const Effect &effect : effects)
      switches.*effect.target = switch_of(values[effect.entry]);
    switches.tolerance = values[effects_tolerance];
    return switches;
  }
} // namespace auxfem
