#include <auxfem/scene/step_ends.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Kind = TimeEvent::Kind;

    /** Kinks that follow each other as those of a pulse or two may do. */
    constexpr std::size_t most_kinks_of_pulses = 8;

    /** @p events without kinks that come in long rows, each nearer than @p step
     * (s) to the one before. */
    std::vector<TimeEvent> without_dense_kinks(std::vector<TimeEvent> events,
                                               const double           step)
    {
      std::vector<TimeEvent> result;
      for (std::size_t first = 0, after; first < events.size(); first = after)
        {
          after = first + 1;
          while (after < events.size() &&
                 events[after].time - events[after - 1].time < step)
            ++after;
          for (std::size_t i = first; i < after; ++i)
            if (events[i].kind == Kind::jump ||
                after - first <= most_kinks_of_pulses)
              result.push_back(events[i]);
        }
      return result;
    }
  } // namespace

  std::vector<TimeFunction> functions_of_time(const Scene &scene)
  {
    std::vector<TimeFunction> functions;
    const auto                add = [&functions](const auto &components) {
      functions.insert(functions.end(), components.begin(), components.end());
    };
    for (const JointLoadDefinition &load : scene.joint_loads)
      add(load.components);
    for (const LineLoadDefinition &load : scene.line_loads)
      add(load.components);
    for (const SupportDefinition &support : scene.supports)
      add(support.motion);
    return functions;
  }

  std::vector<TimeEvent> step_ends(const Scene &scene)
  {
    const TimeParameters  &time = scene.time;
    std::vector<TimeEvent> all;
    for (const TimeFunction &function : functions_of_time(scene))
      for (const TimeEvent &event :
           without_dense_kinks(function.events(0, time.end_time), time.step))
        all.push_back(event);
    std::sort(all.begin(), all.end(), [](const auto &one, const auto &other) {
      return one.time < other.time;
    });
    // Of events at one time a jump counts.
    std::vector<TimeEvent> ends;
    for (const TimeEvent &event : all)
      if (ends.empty() ||
          event.time - ends.back().time > time_resolution(event.time))
        ends.push_back(event);
      else if (event.kind == Kind::jump)
        ends.back().kind = Kind::jump;
    return ends;
  }
} // namespace auxfem
