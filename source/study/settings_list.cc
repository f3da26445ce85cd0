#include <auxfem/parameters/errors.h>
#include <auxfem/study/settings_list.h>

#include <algorithm>

namespace auxfem
{
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
    const Settings          own = settings_of(scene);
    std::vector<PlannedRun> planned;
    for (std::size_t i = 0; i < list.size(); ++i)
      {
        planned.push_back({name_of_run(scene, list[i]),
                           scene_with(scene, overrides(own, list[i])),
                           repetitions[i]});
        if (planned.back().scene.time.scheme->is_dynamic() !=
            scene.time.scheme->is_dynamic())
          throw InputError(
            scene.file + ": Study/Schemes: " + list[i].scheme +
            " computes something else than Time/Scheme = " + own.scheme +
            ", statics or dynamics, so that they cannot be "
            "compared. Remove one of them");
      }
    return planned;
  }



  std::vector<MeasuredRun>
  SettingsList::of(const std::vector<Settings>    &settings,
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
      settings.scheme + ", step " + short_number(settings.time_step) + " s";
    if (settings.time_tolerance)
      name +=
        " and less to an error of " + short_number(*settings.time_tolerance);
    if (settings.newton_tolerance != scene.newton.tolerance)
      name += ", Newton tolerance " + short_number(settings.newton_tolerance);
    return name;
  }
} // namespace auxfem
