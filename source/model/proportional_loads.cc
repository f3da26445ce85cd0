#include <auxfem/model/proportional_loads.h>

namespace auxfem
{
  namespace
  {
    /** When loads are those of the load factor 1; nothing: there is none. */
    std::optional<double> time_of_reference(const Scene &scene)
    {
      if (scene.analysis == Analysis::static_path)
        return scene.path.load_time.value_or(scene.time.end_time);
      if (scene.analysis == Analysis::frequency_response)
        return scene.frequency_response.load_time.value_or(scene.time.end_time);
      return std::nullopt;
    }
  } // namespace

  bool has_load_factor(const Scene &scene)
  {
    return time_of_reference(scene).has_value();
  }

  TimeFunction proportional(const TimeFunction &history, const Scene &scene)
  {
    const std::optional<double> reference = time_of_reference(scene);
    if (!reference)
      return history;
    return TimeFunction::line(scene.time.static_start ? history.value(0) : 0.,
                              history.value_before(*reference),
                              history.origin());
  }
} // namespace auxfem
