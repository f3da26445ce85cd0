#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/step_ends.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

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
      add(plan.scene.gravity.varying_components());
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
                after - first <= max_pulse_kinks)
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

  namespace
  {
    /**
     * Part of a load's largest value that a step may miss without a note.
     * @tuned judgement
     */
    constexpr double allowed_departure = 0.25;

    constexpr unsigned long most_samples = 1 << 18, most_samples_a_step = 64;

    /** Where a function departs most from the line that a step takes it for. */
    struct Departure
    {
      double begin, end; ///< of the step (s)
      double time;       ///< s
      double size;
    };

    /** The times at which steps end if none fails, with 0. */
    std::vector<double> stops_of(const RunPlan              &plan,
                                 const std::vector<StepEnd> &ends)
    {
      const TimeParameters &time = plan.time;
      const double          near = nearness_of_step_ends(time);
      std::vector<double>   stops{0.};
      auto                  event = ends.begin();
      for (unsigned long step = 1; step <= time.n_steps(); ++step)
        {
          const double end = time.time_at(step);
          for (; event != ends.end() && event->time < end - near; ++event)
            if (event->time > stops.back() + near)
              stops.push_back(event->time);
          stops.push_back(end);
        }
      return stops;
    }

    /** Looks at one function between two stops after the other. */
    class Sampling
    {
    public:
      Sampling(const TimeFunction   &function,
               const TimeParameters &time,
               const unsigned long   n_stops)
        : function(function)
        , events(function.events(0, time.end_time))
        , event(events.begin())
        , n_samples(
            std::clamp(most_samples / n_stops, 1UL, most_samples_a_step))
      {}

      void look_between(const double begin, const double end)
      {
        const double first = function.value_after(begin),
                     last  = function.value_before(end);
        const auto look    = [&](const double t, const double value) {
          const double line =
            first + (last - first) * ((t - begin) / (end - begin));
          largest = std::max(largest, std::abs(value));
          if (!worst || std::abs(value - line) > worst->size)
            worst = {begin, end, t, std::abs(value - line)};
        };
        look(begin, first);
        look(end, last);
        for (unsigned long i = 1; i <= n_samples; ++i)
          {
            const double t = begin + (end - begin) * i / (n_samples + 1);
            look(t, function.value(t));
          }
        for (; event != events.end() && event->time < end; ++event)
          if (event->time > begin)
            {
              look(event->time, function.value_before(event->time));
              look(event->time, function.value_after(event->time));
            }
      }

      /** If it is worth a word. */
      std::optional<Departure> departure() const
      {
        return worst && worst->size > allowed_departure * largest
          ? worst
          : std::nullopt;
      }

    private:
      const TimeFunction                    &function;
      const std::vector<TimeEvent>           events;
      std::vector<TimeEvent>::const_iterator event;
      const unsigned long                    n_samples;
      std::optional<Departure>               worst;
      double                                 largest = 0;
    };

    std::string describe(const TimeFunction &function,
                         const Departure    &departure)
    {
      std::ostringstream note;
      note
        << function.origin()
        << " changes within a step: between t = " << departure.begin
        << " s and " << departure.end << " s, most at t = " << departure.time
        << " s, it departs by " << departure.size
        << " from the straight line between its values at both ends, and the "
           "step sees nothing of it. Reduce Time/Time step, or make it a "
           "pulse of straight lines with at most eight corners, at which "
           "steps end.";
      return note.str();
    }

    /** Of tables that end before the run. */
    std::optional<std::string> note_on_end(const TimeFunction &function,
                                           const double        end_time)
    {
      const std::optional<double> last = function.last_time();
      if (!last || *last >= end_time)
        return {};
      std::ostringstream note;
      note << function.origin() << " ends at t = " << *last
           << " s, before the run at " << end_time << " s: its last value, "
           << function.value(*last)
           << ", is held from then on. Add rows if that is not meant.";
      return note.str();
    }

    std::optional<std::string> note_on_overshoot(const TimeFunction &function)
    {
      const std::optional<Overshoot> overshoot = function.overshoot();
      if (!overshoot)
        return {};
      std::ostringstream note;
      note.precision(3);
      note << function.origin()
           << " overshoots: between its rows at t = " << overshoot->begin
           << " s and " << overshoot->end << " s the spline is up to "
           << overshoot->amount
           << " outside of their values. Write table: FILE for straight lines "
              "between the rows, or add rows.";
      return note.str();
    }

    /** Tables of motions that strike, with inertia, at more rows than those of
     * a pulse or two. */
    std::optional<std::string> note_on_strikes(const TimeFunction &motion,
                                               const double        end_time)
    {
      if (!motion.last_time())
        return {};
      const std::size_t n = motion.events(0, end_time).size();
      if (n <= max_pulse_kinks)
        return {};
      std::ostringstream note;
      note << motion.origin() << " has a corner at " << n
           << " rows, and the velocity of the support jumps at each of them. "
              "If it is a smooth motion that was sampled, write smooth table: "
              "FILE, which lays a spline through the rows.";
      return note.str();
    }

    std::optional<std::string> note_on_steps(const TimeFunction   &function,
                                             const TimeParameters &time,
                                             const std::vector<double> &stops)
    {
      try
        {
          Sampling sampling(function, time, stops.size());
          for (std::size_t i = 1; i < stops.size(); ++i)
            sampling.look_between(stops[i - 1], stops[i]);
          if (const std::optional<Departure> found = sampling.departure())
            return describe(function, *found);
        }
      catch (const ComputationError &)
        {
          // Not finite somewhere: the run says so if it gets there.
        }
      return {};
    }
  } // namespace

  std::vector<std::string> time_function_notes(const RunPlan &plan)
  {
    std::vector<std::string> notes;
    const auto               add = [&](const std::optional<std::string> &note) {
      if (note)
        notes.push_back(*note);
    };
    const bool                is_sampled = plan.time.n_steps() < most_samples;
    const std::vector<double> stops =
      is_sampled ? stops_of(plan, step_ends(plan)) : std::vector<double>();
    for (const TimeFunction &function : functions_of_time(plan))
      if (!function.is_zero())
        {
          add(note_on_end(function, plan.time.end_time));
          add(note_on_overshoot(function));
          if (is_sampled)
            add(note_on_steps(function, plan.time, stops));
        }
    if (plan.time.scheme->is_dynamic())
      for (const SupportDefinition &support : plan.scene.supports)
        for (const TimeFunction &motion : support.motion)
          add(note_on_strikes(motion, plan.time.end_time));
    return notes;
  }

  std::string load_values_text(const RunPlan &plan, const double time)
  {
    std::ostringstream words;
    words.precision(4);
    unsigned int n = 0;
    for (const TimeFunction &function : functions_of_time(plan))
      if (const double value = function.value(time); value != 0)
        {
          if (++n > n_listed)
            return words.str() + ", ...";
          words << (n > 1 ? ", " : "") << function.origin() << " = " << value;
        }
    return words.str();
  }
} // namespace auxfem
