#include <auxfem/analysis/step_ends.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Kind = TimeEvent::Kind;

    /** All functions of time that act on the lattice. */
    std::vector<TimeFunction> functions_of(const Scene &scene)
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

    /** @p events without kinks nearer than @p step (s) to another event. */
    std::vector<TimeEvent> without_dense_kinks(std::vector<TimeEvent> events,
                                               const double           step)
    {
      std::vector<TimeEvent> result;
      for (std::size_t i = 0; i < events.size(); ++i)
        {
          const bool follows =
                       i > 0 && events[i].time - events[i - 1].time < step,
                     precedes = i + 1 < events.size() &&
            events[i + 1].time - events[i].time < step;
          if (events[i].kind == Kind::jump || !(follows || precedes))
            result.push_back(events[i]);
        }
      return result;
    }
  } // namespace

  std::vector<TimeEvent> step_ends(const Scene &scene)
  {
    const TimeParameters  &time = scene.time;
    std::vector<TimeEvent> all;
    for (const TimeFunction &function : functions_of(scene))
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
