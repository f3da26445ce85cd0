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
      for (const PressureDefinition &load : plan.scene.pressures)
        functions.push_back(load.pressure);
      for (const InitialStrainDefinition &strain : plan.scene.initial_strains)
        functions.push_back(strain.history);
      add(plan.scene.gravity.varying_components());
      add(plan.scene.base_motion.acceleration);
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

    /** Events of a run including its end: the last step needs the limit before
     * a jump there, a resumed run the limit after it. */
    std::vector<TimeEvent> events_of(const TimeFunction   &function,
                                     const TimeParameters &time,
                                     const unsigned int    derivatives = 1)
    {
      return function.events(0,
                             time.end_time + 2 * time_resolution(time.end_time),
                             derivatives);
    }

    /** Drops kinks of long series, in which each is nearer than @p step (s) to
     * the one before. */
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
     * Adds kinks and jumps of functions, without dense kinks, which steps
     * sample.
     * @param jump part of the motion that jumps with a function
     */
    void add_kinks_and_jumps(const std::vector<TimeFunction> &functions,
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

    /** Adds t = 0 if a function does not begin with zero. */
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

    /** Jumps that stand for those of loads and of support motions in statics.
     */
    constexpr Jump with_loads   = Jump::accelerations,
                   with_motions = Jump::velocities;

    /** Adds `Time/Events`, at which any function that is not constant may
     * jump. */
    void add_user_events(const std::vector<double>       &times,
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

    /** Adds jumps of motions and of their first two derivatives, in dynamics.
     */
    void add_motion_jumps(const std::vector<TimeFunction> &functions,
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

  double step_end_tolerance(const TimeParameters &time)
  {
    return 1e-6 * time.step;
  }

  std::vector<StepEnd> step_ends(const RunPlan &plan)
  {
    const TimeParameters           &time    = plan.time;
    const std::vector<TimeFunction> loads   = loads_of(plan),
                                    motions = motions_of(plan);
    std::vector<StepEnd> all;
    add_user_events(time.events, motions, all);
    add_kinks_and_jumps(loads, time, with_loads, all);
    if (time.scheme->is_dynamic())
      add_motion_jumps(motions, time, all);
    else
      {
        add_kinks_and_jumps(motions, time, with_motions, all);
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
    : tolerance(step_end_tolerance(plan.time))
    , ends(step_ends(plan))
  {}

  double StepEnds::next(const double time, const double end_of_scene_step) const
  {
    const auto next = at(time).second;
    return next != ends.end() && next->time < end_of_scene_step - tolerance
      ? next->time
      : end_of_scene_step;
  }

  std::pair<StepEnds::Iterator, StepEnds::Iterator>
  StepEnds::at(const double time) const
  {
    return {std::lower_bound(ends.begin(),
                             ends.end(),
                             time - tolerance,
                             [](const StepEnd &end, const double time) {
                               return end.time < time;
                             }),
            std::upper_bound(ends.begin(),
                             ends.end(),
                             time + tolerance,
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
     * Deviation from linear change within a step, relative to the largest value
     * of the load, above which the user gets a note.
     * @tuned judgement
     */
    constexpr double allowed_deviation = 0.25;

    constexpr unsigned long max_samples = 1 << 18, max_samples_per_step = 64;

    /** Deviation of a function from linear change within a step. */
    struct Deviation
    {
      double begin, end; ///< of the step (s)
      double time;       ///< time of the deviation (s)
      double size;
    };

    /** Time 0 and the ends of steps if no step fails. */
    std::vector<double> step_times(const RunPlan              &plan,
                                   const std::vector<StepEnd> &ends)
    {
      const TimeParameters &time      = plan.time;
      const double          tolerance = step_end_tolerance(time);
      std::vector<double>   times{0.};
      auto                  event = ends.begin();
      for (unsigned long step = 1; step <= time.n_steps(); ++step)
        {
          const double end = time.time_at(step);
          for (; event != ends.end() && event->time < end - tolerance; ++event)
            if (event->time > times.back() + tolerance)
              times.push_back(event->time);
          times.push_back(end);
        }
      return times;
    }

    /** Samples a function in successive steps to find its largest deviation. */
    class StepSampler
    {
    public:
      StepSampler(const TimeFunction   &function,
                  const TimeParameters &time,
                  const unsigned long   n_times)
        : function(function)
        , events(function.events(0, time.end_time))
        , event(events.begin())
        , n_samples(
            std::clamp(max_samples / n_times, 1UL, max_samples_per_step))
      {}

      void sample(const double begin, const double end)
      {
        const double first = function.value_after(begin),
                     last  = function.value_before(end);
        const auto add     = [&](const double t, const double value) {
          const double line =
            first + (last - first) * ((t - begin) / (end - begin));
          largest_value = std::max(largest_value, std::abs(value));
          if (!largest_deviation ||
              std::abs(value - line) > largest_deviation->size)
            largest_deviation = {begin, end, t, std::abs(value - line)};
        };
        add(begin, first);
        add(end, last);
        for (unsigned long i = 1; i <= n_samples; ++i)
          {
            const double t = begin + (end - begin) * i / (n_samples + 1);
            add(t, function.value(t));
          }
        for (; event != events.end() && event->time < end; ++event)
          if (event->time > begin)
            {
              add(event->time, function.value_before(event->time));
              add(event->time, function.value_after(event->time));
            }
      }

      /** The largest deviation, if it exceeds the allowed one. */
      std::optional<Deviation> deviation() const
      {
        return largest_deviation &&
            largest_deviation->size > allowed_deviation * largest_value
          ? largest_deviation
          : std::nullopt;
      }

    private:
      const TimeFunction                    &function;
      const std::vector<TimeEvent>           events;
      std::vector<TimeEvent>::const_iterator event;
      const unsigned long                    n_samples;
      std::optional<Deviation>               largest_deviation;
      double                                 largest_value = 0;
    };

    std::string describe(const TimeFunction &function,
                         const Deviation    &deviation)
    {
      std::ostringstream note;
      note
        << function.origin()
        << " changes within a step: between t = " << deviation.begin
        << " s and " << deviation.end << " s, most at t = " << deviation.time
        << " s, it deviates by " << function.as_written(deviation.size)
        << " from the straight line between its values at both ends, which the "
           "step does not resolve. Reduce Time/Time step, or write a pulse of "
           "straight lines with at most eight corners, at which steps end.";
      return note.str();
    }

    /** Note on a table that ends before the run. */
    std::optional<std::string> note_on_end(const TimeFunction &function,
                                           const double        end_time)
    {
      const std::optional<double> last = function.last_time();
      if (!last || *last >= end_time)
        return {};
      std::ostringstream note;
      note << function.origin() << " ends at t = " << *last
           << " s, but the run ends at t = " << end_time
           << " s: its last value, " << function.value(*last)
           << ", is held from then on. Add rows if this is not intended.";
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
           << function.as_written(overshoot->amount)
           << " outside of their values. Write table: FILE for straight lines "
              "between the rows, or add rows.";
      return note.str();
    }

    /** Note on a table of motions whose velocity jumps at more rows than those
     * of pulses. */
    std::optional<std::string>
    note_on_velocity_jumps(const TimeFunction &motion, const double end_time)
    {
      if (!motion.last_time())
        return {};
      const std::size_t n = motion.events(0, end_time).size();
      if (n <= max_pulse_kinks)
        return {};
      std::ostringstream note;
      note
        << motion.origin() << " has a corner at " << n
        << " rows, and the velocity of the support jumps at each of them. "
           "If it is a sampled smooth motion, write smooth table: FILE, which "
           "interpolates the rows by a spline.";
      return note.str();
    }

    std::optional<std::string> note_on_steps(const TimeFunction   &function,
                                             const TimeParameters &time,
                                             const std::vector<double> &times)
    {
      try
        {
          StepSampler sampler(function, time, times.size());
          for (std::size_t i = 1; i < times.size(); ++i)
            sampler.sample(times[i - 1], times[i]);
          if (const std::optional<Deviation> deviation = sampler.deviation())
            return describe(function, *deviation);
        }
      catch (const ComputationError &)
        {
          // A value is not finite; the run reports it when it gets there.
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
    const bool                is_sampled = plan.time.n_steps() < max_samples;
    const std::vector<double> times =
      is_sampled ? step_times(plan, step_ends(plan)) : std::vector<double>();
    for (const TimeFunction &function : functions_of_time(plan))
      if (!function.is_zero())
        {
          add(note_on_end(function, plan.time.end_time));
          add(note_on_overshoot(function));
          if (is_sampled)
            add(note_on_steps(function, plan.time, times));
        }
    if (plan.time.scheme->is_dynamic())
      for (const SupportDefinition &support : plan.scene.supports)
        for (const TimeFunction &motion : support.motion)
          add(note_on_velocity_jumps(motion, plan.time.end_time));
    return notes;
  }

  std::string load_values_text(const RunPlan &plan, const double time)
  {
    std::ostringstream text;
    text.precision(4);
    unsigned int n = 0;
    for (const TimeFunction &function : functions_of_time(plan))
      if (const double value = function.value(time); value != 0)
        {
          if (++n > max_listed_items)
            return text.str() + ", ...";
          text << (n > 1 ? ", " : "") << function.origin() << " = "
               << function.as_written(value);
        }
    return text.str();
  }
} // namespace auxfem
