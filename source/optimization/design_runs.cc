#include <auxfem/optimization/design_runs.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/scene/constants.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** Text of the parameter @p path in @p root; none if it is not there. */
    std::optional<std::string> text_at(const ParameterSubsection &root,
                                       const std::string         &path)
    {
      if (const auto constant = constant_in(path))
        return text_of_constant(root, *constant);
      const std::vector<std::string> names =
        dealii::Utilities::split_string_list(path, '/');
      const ParameterSubsection *subsection = &root;
      for (std::size_t i = 0; i + 1 < names.size() && subsection != nullptr;
           ++i)
        subsection = subsection->find_subsection(names[i]);
      const ParameterEntry *entry =
        subsection == nullptr ? nullptr : subsection->find_entry(names.back());
      if (entry == nullptr)
        return {};
      return entry->value;
    }

    /** Unit of the parameter @p path, in which numbers without unit are; of a
     * constant or an unknown parameter none. */
    std::optional<std::string> declared_unit(const std::string &path)
    {
      const std::string name       = path.substr(path.rfind('/') + 1);
      const std::string subsection = path.find('/') == std::string::npos
        ? ""
        : path.substr(0, path.find('/'));
      for (const SubsectionSchema &schema : scene_schemas())
        if (schema.name == subsection)
          {
            if (const Parameter *found = find_by_name(schema.parameters, name))
              return found->unit;
            for (const SubsectionVariant &variant : schema.variants)
              if (const Parameter *found =
                    find_by_name(variant.parameters, name))
                return found->unit;
          }
      return {};
    }

    /** Number of @p text in the unit of @p variable. Throws InputError if one
     * has a unit that does not fit the other. */
    double number_in(const DesignVariable &variable, const std::string &text)
    {
      const ParsedQuantity quantity = split_quantity(text);
      if (quantity.unit.empty() && variable.unit.empty())
        return quantity.number;
      if (variable.unit.empty())
        throw InputError("its bounds need a unit, as the value of the scene, " +
                         text + ", has one, e.g. " + quantity.unit);
      const Unit bounds = parse_unit(variable.unit);
      if (quantity.unit.empty() && constant_in(variable.path))
        return quantity.number / bounds.factor;
      const std::string own  = quantity.unit.empty()
         ? declared_unit(variable.path).value_or("1")
         : quantity.unit;
      const Unit        unit = parse_unit(own);
      if (unit.dimension != bounds.dimension)
        throw InputError(
          "its bounds are in " + variable.unit +
          ", which does not fit the value of the scene, " + text +
          (quantity.unit.empty() && own != "1" ? ", in " + own : "") +
          ". Give both in units of the same kind");
      return quantity.number * unit.factor / bounds.factor;
    }

    /** Throws InputError if @p text is no number, from which a search may
     * begin. */
    void require_number(const std::string &text)
    {
      try
        {
          const std::string unit = split_quantity(text).unit;
          if (!unit.empty())
            parse_unit(unit);
        }
      catch (const InputError &error)
        {
          throw InputError("the search cannot begin at the value of the "
                           "scene, " +
                           text + ": " + error.what() +
                           ". Give a number there, or vary the constant that "
                           "it refers to, Constants/NAME");
        }
    }
  } // namespace

  DesignPoint first_design(const Scene &scene)
  {
    const ParameterSubsection root =
      parse_parameter_text(scene.all_parameters, scene.file);
    DesignPoint point;
    for (const DesignVariable &variable : scene.optimization.variables)
      {
        const std::string path = "Design variables/" + variable.path + ": ";
        for (const std::string subsection :
             {"Optimization/", "Output/", "Quantities/", "Sampling/"})
          if (variable.path.compare(0, subsection.size(), subsection) == 0)
            throw InputError(path +
                             "it changes no run. Vary what the runs depend on");
        const std::optional<std::string> text = text_at(root, variable.path);
        if (!text)
          throw InputError(path +
                           "the scene has no such parameter. Write its path as "
                           "in parameters.prm, e.g. Lattice/Opening angle, "
                           "Sections/NAME/Height");
        double value = 0;
        try
          {
            require_number(*text);
            value = number_in(variable, *text);
          }
        catch (const InputError &error)
          {
            throw InputError(path + error.what());
          }
        // Round-off of units must not put a value beyond its bound.
        const double part = variable.part_at(value), nearness = 1e-9;
        if (!(part >= -nearness && part <= 1 + nearness))
          throw InputError(path + "the value of the scene, " + *text +
                           ", from which the search begins, is not within the "
                           "bounds " +
                           variable.text_at(0) + " and " + variable.text_at(1));
        point.push_back(std::clamp(part, 0., 1.));
      }
    return point;
  }

  std::vector<std::string> texts_of(const Scene       &scene,
                                    const DesignPoint &point)
  {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < point.size(); ++i)
      texts.push_back(scene.optimization.variables[i].text_at(point[i]));
    return texts;
  }

  bool Design::is_usable() const
  {
    return goals && exit_state == "completed" &&
      verdict != name_of(Verdict::not_to_be_used);
  }

  Json json_of(const Design &design)
  {
    Json json = {{"point", design.point},
                 {"folder", design.folder},
                 {"verdict", design.verdict},
                 {"exit_state", design.exit_state}};
    if (design.goals)
      json.update({{"objectives", design.goals->objectives},
                   {"limited", design.goals->limited},
                   {"limits", design.goals->limits}});
    return json;
  }

  Design design_of(const Json &json)
  {
    Design design;
    design.point      = json.at("point").get<DesignPoint>();
    design.folder     = json.at("folder");
    design.verdict    = json.at("verdict");
    design.exit_state = json.at("exit_state");
    if (json.contains("objectives"))
      {
        const auto numbers = [&json](const std::string &name) {
          return json.at(name).get<std::vector<double>>();
        };
        design.goals = {numbers("objectives"),
                        numbers("limited"),
                        numbers("limits")};
      }
    return design;
  }

  bool is_better(const Design      &one,
                 const Design      &other,
                 const Goals       &goals,
                 const double       tolerance,
                 const unsigned int objective)
  {
    if (!one.is_usable() || !other.is_usable())
      return one.is_usable();
    const double excess       = goals.largest_excess(*one.goals),
                 other_excess = goals.largest_excess(*other.goals);
    if (excess > tolerance || other_excess > tolerance)
      return excess < other_excess;
    return goals.merit(*one.goals, objective) <
      goals.merit(*other.goals, objective);
  }

  DesignRuns::DesignRuns(const Scene               &scene,
                         Goals                     &goals,
                         const MPI_Comm             communicator,
                         const FileRules           &rules,
                         const std::string         &parent,
                         const std::vector<Design> &known_designs,
                         DesignListener             listener)
    : designed_scene(scene)
    , goal_values(goals)
    , ranks(communicator)
    , rules(rules)
    , parent(parent)
    , listener(std::move(listener))
  {
    for (const Design &design : known_designs)
      known[texts_of(scene, design.point)] = design;
  }

  const Design &DesignRuns::at(const DesignPoint &point)
  {
    run({point});
    return known.at(texts_of(designed_scene, point));
  }

  std::vector<Design> DesignRuns::at_all(const std::vector<DesignPoint> &points)
  {
    run(points);
    std::vector<Design> designs;
    designs.reserve(points.size());
    for (const DesignPoint &point : points)
      designs.push_back(known.at(texts_of(designed_scene, point)));
    return designs;
  }

  void DesignRuns::run(const std::vector<DesignPoint> &points)
  {
    std::vector<Design>    planned;
    std::vector<SceneCase> cases;
    for (const DesignPoint &point : points)
      {
        Design design;
        design.point  = point;
        design.folder = numbered_folder(parent, list.size() + cases.size() + 1);
        if (!known.emplace(texts_of(designed_scene, point), design).second)
          continue;
        cases.push_back(case_of_design(designed_scene, point, design.folder));
        planned.push_back(design);
      }
    const std::vector<CaseEnd> ends =
      run_cases(designed_scene,
                cases,
                ranks,
                rules,
                [](std::size_t, const CaseEnd &, int) {});
    for (std::size_t i = 0; i < planned.size(); ++i)
      {
        const CaseResults results =
          results_on_all_ranks(designed_scene, cases[i], ends[i], ranks);
        planned[i].verdict    = results.verdict;
        planned[i].exit_state = results.exit_state;
        planned[i].is_reused  = ends[i].is_reused;
        if (!results.results.empty())
          planned[i].goals = goal_values.values(results.results);
        if (!planned[i].goals && planned[i].exit_state == "completed")
          planned[i].exit_state = "an objective or a constraint is no number";
        known[texts_of(designed_scene, planned[i].point)] = planned[i];
        list.push_back(planned[i]);
        if (dealii::Utilities::MPI::this_mpi_process(ranks) == 0)
          listener(planned[i]);
      }
  }

  SceneCase case_of_design(const Scene       &scene,
                           const DesignPoint &point,
                           const std::string &folder)
  {
    std::vector<std::string> paths;
    for (const DesignVariable &variable : scene.optimization.variables)
      paths.push_back(variable.path);
    SceneCase one = scene_case(folder, paths, texts_of(scene, point));
    one.overrides.emplace_back("Output/Graphics=false");
    one.overrides.emplace_back("Output/Checkpoints=0");
    return one;
  }

  CaseResults results_on_all_ranks(const Scene     &scene,
                                   const SceneCase &one,
                                   const CaseEnd   &end,
                                   const MPI_Comm   communicator)
  {
    std::string text;
    on_first_rank(communicator, [&]() {
      const CaseResults found = results_of(scene, one, end);
      text                    = Json{{"results", found.results},
                  {"verdict", found.verdict},
                  {"exit_state", found.exit_state}}
               .dump(-1, ' ', false, Json::error_handler_t::replace);
    });
    const Json  json = Json::parse(broadcast_text(0, text, communicator));
    CaseResults results;
    // JSON has no numbers that are not finite.
    for (const Json &pair : json.at("results"))
      if (pair.at(1).is_number())
        results.results.emplace_back(pair.at(0), pair.at(1));
    results.verdict    = json.at("verdict");
    results.exit_state = json.at("exit_state");
    return results;
  }
} // namespace auxfem
