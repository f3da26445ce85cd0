#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/scene/constants.h>
#include <auxfem/scene/general_parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>

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
        "Geometrically exact struts; off: small displacements; auto: small "
        "displacements if their estimated error stays within the tolerance."),
      effect("Shear flexibility",
             &EffectSwitches::shear_flexibility,
             "Shear deformation of the struts."),
      effect("Inertia", &EffectSwitches::inertia, "Inertia forces."),
      effect("Rotary inertia",
             &EffectSwitches::rotary_inertia,
             "Rotary inertia of the struts' cross-sections."),
      effect("Connector viscosity",
             &EffectSwitches::connector_viscosity,
             "Dashpots of connectors; off: their long-time springs only."),
      effect("Strut damping",
             &EffectSwitches::strut_damping,
             "Stiffness- and mass-proportional damping of the struts."),
      effect(
        "Strut relaxation",
        &EffectSwitches::strut_relaxation,
        "Relaxation of viscoelastic struts; off: they are elastic with their "
        "long-time moduli."),
      effect("Plasticity",
             &EffectSwitches::plasticity,
             "Yielding of elastic-plastic struts; off: they are elastic; auto: "
             "left out while small displacements suffice and no fibre reaches "
             "the yield stress."),
      effect("Gravity", &EffectSwitches::gravity, "Weight."),
      effect("Hinges",
             &EffectSwitches::hinges,
             "Hinges and rotational springs; off: all joints are rigid."),
      effect(
        "Contact",
        &EffectSwitches::contact,
        "Contact of struts with plates and with each other; off: they pass "
        "through each other, which is reported.")};

    const Quantity effects_tolerance = {
      "Tolerance",
      "1e-3",
      "1",
      Range{0, 1, false, true},
      "Relative change of the result up to which effects are left out to save "
      "time."};

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
            "Simulated effects; auto: on if the scene needs the effect.",
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

  namespace
  {
    using dealii::Utilities::trim;

    const Text title = {"Title", "", "Title of the scene."};
    const std::vector<std::pair<std::string, unsigned int>> dimensions =
      {{"2", 2}, {"3", 3}};

    const Choice dimension = {
      "Dimension",
      "2",
      {dimensions[0].first, dimensions[1].first},
      "Dimension of space: 2 for scenes in the x-y plane."};
    const std::vector<std::pair<std::string, Model>> models =
      {{"lattice", Model::lattice}, {"reduced cell", Model::reduced_cell}};

    const Choice model = {
      "Model",
      "lattice",
      {models[0].first, models[1].first},
      "Model: a lattice of beams and connectors by finite elements, or one star "
      "cell of rigid parts with two unknowns."};
    const std::vector<std::pair<std::string, Analysis>> analyses = {
      {"simulation", Analysis::simulation},
      {"static path", Analysis::static_path},
      {"modes", Analysis::modes},
      {"buckling", Analysis::buckling},
      {"frequency response", Analysis::frequency_response},
      {"effective properties", Analysis::effective_properties},
      {"effective response", Analysis::effective_response},
      {"dispersion", Analysis::dispersion},
      {"study", Analysis::study}};

    const Choice analysis = {
      "Analysis",
      "simulation",
      {analyses[0].first,
       analyses[1].first,
       analyses[2].first,
       analyses[3].first,
       analyses[4].first,
       analyses[5].first,
       analyses[6].first,
       analyses[7].first,
       analyses[8].first},
      "Kind of computation. simulation: time steps by Time/Scheme; static path: "
      "equilibria by arc length, through limit points and bifurcations, see "
      "Path; modes: natural frequencies and modes, see Modes; buckling: load "
      "factors at which the lattice buckles, with their modes, see Modes; "
      "frequency response: steady vibrations under harmonic loads, see Frequency "
      "response; effective properties: stiffness, Poisson's ratios and density "
      "of the infinite lattice of these cells; effective response: its stress "
      "under large mean strains, see Mean deformation; dispersion: its waves, "
      "see Dispersion; study: many runs with other parameters, see Study."};
    /** Value of @p word in @p table; nothing for an unknown word. */
    template <class Value>
    std::optional<Value>
    value_of(const std::vector<std::pair<std::string, Value>> &table,
             const std::string                                &word)
    {
      for (const auto &[known, value] : table)
        if (known == word)
          return value;
      return {};
    }

    /** Value of @p choice at the top level of the file, or its default. */
    std::string word_of(const ParameterSubsection &root, const Choice &choice)
    {
      const ParameterEntry *entry = root.find_entry(choice.name);
      return entry == nullptr ? choice.default_value : entry->value;
    }
  } // namespace



  SubsectionSchema general_schema()
  {
    return {"",
            SubsectionSchema::Form::fixed,
            "At the top of the file, outside all subsections.",
            {title, analysis, model, dimension, constants_parameter()},
            "",
            {},
            {Model::lattice, Model::reduced_cell}};
  }



  std::string read_title(const ParameterValues &values)
  {
    return values[title];
  }



  std::string name_of(const Analysis analysis)
  {
    for (const auto &[word, value] : analyses)
      if (value == analysis)
        return word;
    return "";
  }



  Analysis read_analysis(const ParameterValues &values)
  {
    return *value_of(analyses, values[analysis]);
  }



  std::string name_of(const Model model)
  {
    for (const auto &[word, value] : models)
      if (value == model)
        return word;
    return "";
  }



  std::optional<Model> model_of(const ParameterSubsection &root)
  {
    return value_of(models, word_of(root, model));
  }



  std::optional<unsigned int> dimension_of(const ParameterSubsection &root)
  {
    return value_of(dimensions, word_of(root, dimension));
  }

  namespace
  {
    const Text directory = {
      "Directory",
      "output",
      "Output folder, relative to the working directory."};
    const Boolean  graphics          = {"Graphics",
                                        true,
                                        "Whether files for ParaView are written."};
    const Quantity graphics_interval = {
      "Graphics interval",
      "auto",
      "s",
      Range::non_negative(),
      "Time between files for ParaView, interpolated within steps; 0: at start "
      "and end only. auto: a fiftieth of the end time.",
      {"auto"}};
    const Boolean write_stresses = {"Stresses",
                                    true,
                                    "Whether files for ParaView have the "
                                    "stresses of struts."};
    const Integer checkpoints    = {
         "Checkpoints",
         20,
         0,
         1000000,
         "Largest number of checkpoints, after equal numbers of steps; 0: none. "
            "They take at most 0.3 % of the run's time; another one follows SIGINT and "
            "SIGTERM. `auxfem --resume DIR` continues from the last one, with equal "
            "digits."};
    const Integer history_interval = {
      "History interval",
      1,
      1,
      1000000000,
      "Number of steps between two rows of history.csv."};
    const Quantity row_interval = {
      "Time between rows",
      "none",
      "s",
      Range::positive(),
      "Time between two rows of history.csv, instead of a number of steps. "
      "Motions within steps are interpolated with the order of the time scheme; "
      "forces and energies linearly where that motion is out of equilibrium. "
      "none: rows at ends of steps.",
      {"none"}};
    const Integer segments = {
      "Segments per element",
      8,
      1,
      100,
      "Number of straight pieces an element is drawn with."};
    const Boolean effective_strains = {
      "Effective strains",
      false,
      "Whether history.csv has the columns strain.x, strain.y and in space "
      "strain.z: the mean displacement of the joint set right minus that of "
      "left, over their mean distance at rest; likewise top and bottom, front "
      "and back, where both sets exist. The run then reports effective "
      "Poisson's ratios for the loaded axis, y if several are loaded."};

    const Boolean verdict_fails = {
      "Exit code by verdict",
      true,
      "Whether auxfem ends with exit code 3 if the verdict is that the results "
      "are not to be used."};
  } // namespace



  SubsectionSchema output_schema()
  {
    return {"Output",
            SubsectionSchema::Form::fixed,
            "Files of a run.",
            {directory,
             graphics,
             graphics_interval,
             write_stresses,
             history_interval,
             checkpoints,
             row_interval,
             segments,
             effective_strains,
             verdict_fails},
            "",
            {},
            {Model::lattice, Model::reduced_cell}};
  }



  OutputParameters read_output(ParameterValues &values)
  {
    OutputParameters output;
    output.directory = values[directory];
    output.graphics  = values[graphics];
    if (!values.is_word(graphics_interval))
      output.graphics_interval = values[graphics_interval];
    output.stresses         = values[write_stresses];
    output.history_interval = values[history_interval];
    output.checkpoints      = values[checkpoints];
    if (!values.is_word(row_interval))
      output.row_interval = values[row_interval];
    output.segments          = values[segments];
    output.effective_strains = values[effective_strains];
    output.verdict_fails     = values[verdict_fails];
    return output;
  }



  SubsectionSchema probes_schema()
  {
    return {
      "Probes",
      SubsectionSchema::Form::free_entries,
      "Joints whose mean motion is written to history.csv: the name of a set, or "
      "a selection of joints as in Sets (without \"joints: \"). \"rigid: PARTS "
      "@ JOINTS\" gives the rotation of rigid parts, PARTS being a set of struts "
      "or the name of a group of Rigid parts, and, with \"@ JOINTS\", the forces "
      "of these joints on them."};
  }



  ProbeDefinition read_probe(ParameterValues &values)
  {
    return {values.name(), text_of_free_entry(values), values.context.path};
  }
} // namespace auxfem
