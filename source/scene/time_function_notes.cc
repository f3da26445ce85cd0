#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/short_lines.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/scene/time_function_notes.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace auxfem
{
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
      if (n <= most_kinks_of_pulses)
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
