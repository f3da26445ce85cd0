#include <auxfem/loads/event_search.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace auxfem
{
  namespace
  {
    /** Number of samples of the branches; the larger one for functions whose
     * branches change often. */
    constexpr std::size_t min_samples = 1021, max_branch_samples = 1 << 17;

    /** Largest number of jumps of a function, each of which ends a step. */
    constexpr double max_jumps = 1e4;

    /** Number of branch changes after which the search ends. */
    constexpr std::size_t max_switches = 20000;

    /** Relative differences of values and derivatives that count as none. */
    constexpr double value_tolerance = 1e-7, derivative_tolerance = 1e-4;

    struct Sample
    {
      double        time;
      std::uint64_t branches;
    };

    /** Samples the branches between two times. Spacing is uneven, because equal
     * intervals might be multiples of a period. */
    std::vector<Sample> sample(const BranchedFunction &function,
                               const double            begin,
                               const double            end,
                               const std::size_t       n)
    {
      constexpr double    golden = 0.6180339887498949;
      std::vector<Sample> samples;
      samples.reserve(n + 1);
      for (std::size_t i = 0; i <= n; ++i)
        {
          const double shift =
            i == 0 || i == n ? 0 : 0.5 * (i * golden - std::floor(i * golden));
          const double t = begin + (end - begin) * ((i + shift) / n);
          samples.push_back({t, function(t).branches});
        }
      return samples;
    }

    std::size_t n_changes(const std::vector<Sample> &samples)
    {
      std::size_t n = 0;
      for (std::size_t i = 1; i < samples.size(); ++i)
        n += samples[i].branches != samples[i - 1].branches;
      return n;
    }

    /** Bisects between @p from and @p to, which have different branches, for the
     * first number without the branches of @p from. */
    Sample
    end_of_branches(const BranchedFunction &function, Sample from, Sample to)
    {
      for (;;)
        {
          const double middle = from.time + (to.time - from.time) / 2;
          if (middle <= from.time || middle >= to.time)
            return to;
          const Sample between = {middle, function(middle).branches};
          (between.branches == from.branches ? from : to) = between;
        }
    }

    /** Times at which branches change, at least time_resolution() apart. */
    std::vector<double> find_switches(const BranchedFunction &function,
                                      const double            begin,
                                      const double            end)
    {
      constexpr std::size_t samples_per_change = 16;
      std::vector<Sample>   samples = sample(function, begin, end, min_samples);
      while (n_changes(samples) > samples.size() / samples_per_change &&
             4 * samples.size() < max_branch_samples)
        samples = sample(function, begin, end, 4 * samples.size());

      std::vector<double> switches;
      for (std::size_t i = 1; i < samples.size(); ++i)
        for (Sample from = samples[i - 1];
             from.branches != samples[i].branches &&
             from.time < samples[i].time;)
          {
            if (switches.size() == max_switches)
              return switches;
            const Sample next = end_of_branches(function, from, samples[i]);
            switches.push_back(next.time);
            const double after = next.time + time_resolution(next.time);
            from               = {after, function(after).branches};
          }
      return switches;
    }

    /** Classifies switches as bends, kinks or jumps. */
    class Classification
    {
    public:
      Classification(const BranchedFunction    &function,
                     const std::vector<double> &switches,
                     const double               begin,
                     const double               end,
                     const unsigned int         derivatives)
        : function(function)
        , derivatives(derivatives)
      {
        if (switches.empty())
          return;
        std::vector<FunctionSize> sizes;
        for (std::size_t i = 0; i <= switches.size(); ++i)
          sizes.push_back(
            size_between(i == 0 ? begin : switches[i - 1],
                         i == switches.size() ? end : switches[i]));
        double greatest = 0;
        for (const FunctionSize &size : sizes)
          greatest = std::max(greatest, size.value);
        negligible_slope     = 1e-10 * greatest / (end - begin);
        negligible_curvature = negligible_slope / (end - begin);
        for (std::size_t i = 0; i < switches.size(); ++i)
          add(switches[i], larger(sizes[i], sizes[i + 1]));
        const double searched_part = switches.size() == max_switches
          ? (switches.back() - begin) / (end - begin)
          : 1;
        if (n_jumps > max_jumps * searched_part)
          throw TooManyJumps{n_jumps / searched_part};
      }

      std::vector<TimeEvent> events;

    private:
      static FunctionSize larger(const FunctionSize &a, const FunctionSize &b)
      {
        return {std::max(a.value, b.value),
                std::max(a.slope, b.slope),
                std::max(a.curvature, b.curvature)};
      }

      /** Magnitudes between @p a and @p b, from five values. */
      FunctionSize size_between(const double a, const double b) const
      {
        constexpr unsigned int n = 5;
        const double           h = (b - a) / (n + 1);
        double                 values[n];
        FunctionSize           size;
        const auto add_value = [](double &largest, const double value) {
          if (std::isfinite(value))
            largest = std::max(largest, std::abs(value));
        };
        for (unsigned int i = 0; i < n; ++i)
          {
            values[i] = function(a + (i + 1) * h).value;
            add_value(size.value, values[i]);
            if (i > 0)
              add_value(size.slope, (values[i] - values[i - 1]) / h);
            if (i > 1)
              add_value(size.curvature,
                        (values[i] - 2 * values[i - 1] + values[i - 2]) /
                          (h * h));
          }
        return size;
      }

      void add(const double t, const FunctionSize &size)
      {
        if (const auto kind = classify(t, size))
          {
            n_jumps += *kind == TimeEvent::Kind::jump;
            events.push_back({t, *kind});
          }
      }

      std::optional<TimeEvent::Kind> classify(const double        t,
                                              const FunctionSize &size) const
      {
        const double before = limit(function, t, TimeSide::before),
                     after  = limit(function, t, TimeSide::after);
        if (std::isnan(before) || std::isnan(after))
          return {};
        if (is_jump(before, after, size, time_resolution(t) * size.slope))
          return TimeEvent::Kind::jump;
        const JetEstimate left  = jet_estimate(function, t, TimeSide::before),
                          right = jet_estimate(function, t, TimeSide::after);
        if (is_kink(left.jet.first,
                    right.jet.first,
                    size,
                    left.first_error + right.first_error + negligible_slope))
          return TimeEvent::Kind::kink;
        if (derivatives > 1 &&
            is_bend(left.jet.second,
                    right.jet.second,
                    size,
                    left.second_error + right.second_error +
                      negligible_curvature))
          return TimeEvent::Kind::bend;
        return {};
      }

      const BranchedFunction &function;
      const unsigned int      derivatives;
      double negligible_slope = 0, negligible_curvature = 0, n_jumps = 0;
    };
  } // namespace

  std::vector<TimeEvent> find_events(const BranchedFunction &function,
                                     const double            begin,
                                     const double            end,
                                     const unsigned int      derivatives)
  {
    const double first = begin + time_resolution(begin),
                 last  = end - time_resolution(end);
    if (first >= last)
      return {};
    return Classification(function,
                          find_switches(function, first, last),
                          begin,
                          end,
                          derivatives)
      .events;
  }

  bool is_jump(const double        before,
               const double        after,
               const FunctionSize &size,
               const double        error)
  {
    return !(std::abs(after - before) <= value_tolerance * size.value + error);
  }

  bool is_kink(const double        before,
               const double        after,
               const FunctionSize &size,
               const double        error)
  {
    return !(std::abs(after - before) <=
             derivative_tolerance * size.slope + error);
  }

  bool is_bend(const double        before,
               const double        after,
               const FunctionSize &size,
               const double        error)
  {
    return !(std::abs(after - before) <=
             derivative_tolerance * size.curvature + error);
  }
} // namespace auxfem
