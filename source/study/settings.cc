#include <auxfem/parameters/errors.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/study/settings.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace auxfem
{
  bool operator==(const Settings &one, const Settings &other)
  {
    return overrides(one, other).empty();
  }

  Settings settings_of(const Scene &scene)
  {
    return {scene.discretization.order,
            scene.discretization.refinements,
            scene.time.step,
            scene.newton.tolerance,
            scene.time.scheme->name(),
            scene.time.relative_tolerance};
  }

  std::vector<std::string> overrides(const Settings &from, const Settings &to)
  {
    std::vector<std::string> assignments;
    const auto               assign = [&assignments](const std::string &path,
                                       const auto        &former,
                                       const auto        &value,
                                       const std::string &text) {
      if (former != value)
        assignments.push_back(path + "=" + text);
    };
    assign("Discretization/Order",
           from.order,
           to.order,
           std::to_string(to.order));
    assign("Discretization/Global refinements",
           from.refinements,
           to.refinements,
           std::to_string(to.refinements));
    assign("Time/Scheme", from.scheme, to.scheme, to.scheme);
    assign("Time/Time step",
           from.time_step,
           to.time_step,
           number_text(to.time_step));
    assign("Time/Relative tolerance",
           from.time_tolerance,
           to.time_tolerance,
           to.time_tolerance ? number_text(*to.time_tolerance) : "none");
    assign("Newton/Tolerance",
           from.newton_tolerance,
           to.newton_tolerance,
           number_text(to.newton_tolerance));
    return assignments;
  }

  std::string command_line_text(const std::vector<std::string> &overrides)
  {
    std::string text;
    for (const std::string &assignment : overrides)
      text += " --set \"" + assignment + "\"";
    return text;
  }

  Scene scene_with(const Scene                    &scene,
                   const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all = {"Analysis=simulation"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    try
      {
        return read_scene_from_text(scene.all_parameters, scene.file, all);
      }
    catch (const InputError &error)
      {
        throw InputError("The study contains an invalid simulation, with" +
                         command_line_text(overrides) + ":\n" + error.what());
      }
  }

  void SettingsList::add(const std::vector<Settings> &settings,
                         const unsigned int           n_times)
  {
    for (const Settings &one : settings)
      if (index(one) == list.size())
        {
          list.push_back(one);
          repetitions.push_back(n_times);
        }
  }

  std::vector<PlannedRun> SettingsList::planned_runs(const Scene &scene) const
  {
    const Settings          scene_settings = settings_of(scene);
    std::vector<PlannedRun> planned;
    for (std::size_t i = 0; i < list.size(); ++i)
      {
        planned.push_back(
          {name_of_run(scene, list[i]),
           scene_with(scene, overrides(scene_settings, list[i])),
           repetitions[i]});
        if (planned.back().scene.time.scheme->is_dynamic() !=
            scene.time.scheme->is_dynamic())
          throw InputError(
            scene.file + ": Study/Schemes: " + list[i].scheme +
            " cannot be compared with Time/Scheme = " + scene_settings.scheme +
            ", because only one of them is dynamic. Remove one of them");
      }
    return planned;
  }

  std::vector<MeasuredRun>
  SettingsList::results_for(const std::vector<Settings>    &settings,
                            const std::vector<MeasuredRun> &runs) const
  {
    std::vector<MeasuredRun> result;
    result.reserve(settings.size());
    for (const Settings &one : settings)
      result.push_back(runs[index(one)]);
    return result;
  }

  std::size_t SettingsList::index(const Settings &settings) const
  {
    return std::find(list.begin(), list.end(), settings) - list.begin();
  }

  std::string name_of_run(const Scene &scene, const Settings &settings)
  {
    std::string name;
    if (scene.context.model == Model::lattice)
      name = "order " + std::to_string(settings.order) + ", " +
        std::to_string(settings.elements()) +
        (settings.elements() == 1 ? " element a strut, "
                                  : " elements a strut, ");
    name +=
      settings.scheme + ", step " + number_text(settings.time_step) + " s";
    if (settings.time_tolerance)
      name +=
        " and less to an error of " + number_text(*settings.time_tolerance);
    if (settings.newton_tolerance != scene.newton.tolerance)
      name += ", Newton tolerance " + number_text(settings.newton_tolerance);
    return name;
  }

  std::vector<unsigned int>
  tried_orders(const Scene &scene, const std::vector<unsigned int> &automatic)
  {
    if (!has_mesh(scene))
      return {};
    return sorted_values(scene.study.orders.value_or(automatic), std::less<>());
  }

  std::vector<unsigned int> tried_refinements(const Scene       &scene,
                                              const unsigned int further)
  {
    if (!has_mesh(scene))
      return {};
    std::vector<unsigned int> automatic;
    for (unsigned int i = 0; i <= further; ++i)
      automatic.push_back(scene.discretization.refinements + i);
    return sorted_values(scene.study.refinements.value_or(automatic),
                         std::less<>());
  }

  std::vector<double> tried_time_steps(const Scene               &scene,
                                       const std::vector<double> &factors)
  {
    std::vector<double> automatic;
    if (scene.time.scheme->is_dynamic())
      for (const double factor : factors)
        automatic.push_back(factor * scene.time.step);
    return sorted_values(scene.study.time_steps.value_or(automatic),
                         std::greater<>());
  }

  std::vector<std::string> tried_schemes(const Scene &scene)
  {
    return values_or(scene.study.schemes, scene.time.scheme->name());
  }

  unsigned int highest_order(const Scene &scene)
  {
    return highest_strut_order(scene.context.dimension);
  }

  bool has_mesh(const Scene &scene)
  {
    return scene.context.model == Model::lattice;
  }

  std::vector<Settings> finer_meshes(const Scene    &scene,
                                     const Settings &settings,
                                     const bool      raises_order)
  {
    std::vector<Settings> finer(2, settings);
    if (!has_mesh(scene))
      return finer;
    const bool raises = raises_order && settings.order < highest_order(scene);
    for (unsigned int i = 0; i < finer.size(); ++i)
      {
        finer[i].order += raises;
        finer[i].refinements += raises ? i : i + 1;
      }
    return finer;
  }

  void halve_time_steps(std::vector<Settings> &settings)
  {
    for (std::size_t i = 0; i < settings.size(); ++i)
      settings[i].time_step = std::ldexp(settings[i].time_step, -int(i) - 1);
  }
} // namespace auxfem
