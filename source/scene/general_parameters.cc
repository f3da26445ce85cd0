#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
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

  namespace
  {
    using dealii::Utilities::trim;

    const Text title = {"Title", "", "Title of the scene, for people."};
    const std::vector<std::pair<std::string, unsigned int>> dimensions =
      {{"2", 2}, {"3", 3}};

    const Choice dimension = {
      "Dimension",
      "2",
      {dimensions[0].first, dimensions[1].first},
      "Dimension of space: 2 for scenes in the plane of x and y."};
    const std::vector<std::pair<std::string, Model>> models =
      {{"lattice", Model::lattice}, {"reduced cell", Model::reduced_cell}};

    const Choice model = {
      "Model",
      "lattice",
      {models[0].first, models[1].first},
      "What is simulated: a lattice of beams and connectors by finite elements, "
      "or one star cell of rigid parts with two unknowns."};
    const std::vector<std::pair<std::string, Analysis>> analyses = {
      {"simulation", Analysis::simulation},
      {"static path", Analysis::static_path},
      {"modes", Analysis::modes},
      {"buckling", Analysis::buckling},
      {"frequency response", Analysis::frequency_response},
      {"study", Analysis::study}};

    const Choice analysis = {
      "Analysis",
      "simulation",
      {analyses[0].first,
       analyses[1].first,
       analyses[2].first,
       analyses[3].first,
       analyses[4].first,
       analyses[5].first},
      "What is computed. simulation: the scene, by Time/Scheme; static path: "
      "equilibria of a lattice by arc length, through limit points and "
      "bifurcations, see Path; modes: natural "
      "frequencies and modes of a lattice, buckling: factors of its loads at "
      "which it buckles, with their modes, see Modes; frequency response: steady vibrations under harmonic "
      "loads, see Frequency response; study: the scene again and "
      "again with other parameters, see Study."};
    const Text constants = {
      "Constants",
      "",
      "Constants for expressions, \"name = value, name = value\"; a value is a "
      "number, which may have a unit word and then counts in SI, or an "
      "expression of the constants before it, e.g. \"L = 20 mm, h = L/4\"."};

    /** What @p word stands for in @p table; nothing if it is none of it. */
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

    /** The word of @p choice at the top level of the file, or its default. */
    std::string chosen(const ParameterSubsection &root, const Choice &choice)
    {
      const ParameterEntry *entry = root.find_entry(choice.name);
      return entry == nullptr ? choice.default_value : entry->value;
    }

    bool is_identifier(const std::string &name)
    {
      const auto letter = [](const char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
      };
      return !name.empty() && letter(name[0]) &&
        std::all_of(name.begin(), name.end(), [&letter](const char c) {
          return letter(c) || (c >= '0' && c <= '9');
        });
    }

    using Constants = std::vector<std::pair<std::string, double>>;

    /** @p text cut at the commas that are outside of parentheses. */
    std::vector<std::string> split_definitions(const std::string &text)
    {
      std::vector<std::string> items;
      int                      depth = 0;
      for (const char c : text)
        {
          depth += (c == '(') - (c == ')');
          if (items.empty() || (c == ',' && depth == 0))
            items.emplace_back();
          if (c != ',' || depth != 0)
            items.back() += c;
        }
      return items;
    }

    /** @param known the constants that @p item may refer to */
    std::pair<std::string, double> read_constant(const std::string &item,
                                                 const Constants   &known)
    {
      // names that expressions have a meaning for already
      static const std::set<std::string> taken = {"t",
                                                  "x",
                                                  "y",
                                                  "z",
                                                  "pi",
                                                  "e",
                                                  "_pi",
                                                  "_e",
                                                  "xmin",
                                                  "xmax",
                                                  "ymin",
                                                  "ymax",
                                                  "zmin",
                                                  "zmax"};
      const std::string message = "Constants = ... " + item + " ...: ";
      const std::size_t equals  = item.find('=');
      const std::string name    = trim(item.substr(0, equals));
      if (equals == std::string::npos || !is_identifier(name))
        throw InputError(message +
                         "not understood; write name = number, the name of "
                         "letters, digits and _, e.g. Constants = F0 = 1.0, t0 "
                         "= 10 ms, t1 = 2*t0");
      if (taken.count(name) != 0)
        throw InputError(message + "the name \"" + name +
                         "\" has a meaning in expressions already; choose "
                         "another one");
      try
        {
          return {name, constant_value(trim(item.substr(equals + 1)), known)};
        }
      catch (const InputError &error)
        {
          throw InputError(message + error.what());
        }
    }
  } // namespace



  SubsectionSchema general_schema()
  {
    return {"",
            SubsectionSchema::Form::fixed,
            "At the top of the file, outside all subsections.",
            {title, analysis, model, dimension, constants},
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



  std::vector<std::pair<std::string, double>>
  read_constants(const ParameterValues &values)
  {
    Constants result;
    for (const std::string &item : split_definitions(values[constants]))
      {
        const auto constant = read_constant(trim(item), result);
        for (const auto &other : result)
          if (other.first == constant.first)
            throw InputError("Constants: \"" + constant.first +
                             "\" is given twice; remove one of them");
        result.push_back(constant);
      }
    return result;
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
    return value_of(models, chosen(root, model));
  }



  std::optional<unsigned int> dimension_of(const ParameterSubsection &root)
  {
    return value_of(dimensions, chosen(root, dimension));
  }

  namespace
  {
    const Text directory = {
      "Directory",
      "output",
      "Folder for everything a run writes, from where auxfem is called."};
    const Boolean  graphics          = {"Graphics",
                                        true,
                                        "Whether files for ParaView are written."};
    const Quantity graphics_interval = {
      "Graphics interval",
      "0 s",
      "s",
      Range::non_negative(),
      "Time between two of them, from within steps if these do not end there; 0: "
      "at start and end only."};
    const Integer checkpoints = {
      "Checkpoints",
      20,
      0,
      1000000,
      "Number of checkpoints, after equal numbers of steps. `auxfem --resume DIR` "
      "continues from the last one, with equal digits. They are written as often "
      "as 0.3 % of the run's time allow, and after SIGINT and SIGTERM. 0: none."};
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
      "Time between two rows of history.csv, in place of a number of steps: from "
      "within steps, by polynomials of the order of the time scheme, if these do "
      "not end there. So steps may be as long as accuracy allows. Forces and "
      "energies are straight lines where that motion is out of equilibrium. "
      "none: at ends of steps.",
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
      "left over their mean distance at rest, so too for top and bottom, front "
      "and back, where both sets exist and are apart. The last lines of a run "
      "then give effective Poisson's ratios for the axis that is loaded, y if "
      "that is not one alone."};

    const Boolean verdict_fails = {
      "Exit code by verdict",
      true,
      "Whether auxfem ends with exit code 3 where the verdict on a run is that "
      "its results are not to be used."};
  } // namespace



  SubsectionSchema output_schema()
  {
    return {"Output",
            SubsectionSchema::Form::fixed,
            "What a run writes.",
            {directory,
             graphics,
             graphics_interval,
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
    output.directory         = values[directory];
    output.graphics          = values[graphics];
    output.graphics_interval = values[graphics_interval];
    output.history_interval  = values[history_interval];
    output.checkpoints       = values[checkpoints];
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
      "Sets of joints whose mean motion goes to history.csv: the name "
      "of a set, or a selection of joints as in Sets (without "
      "\"joints: \"); or \"rigid: PARTS @ JOINTS\", PARTS a set of struts or "
      "the name of a group of Rigid parts, for the rotation of these parts "
      "and, if \"@ JOINTS\" is given, the forces of these "
      "joints on them."};
  }



  ProbeDefinition read_probe(ParameterValues &values)
  {
    return {values.name(), text_of_free_entry(values), values.context.path};
  }
} // namespace auxfem
