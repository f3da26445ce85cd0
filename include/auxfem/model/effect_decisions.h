#ifndef auxfem_model_effect_decisions_h
#define auxfem_model_effect_decisions_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** Text of a fraction: `0.52 %`, `1.8e-06`. */
  std::string part_text(double part);

  /**
   * Resolves every `auto` of the effects of @p plan. An effect whose estimated
   * contribution is below `Effects/Tolerance` is disabled if that saves time.
   * @param lattice lattice of the scene
   */
  SimulatedEffects decide_effects(const RunPlan &plan, const Lattice &lattice);

  /** Whether a scene contains an effect, with the reason. */
  struct EffectCause
  {
    bool        given;
    std::string reason;
  };

  /** Reason to disable rate effects on equilibrium paths. */
  inline const std::string no_rates_on_paths =
    "a path of equilibria has no rates";

  /** Reason to disable strut contact with small displacements. */
  inline const std::string struts_hardly_move =
    "struts hardly move by small displacements";

  /** Retention reason of effects that cost no run time
   * (doc/measurements/effects.md). */
  std::string no_saving_reason(const SimulatedEffects &before);

  /**
   * An effect controlled by subsection `Effects`. New effects are added to
   * effect_definitions().
   */
  struct EffectDefinition
  {
    /** Name of its parameter in `Effects`, in lower case. */
    std::string name;
    Switch EffectSwitches::*choice;
    bool SimulatedEffects::*simulated;

    EffectCause (*cause)(const RunPlan &plan);

    /** Estimated contribution of the effect (formulas: doc/theory/effects.md,
     * Measures); empty if unknown. Without this function the effect is enabled
     * whenever it has a cause. */
    std::optional<EffectMeasure> (*measure)(const RunPlan &plan,
                                            const Lattice &lattice) = nullptr;

    /** Reason to keep a negligible effect, given the effects decided before:
     * `leaving it out saves nothing`. Empty if it may be disabled. */
    std::string (*retention_reason)(const SimulatedEffects &before) =
      no_saving_reason;
  };

  /** @name Definitions of the effects, each beside its implementation. */
  ///@{
  EffectDefinition large_rotation_effect();
  EffectDefinition shear_flexibility_effect();
  EffectDefinition inertia_effect();
  EffectDefinition rotary_inertia_effect();
  EffectDefinition connector_viscosity_effect();
  EffectDefinition strut_damping_effect();
  EffectDefinition strut_relaxation_effect();
  EffectDefinition plasticity_effect();
  EffectDefinition gravity_effect();
  EffectDefinition hinges_effect();
  EffectDefinition contact_effect();
  ///@}

  /** All definitions, in the order of subsection `Effects`. */
  const std::vector<EffectDefinition> &effect_definitions();
} // namespace auxfem

#endif
