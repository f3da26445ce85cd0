#include <auxfem/scene/step_ends.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Kind = TimeEvent::Kind;
    using Jump = StepEnd::Jump;

    std::vector<TimeFunction> loads_of(const RunPlan &plan)
    {
      std::vector<TimeFunction> functions;
      const auto                add = [&functions](const auto &components) {
        functions.insert(functions.end(), components.begin(), components.end());
      };
      for (const JointLoadDefinition &load : plan.joint_loads())
        add(load.components);
      for (const LineLoadDefinition &load : plan.scene.line_loads)
        add(load.components);
      add(plan.scene.gravity.courses());
      return functions;
    }

    std::vector<TimeFunction> motions_of(const RunPlan &plan)
    {
      std::vector<TimeFunction> functions;
      for (const SupportDefinition &support : plan.scene.supports)
        functions.insert(functions.end(),
                         support.motion.begin(),
                         support.motion.end());
      return functions;
    }

    /** Events up to the end of a run, where the last step takes the value
     * before a jump and a resumed run the value after it. */
    std::vector<TimeEvent> events_of(const TimeFunction   &function,
                                     const TimeParameters &time,
                                     const unsigned int    derivatives = 1)
    {
      return function.events(0,
                             time.end_time + 2 * time_resolution(time.end_time),
                             derivatives);
    }

    /** @p events without kinks that come in long rows, each nearer than @p step
     * (s) to the one before. */
    std::vector<TimeEvent>
    without_dense_kinks(const std::vector<TimeEvent> &events, const double step)
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

    /**
     * Of functions that are sampled by the steps where they are rough.
     * @param jump what jumps with them
     */
    void add_ends_of_samples(const std::vector<TimeFunction> &functions,
                             const TimeParameters            &time,
                             const Jump                       jump,
                             std::vector<StepEnd>            &ends)
    {
      for (const TimeFunction &function : functions)
        for (const TimeEvent &event :
             without_dense_kinks(events_of(function, time), time.step))
          ends.push_back(
            {event.time, event.kind == Kind::jump ? jump : Jump::none});
    }

    /** Of functions that a scene at rest does not begin with. */
    void add_sudden_start(const std::vector<TimeFunction> &functions,
                          const Jump                       jump,
                          std::vector<StepEnd>            &ends)
    {
      if (std::any_of(functions.begin(),
                      functions.end(),
                      [](const TimeFunction &function) {
                        return function.value_after(0) != 0;
                      }))
        ends.push_back({0, jump});
    }

    /** What jumps in a scene without inertia with loads, with motions. */
    constexpr Jump with_loads   = Jump::accelerations,
                   with_motions = Jump::velocities;

    /** At times that the user gives anything may jump that is not constant. */
    void add_given_ends(const std::vector<double>       &times,
                        const std::vector<TimeFunction> &motions,
                        std::vector<StepEnd>            &ends)
    {
      const bool moves = std::any_of(motions.begin(),
                                     motions.end(),
                                     [](const TimeFunction &motion) {
                                       return !motion.is_constant();
                                     });
      for (const double time : times)
        ends.push_back({time, moves ? with_motions : with_loads});
    }

    /** Of motions with inertia. */
    void add_ends_of_motions(const std::vector<TimeFunction> &functions,
                             const TimeParameters            &time,
                             std::vector<StepEnd>            &ends)
    {
      constexpr unsigned int accelerations = 2;
      for (const TimeFunction &function : functions)
        for (const TimeEvent &event : events_of(function, time, accelerations))
          ends.push_back({event.time,
                          event.kind == Kind::bend ? Jump::accelerations
                                                   : Jump::velocities});
    }
  } // namespace

  std::vector<TimeFunction> functions_of_time(const RunPlan &plan)
  {
    std::vector<TimeFunction> functions = loads_of(plan);
    for (const TimeFunction &motion : motions_of(plan))
      functions.push_back(motion);
    return functions;
  }

  double nearness_of_step_ends(const TimeParameters &time)
  {
    return 1e-6 * time.step;
  }

  std::vector<StepEnd> step_ends(const RunPlan &plan)
  {
    const TimeParameters           &time    = plan.time;
    const std::vector<TimeFunction> loads   = loads_of(plan),
                                    motions = motions_of(plan);
    std::vector<StepEnd> all;
    add_given_ends(time.events, motions, all);
    add_ends_of_samples(loads, time, with_loads, all);
    if (time.scheme->is_dynamic())
      add_ends_of_motions(motions, time, all);
    else
      {
        add_ends_of_samples(motions, time, with_motions, all);
        if (!time.static_start)
          {
            add_sudden_start(loads, with_loads, all);
            add_sudden_start(motions, with_motions, all);
          }
      }
    std::sort(all.begin(), all.end(), [](const auto &one, const auto &other) {
      return one.time < other.time;
    });
    std::vector<StepEnd> ends;
    for (const StepEnd &end : all)
      if (ends.empty() ||
          end.time - ends.back().time > time_resolution(end.time))
        ends.push_back(end);
      else
        ends.back().jump = std::max(ends.back().jump, end.jump);
    return ends;
  }

  StepEnds::StepEnds(const RunPlan &plan)
    : near(nearness_of_step_ends(plan.time))
    , ends(step_ends(plan))
  {}

  double StepEnds::next(const double time, const double end_of_scene_step) const
  {
    const auto next = at(time).second;
    return next != ends.end() && next->time < end_of_scene_step - near
      ? next->time
      : end_of_scene_step;
  }

  std::pair<StepEnds::Iterator, StepEnds::Iterator>
  StepEnds::at(const double time) const
  {
    return {std::lower_bound(ends.begin(),
                             ends.end(),
                             time - near,
                             [](const StepEnd &end, const double time) {
                               return end.time < time;
                             }),
            std::upper_bound(ends.begin(),
                             ends.end(),
                             time + near,
                             [](const double time, const StepEnd &end) {
                               return time < end.time;
                             })};
  }

  std::optional<Jump> StepEnds::jump_at(const double time) const
  {
    const auto [first, after] = at(time);
    if (first == after)
      return {};
    Jump jump = Jump::none;
    std::for_each(first, after, [&jump](const StepEnd &end) {
      jump = std::max(jump, end.jump);
    });
    return jump;
  }

  std::optional<double> StepEnds::event_at_begin(const double time) const
  {
    const auto [first, after] = at(time);
    if (first != after)
      return std::prev(after)->time;
    return time == 0 ? std::optional<double>(0.) : std::nullopt;
  }

  std::optional<TimeLimit> StepEnds::event_at_end(const double time) const
  {
    const auto [first, after] = at(time);
    if (first == after)
      return {};
    return TimeLimit{first->time, TimeSide::before};
  }
} // namespace auxfem
