#include <auxfem/study/settings_list.h>

#include <algorithm>

namespace auxfem
{
  void SettingsList::add(const Settings &settings)
  {
    if (index(settings) == list.size())
      list.push_back(settings);
  }



  void SettingsList::add(const std::vector<Settings> &settings)
  {
    for (const Settings &one : settings)
      add(one);
  }



  const std::vector<Settings> &SettingsList::all() const
  {
    return list;
  }



  std::vector<PlannedRun>
  SettingsList::planned_runs(const Scene       &scene,
                             const unsigned int repetitions) const
  {
    const Settings          own = settings_of(scene);
    std::vector<PlannedRun> planned;
    for (const Settings &settings : list)
      planned.push_back({name_of_run(scene, settings),
                         scene_with(scene, overrides(own, settings)),
                         repetitions});
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
