#include <auxfem/model/proportional_loads.h>

namespace auxfem
{
  TimeFunction proportional(const TimeFunction &history, const Scene &scene)
  {
    if (scene.analysis != Analysis::static_path)
      return history;
    const double at = scene.path.load_time.value_or(scene.time.end_time);
    return TimeFunction::line(scene.time.static_start ? history.value(0) : 0.,
                              history.value_before(at),
                              history.origin());
  }
} // namespace auxfem
