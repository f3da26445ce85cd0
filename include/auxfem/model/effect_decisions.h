#ifndef auxfem_model_effect_decisions_h
#define auxfem_model_effect_decisions_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** `0.52 %`, `1.8e-06`. */
  std::string part_text(double part);

  /**
   * Settles every `auto` of the effects of @p plan from what the scene contains
   * and from how much of the answer that is: an effect below
   * `Effects/Tolerance` is left out if that saves time.
   * @param lattice of the scene
   */
  SimulatedEffects decide_effects(const RunPlan &plan, const Lattice &lattice);

  /** Whether a scene has anything of an effect, and what tells so. */
  struct EffectCause
  {
    bool        given;
    std::string reason;
  };

  /** Why what resists rates is left out of paths of equilibria. */
  inline const std::string no_rates_on_paths =
    "a path of equilibria has no rates";

  /** Why struts do not touch by small displacements. */
  inline const std::string struts_hardly_move =
    "struts hardly move by small displacements";

  /** Of effects without which a run takes as long (measured, doc/effects.md).
   */
  std::string no_saving_reason(const SimulatedEffects &before);

  /**
   * An effect that `Effects` switches. A new one is a file in
   * source/model/effects/ and a line in its register.cc.
   */
  struct EffectDefinition
  {
    /** As its parameter in `Effects`, in lower case. */
    std::string name;
    Switch EffectSwitches::*choice;
    bool SimulatedEffects::*simulated;

    EffectCause (*cause)(const RunPlan &plan);

    /**
     * How much of the answer the effect is, of a scene that gives cause for it
     * (formulas: doc/theory.md, Effects); nothing if there is no telling.
     * Without a function the effect is on wherever there is cause.
     */
    std::optional<EffectMeasure> (*measure)(const RunPlan &plan,
                                            const Lattice &lattice) = nullptr;

    /**
     * Why the effect is kept, however little it does, beside the effects
     * decided before it: `but leaving it out saves nothing`. Empty if it may be
     * left out.
     */
    std::string (*retention_reason)(const SimulatedEffects &before) =
      no_saving_reason;
  };

  /** @name Effects, one per file source/model/effects/<name>.cc. */
  ///@{
  EffectDefinition large_rotation_effect();
  EffectDefinition shear_flexibility_effect();
  EffectDefinition inertia_effect();
  EffectDefinition rotary_inertia_effect();
  EffectDefinition connector_viscosity_effect();
  EffectDefinition strut_damping_effect();
  EffectDefinition gravity_effect();
  EffectDefinition hinges_effect();
  EffectDefinition contact_effect();
  ///@}

  /** All of them, in the order of the `Effects` subsection. */
  const std::vector<EffectDefinition> &effect_definitions();
} // namespace auxfem

#endif
