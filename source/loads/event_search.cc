#include <auxfem/loads/event_search.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>

namespace auxfem
{
  namespace
  {
    /**
     * Spans of time to look at before what is left is only sampled: enough for
     * ten thousand kinks, some tenths of a second.
     */
    constexpr std::size_t max_spans = 1 << 17;

    /** Jumps of one function in a run, each of which ends a step. */
    constexpr double max_jumps = 1e4;

    /**
     * Part of the size of values or slopes below which a difference is
     * round-off; the root of a number that is zero up to round-off is 1e-8.
     */
    constexpr double relative_tolerance = 1e-7;

    struct Span
    {
      double begin, end;
    };

    /** A time at which an operation switches. */
    struct Candidate
    {
      double time;
      bool   touched; ///< its margin touches zero without a change of sign
    };

    void refuse_more_than_most(const double n)
    {
      if (n > max_jumps)
        throw TooManyJumps{n};
    }

    bool is_zero(const Interval &number)
    {
      return number.lower() == 0 && number.upper() == 0;
    }

    /**
     * Where @p f, of opposite signs at both ends, passes zero: of the
     * neighbouring numbers around it the one with the smaller value.
     */
    double bisect(const std::function<double(double)> &f, Span span)
    {
      double f_begin = f(span.begin);
      for (;;)
        {
          const double middle = span.begin + (span.end - span.begin) / 2;
          if (middle <= span.begin || middle >= span.end)
            break;
          const double f_middle = f(middle);
          if (f_middle == 0)
            return middle;
          if ((f_middle < 0) == (f_begin < 0))
            {
              span.begin = middle;
              f_begin    = f_middle;
            }
          else
            span.end = middle;
        }
      return std::abs(f_begin) < std::abs(f(span.end)) ? span.begin : span.end;
    }

    /** Finds the times at which operations of an expression switch. */
    class SwitchSearch
    {
    public:
      SwitchSearch(const ExpressionTree &expression,
                   const double          begin,
                   const double          end)
        : expression(expression)
        , touch_width(1e-6 * (end - begin))
        , least_width(
            std::max(1e-9 * (end - begin), time_resolution(end - begin)))
      {
        push({begin + time_resolution(begin), end - time_resolution(end)});
        for (std::size_t n = 0; !spans.empty(); ++n)
          {
            const Span span = spans.front();
            spans.pop_front();
            examine(span, n < max_spans);
          }
        unite();
      }

      /** Sorted, one of those that are closer than the resolution. */
      std::vector<Candidate> candidates;

    private:
      using Switch = ExpressionTree::Switch;

      void push(const Span &span)
      {
        if (span.begin < span.end)
          spans.push_back(span);
      }

      void examine(const Span &span, const bool may_split)
      {
        const auto jets = expression.evaluate(Interval(span.begin, span.end));
        std::vector<Candidate> found;
        std::vector<Switch>    unresolved;
        for (const Switch &operation : expression.switches())
          if (!find(operation,
                    expression.margin(operation.node, jets),
                    span,
                    found))
            unresolved.push_back(operation);

        if (!unresolved.empty() && may_split &&
            span.end - span.begin > least_width)
          {
            split(span, found);
            return;
          }
        for (const Switch &operation : unresolved)
          sample(operation, span, found);
        candidates.insert(candidates.end(), found.begin(), found.end());
      }

      /**
       * At a root, so that operations on what switches there are resolved in
       * both parts, or in the middle if all roots are close to the ends.
       */
      void split(const Span &span, std::vector<Candidate> &found)
      {
        const double middle = span.begin + (span.end - span.begin) / 2;
        const double reach  = (span.end - span.begin) * (0.5 - 1. / 64);
        const auto   root =
          std::min_element(found.begin(),
                           found.end(),
                           [middle](const Candidate &a, const Candidate &b) {
                             return std::abs(a.time - middle) <
                               std::abs(b.time - middle);
                           });
        if (root == found.end() || std::abs(root->time - middle) > reach)
          {
            push({span.begin, middle});
            push({middle, span.end});
            return;
          }
        const double distance = time_resolution(root->time);
        candidates.push_back(*root);
        push({span.begin, root->time - distance});
        push({root->time + distance, span.end});
      }

