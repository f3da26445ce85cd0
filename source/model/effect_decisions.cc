#include <auxfem/model/effect_decisions.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** What the scene has to say about one effect. */
    struct Case
    {
      bool        wanted;     ///< what `auto` means here
      std::string reason_on;  ///< why `auto` puts it on
      std::string reason_off; ///< why `auto` leaves it out
    };

    bool decide(const std::string           &name,
                const Switch                 choice,
                const Case                  &automatic,
                std::vector<EffectDecision> &decisions)
    {
      const bool on =
        choice == Switch::automatic ? automatic.wanted : choice == Switch::on;
      std::string reason;
      if (choice != Switch::automatic)
        reason = "as set";
      else
        reason = on ? automatic.reason_on : automatic.reason_off;
      decisions.push_back({name, on, reason});
      return on;
    }
  } // namespace

  SimulatedEffects decide_effects(const Scene &scene)
  {
    const auto has_section = [&scene](const auto &property) {
      return std::any_of(scene.sections.begin(),
                         scene.sections.end(),
                         [&](const SectionDefinition &s) {
                           return property(s.section);
                         });
    };
    const bool is_elastic = !scene.sections.empty();
    const bool is_static  = !scene.time.scheme->is_dynamic();
    const bool is_viscous = std::any_of(scene.connectors.begin(),
                                        scene.connectors.end(),
                                        [](const ConnectorDefinition &c) {
                                          return c.law->is_viscous();
                                        });
    const bool is_damped  = has_section([](const Section &s) {
      return s.stiffness_proportional_damping > 0 ||
        s.mass_proportional_damping > 0;
    });

    SimulatedEffects      effects;
    const EffectSwitches &set  = scene.effects;
    auto                 &list = effects.decisions;
    if (scene.context.dimension == 3 && is_elastic)
      list.push_back({"struts in space", true, "Dimension = 3"});
    effects.large_rotation    = decide("large rotation",
                                    set.large_rotation,
                                    {true, "on by default", ""},
                                    list);
    effects.shear_flexibility = decide("shear flexibility",
                                       set.shear_flexibility,
                                       {is_elastic,
                                        "the sections have a shear area",
                                        "no elastic struts"},
                                       list);
    effects.inertia           = decide("inertia",
                             set.inertia,
                             {!is_static,
                                        "time scheme " + scene.time.scheme->name(),
                                        "time scheme static"},
                             list);
    effects.rotary_inertia =
      decide("rotary inertia",
             set.rotary_inertia,
             {effects.inertia && is_elastic,
              "inertia is simulated",
              effects.inertia ? "no elastic struts" : "no inertia"},
             list);
    if (effects.rotary_inertia && !effects.inertia)
      {
        effects.rotary_inertia = false;
        list.back()            = {"rotary inertia", false, "no inertia"};
      }
    list.push_back({"rigid parts",
                    !scene.rigid_parts.empty(),
                    scene.rigid_parts.empty() ? "no struts or joints are rigid"
                                              : "rigid struts or joints"});
    effects.connector_viscosity = decide("connector viscosity",
                                         set.connector_viscosity,
                                         {is_viscous,
                                          "a connector law has a dashpot",
                                          "no connector has a dashpot"},
                                         list);
    effects.strut_damping =
      decide("strut damping",
             set.strut_damping,
             {is_damped, "a section has damping", "no section has damping"},
             list);
    effects.gravity = decide("gravity",
                             set.gravity,
                             {scene.gravity.norm() > 0,
                              "an acceleration is given",
                              "no acceleration given"},
                             list);
    effects.hinges  = decide("hinges",
                            set.hinges,
                            {!scene.joints.empty(),
                              "joints with released struts",
                              "no strut ends are released"},
                            list);
    return effects;
  }
} // namespace auxfem
