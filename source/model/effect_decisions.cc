#include <auxfem/model/effect_decisions.h>
#include <auxfem/parameters/text.h>

#include <cstdio>

namespace auxfem
{
  namespace
  {
    std::string measured_text(const EffectMeasure &measure)
    {
      return part_text(measure.change) + " of " + measure.of;
    }

    /** Decides `auto` from the estimated contribution. */
    void decide_by_measure(const std::string &retention_reason,
                           const double       tolerance,
                           EffectDecision    &decision)
    {
      const bool is_needed = decision.is_needed(tolerance);
      decision.on          = is_needed || !retention_reason.empty();
      decision.reason      = measured_text(*decision.measure) +
        (is_needed ? ", above " : ", below ") + part_text(tolerance);
      if (!is_needed && !retention_reason.empty())
        decision.reason += ", but " + retention_reason;
    }

    EffectDecision decide(const EffectDefinition &effect,
                          const RunPlan          &plan,
                          const Lattice          &lattice,
                          const SimulatedEffects &before)
    {
      const Switch      choice = plan.effects.*effect.choice;
      const EffectCause cause  = effect.cause(plan);
      EffectDecision    decision{effect.name, cause.given, cause.reason};
      if (!cause.given)
        return decision;
      if (effect.measure != nullptr)
        decision.measure = effect.measure(plan, lattice);
      if (choice != Switch::automatic)
        {
          decision.on     = choice == Switch::on;
          decision.reason = "as set";
          if (decision.measure)
            decision.reason += ": " + measured_text(*decision.measure);
        }
      else if (decision.measure)
        decide_by_measure(effect.retention_reason(before),
                          plan.effects.tolerance,
                          decision);
      return decision;
    }

    /** Rigid parts cannot be switched; they are reported only. */
    EffectDecision rigid_parts_decision(const RunPlan &plan)
    {
      const bool has_parts = !plan.scene.rigid_parts.empty();
      return {"rigid parts",
              has_parts,
              has_parts ? "rigid struts or joints"
                        : "no struts or joints are rigid"};
    }
  } // namespace

  std::string part_text(const double part)
  {
    if (part >= 1e-4)
      return percentage_text(part);
    char text[40];
    std::snprintf(text, sizeof(text), "%.1e", part);
    return text;
  }

  std::string no_saving_reason(const SimulatedEffects & /*before*/)
  {
    return "leaving it out saves nothing";
  }

  SimulatedEffects decide_effects(const RunPlan &plan, const Lattice &lattice)
  {
    SimulatedEffects effects{};
    auto            &list = effects.decisions;
    if (plan.scene.context.dimension == 3 && !plan.scene.sections.empty())
      list.push_back({"struts in space", true, "Dimension = 3"});
    for (const EffectDefinition &effect : effect_definitions())
      {
        list.push_back(decide(effect, plan, lattice, effects));
        effects.*effect.simulated = list.back().on;
      }
    list.push_back(rigid_parts_decision(plan));
    return effects;
  }


  const std::vector<EffectDefinition> &effect_definitions()
  {
    static const std::vector<EffectDefinition> definitions = {
      large_rotation_effect(),
      shear_flexibility_effect(),
      inertia_effect(),
      rotary_inertia_effect(),
      connector_viscosity_effect(),
      strut_damping_effect(),
      strut_relaxation_effect(),
      plasticity_effect(),
      gravity_effect(),
      hinges_effect(),
      contact_effect()};
    return definitions;
  }
} // namespace auxfem