      /** Adds roots in @p span; false if there may be any number of them. */
      bool find(const Switch           &operation,
                const Jet<Interval>    &margin,
                const Span             &span,
                std::vector<Candidate> &found) const
      {
        if (!operation.at_integers)
          return find_roots(operation, margin, 0, span, found);
        double first = std::ceil(margin.value.lower());
        double last  = std::floor(margin.value.upper());
        if (!excludes(margin.first, 0))
          {
            if (last > first)
              return false;
          }
        else
          {
            const auto [low, high] =
              std::minmax({margin_at(operation, span.begin).value,
                           margin_at(operation, span.end).value});
            first = std::max(first, std::ceil(low));
            last  = std::min(last, std::floor(high));
            refuse_more_than_most(candidates.size() + (last - first));
          }
        for (double level = first; level <= last; ++level)
          if (!find_roots(operation, margin, level, span, found))
            return false;
        return true;
      }

      /** The same of the roots of margin = @p level. */
      bool find_roots(const Switch           &operation,
                      const Jet<Interval>    &margin,
                      const double            level,
                      const Span             &span,
                      std::vector<Candidate> &found) const
      {
        if (!contains(margin.value, level) || is_zero(margin.first))
          return true;
        if (excludes(margin.first, 0))
          {
            find_crossing(operation, level, span, found);
            return true;
          }
        // Differences of equal slopes look as if they could have either sign.
        if (is_zero(margin.second))
          {
            if (margin_at(operation, span.begin).first != 0)
              find_crossing(operation, level, span, found);
            return true;
          }
        if (!excludes(margin.second, 0))
          return false;
        find_around_extremum(operation, level, span, found);
        return true;
      }

      void find_around_extremum(const Switch           &operation,
                                const double            level,
                                const Span             &span,
                                std::vector<Candidate> &found) const
      {
        const auto slope = [&](const double t) {
          return margin_at(operation, t).first;
        };
        const double begin = slope(span.begin), end = slope(span.end);
        if (begin * end > 0)
          {
            find_crossing(operation, level, span, found);
            return;
          }
        const double      extremum = begin == 0 ? span.begin
               : end == 0                       ? span.end
                                                : bisect(slope, span);
        const Jet<double> margin   = margin_at(operation, extremum);
        if (operation.when_touched &&
            2 * std::abs(margin.value) <=
              std::abs(margin.second) * touch_width * touch_width)
          {
            found.push_back({extremum, true});
            return;
          }
        find_crossing(operation, level, {span.begin, extremum}, found);
        find_crossing(operation, level, {extremum, span.end}, found);
      }

      /** Adds the root if the margin passes @p level once, or not at all. */
      void find_crossing(const Switch           &operation,
                         const double            level,
                         const Span             &span,
                         std::vector<Candidate> &found) const
      {
        const auto difference = [&](const double t) {
          return margin_at(operation, t).value - level;
        };
        const double begin = difference(span.begin), end = difference(span.end);
        if (begin == 0 && !operation.when_touched)
          found.push_back({span.begin, false});
        if (end == 0 && !operation.when_touched)
          found.push_back({span.end, false});
        if (begin * end < 0)
          found.push_back({bisect(difference, span), false});
      }

