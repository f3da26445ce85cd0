#include <auxfem/model/effect_definition.h>
#include <auxfem/parameters/rounded_text.h>

#include <cstdio>

namespace auxfem
{
  namespace
  {
    std::string measured_text(const EffectMeasure &measure)
    {
      return part_text(measure.change) + " of " + measure.of;
    }

    /** Settles `auto` by what has been measured. */
    void decide_by_measure(const std::string &why_kept,
                           const double       tolerance,
                           EffectDecision    &decision)
    {
      const bool is_called_for = decision.is_called_for(tolerance);
      decision.on              = is_called_for || !why_kept.empty();
      decision.reason          = measured_text(*decision.measure) +
        (is_called_for ? ", above " : ", below ") + part_text(tolerance);
      if (!is_called_for && !why_kept.empty())
        decision.reason += ", but " + why_kept;
    }

    EffectDecision decide(const EffectDefinition &effect,
                          const Scene            &scene,
                          const Lattice          &lattice,
                          const SimulatedEffects &before)
    {
      const Switch      choice = scene.effects.*effect.choice;
      const EffectCause cause  = effect.cause(scene);
      EffectDecision    decision{effect.name, cause.given, cause.reason};
      if (!cause.given)
        return decision;
      if (effect.measure != nullptr)
        decision.measure = effect.measure(scene, lattice);
      if (choice != Switch::automatic)
        {
          decision.on     = choice == Switch::on;
          decision.reason = "as set";
          if (decision.measure)
            decision.reason += ": " + measured_text(*decision.measure);
        }
      else if (decision.measure)
        decide_by_measure(effect.why_kept(before),
                          scene.effects.tolerance,
                          decision);
      return decision;
    }

    /** What is there or not, and cannot be switched. */
    EffectDecision rigid_parts_decision(const Scene &scene)
    {
      const bool has_parts = !scene.rigid_parts.empty();
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

  std::string saves_nothing(const SimulatedEffects & /*before*/)
  {
    return "leaving it out saves nothing";
  }

  SimulatedEffects decide_effects(const Scene &scene, const Lattice &lattice)
  {
    SimulatedEffects effects{};
    auto            &list = effects.decisions;
    if (scene.context.dimension == 3 && !scene.sections.empty())
      list.push_back({"struts in space", true, "Dimension = 3"});
    for (const EffectDefinition &effect : effect_definitions())
      {
        list.push_back(decide(effect, scene, lattice, effects));
        effects.*effect.simulated = list.back().on;
      }
    list.push_back(rigid_parts_decision(scene));
    return effects;
  }



  namespace
  {
    std::string record_of(const std::string &effect)
    {
      return "decision on " + effect;
    }
  } // namespace

  void save(const EffectDecision &decision, Records &records)
  {
    const std::string record  = record_of(decision.name);
    const auto       &measure = decision.measure;
    records.keep(record,
                 {decision.on ? 1. : 0.,
                  measure ? 1. : 0.,
                  measure ? measure->change : 0.});
    records.keep_text(record + ", reason", decision.reason);
    records.keep_text(record + ", measure of", measure ? measure->of : "");
  }

  EffectDecision saved_decision(const std::string &effect,
                                const Records     &records)
  {
    const std::string         record = record_of(effect);
    const std::vector<double> values = records.values(record, 3);
    EffectDecision            decision{effect,
                            values[0] != 0,
                            records.text(record + ", reason")};
    if (values[1] != 0)
      decision.measure =
        EffectMeasure{values[2], records.text(record + ", measure of")};
    return decision;
  }
} // namespace auxfem