      /**
       * Adds what the margins at both ends tell; for spans so short that two
       * crossings in them do not matter.
       */
      void sample(const Switch           &operation,
                  const Span             &span,
                  std::vector<Candidate> &found) const
      {
        const std::size_t n     = found.size();
        const double      begin = margin_at(operation, span.begin).value;
        const double      end   = margin_at(operation, span.end).value;
        double            first = 0, last = 0;
        if (operation.at_integers)
          {
            first = std::ceil(std::min(begin, end));
            last  = std::floor(std::max(begin, end));
            refuse_more_than_most(candidates.size() + (last - first));
          }
        for (double level = first; level <= last; ++level)
          find_crossing(operation, level, span, found);
        if (operation.when_touched && found.size() == n)
          found.push_back({span.begin, true});
      }

      Jet<double> margin_at(const Switch &operation, const double t) const
      {
        return expression.margin(operation.node, expression.evaluate(t));
      }

      /** Keeps one of those that are at the same time up to round-off. */
      void unite()
      {
        const auto earlier = [](const Candidate &a, const Candidate &b) {
          return a.time < b.time;
        };
        std::sort(candidates.begin(), candidates.end(), earlier);
        std::vector<Candidate> kept;
        for (const Candidate &candidate : candidates)
          if (!candidate.touched &&
              (kept.empty() ||
               candidate.time - kept.back().time >=
                 time_resolution(candidate.time)))
            kept.push_back(candidate);

        // A number that touches zero is zero up to round-off for a while.
        for (auto begin = candidates.begin(); begin != candidates.end();)
          {
            auto end = begin + 1;
            while (end != candidates.end() &&
                   end->time - (end - 1)->time < touch_width)
              ++end;
            if (std::all_of(begin, end, [](const Candidate &candidate) {
                  return candidate.touched;
                }))
              kept.push_back(*(begin + (end - begin) / 2));
            begin = end;
          }
        std::sort(kept.begin(), kept.end(), earlier);
        candidates = std::move(kept);
      }

      const ExpressionTree &expression;
      const double          touch_width; ///< closeness to zero that is a touch
      const double          least_width; ///< of spans that are split
      std::deque<Span>      spans;
    };

    /** Tells which times of switching are bends, kinks or jumps. */
    class Classification
    {
    public:
      Classification(const ExpressionTree         &expression,
                     const std::vector<Candidate> &candidates,
                     const double                  begin,
                     const double                  end,
                     const unsigned int            derivatives)
        : expression(expression)
        , derivatives(derivatives)
        , times({begin})
      {
        for (const Candidate &candidate : candidates)
          times.push_back(candidate.time);
        times.push_back(end);
        for (std::size_t i = 0; i + 1 < times.size(); ++i)
          sizes.push_back(size_between(times[i], times[i + 1]));
        double greatest = 0;
        for (const FunctionSize &size : sizes)
          greatest = std::max(greatest, size.value);
        negligible_slope     = 1e-10 * greatest / (end - begin);
        negligible_curvature = negligible_slope / (end - begin);

        for (std::size_t i = 0; i < candidates.size(); ++i)
          if (const auto kind = classify(candidates[i], i + 1))
            events.push_back({candidates[i].time, *kind});
      }

      std::vector<TimeEvent> events;

    private:
      FunctionSize size_between(const double a, const double b) const
      {
        FunctionSize size;
        for (const double fraction : {0.25, 0.5, 0.75})
          {
            const Jet<double> jet =
              expression.result(expression.evaluate(a + fraction * (b - a)));
            if (std::isfinite(jet.value))
              size.value = std::max(size.value, std::abs(jet.value));
            if (std::isfinite(jet.first))
              size.slope = std::max(size.slope, std::abs(jet.first));
            if (std::isfinite(jet.second))
              size.curvature = std::max(size.curvature, std::abs(jet.second));
          }
        return size;
      }

      std::optional<TimeEvent::Kind> classify(const Candidate  &candidate,
                                              const std::size_t index) const
      {
        const FunctionSize &left = sizes[index - 1], &right = sizes[index];
        const FunctionSize  size = {std::max(left.value, right.value),
                                    std::max(left.slope, right.slope) +
                                      negligible_slope / relative_tolerance,
                                    std::max(left.curvature, right.curvature) +
                                      negligible_curvature / relative_tolerance};
        if (candidate.touched)
          return classify_touch(index, size);

        const double      t      = candidate.time;
        const Jet<double> before = limit(expression, t, TimeSide::before);
        const Jet<double> after  = limit(expression, t, TimeSide::after);
        if (std::isnan(before.value) || std::isnan(after.value))
          return {};
        const double slopes = std::abs(before.first) + std::abs(after.first);
        const double error =
          std::isfinite(slopes) ? time_resolution(t) * slopes : 0;
        if (is_jump(before.value, after.value, size, error))
          return TimeEvent::Kind::jump;
        if (is_kink(before.first, after.first, size))
          return TimeEvent::Kind::kink;

        // Infinite slopes times zero, as in sqrt(abs(t))^2.
        const auto &switches = expression.switches();
        if (std::any_of(switches.begin(),
                        switches.end(),
                        [](const ExpressionTree::Switch &operation) {
                          return operation.when_touched;
                        }))
          if (const auto kind = classify_touch(index, size))
            return kind;
        if (derivatives > 1 && is_bend(before.second, after.second, size))
          return TimeEvent::Kind::bend;
        return {};
      }

      /**
       * At a root of a number that touches zero slopes are undefined, and next
       * to it they are those of round-off; so they are taken a little further
       * away, where they also differ by curvature.
       */
      std::optional<TimeEvent::Kind>
      classify_touch(const std::size_t index, const FunctionSize &size) const
      {
        const double t = times[index];
        const double distance =
          1e-4 * std::min(t - times[index - 1], times[index + 1] - t);
        const auto slope = [this](const double t) {
          return expression.result(expression.evaluate(t)).first;
        };
        const double difference = slope(t + distance) - slope(t - distance);
        if (std::abs(difference) > 1e-2 * size.slope)
          return TimeEvent::Kind::kink;
        return {};
      }

      const ExpressionTree     &expression;
      const unsigned int        derivatives;
      std::vector<double>       times; ///< candidates and both ends
      std::vector<FunctionSize> sizes; ///< between the times
      double                    negligible_slope, negligible_curvature;
    };
  } // namespace

  std::vector<TimeEvent> find_events(const ExpressionTree &expression,
                                     const double          begin,
                                     const double          end,
                                     const unsigned int    derivatives)
  {
    const SwitchSearch           search(expression, begin, end);
    const std::vector<TimeEvent> events =
      Classification(expression, search.candidates, begin, end, derivatives)
        .events;
    refuse_more_than_most(
      std::count_if(events.begin(), events.end(), [](const TimeEvent &event) {
        return event.kind == TimeEvent::Kind::jump;
      }));
    return events;
  }

  Jet<double>
  limit(const ExpressionTree &expression, const double t, const TimeSide side)
  {
    const double sign   = side == TimeSide::before ? -1 : 1;
    const double reach  = time_resolution(t);
    const auto   beside = expression.evaluate(t + sign * reach);
    Jet<double>  result = expression.result(expression.evaluate(t, beside));

    // Round-off of t may lie outside of what the branch is defined for.
    for (double distance = reach / 4096; distance <= reach &&
         (std::isnan(result.value) || std::isnan(result.first));
         distance *= 2)
      result =
        expression.result(expression.evaluate(t + sign * distance, beside));
    return result;
  }

  bool is_jump(const double        before,
               const double        after,
               const FunctionSize &size,
               const double        error)
  {
    return !(std::abs(after - before) <=
             relative_tolerance * size.value + error);
  }

  bool
  is_kink(const double before, const double after, const FunctionSize &size)
  {
    return !(std::abs(after - before) <= relative_tolerance * size.slope);
  }

  bool
  is_bend(const double before, const double after, const FunctionSize &size)
  {
    return !(std::abs(after - before) <= relative_tolerance * size.curvature);
  }
} // namespace auxfem
