#include <auxfem/figures/body_figures.h>
#include <auxfem/figures/cfc_filter.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  Peak peak_of(const RecordedHistory &history)
  {
    Peak peak{0, history.times.front()};
    for (std::size_t i = 0; i < history.times.size(); ++i)
      if (std::abs(history.values[i]) > std::abs(peak.value))
        peak = {history.values[i], history.times[i]};
    return peak;
  }

  namespace
  {
    /** Integral of the piecewise linear @p history. */
    double trapezoidal_integral(const RecordedHistory &history)
    {
      double sum = 0;
      for (std::size_t i = 1; i < history.times.size(); ++i)
        sum += (history.times[i] - history.times[i - 1]) *
          (history.values[i] + history.values[i - 1]) / 2;
      return sum;
    }

    /** Part from 0 to 1 of the way from @p before to @p after at which a value
     * is @p level. */
    double crossing(const double before, const double after, const double level)
    {
      return after == before
        ? 0
        : std::min(1., std::max(0., (level - before) / (after - before)));
    }

    /** @p history from where its absolute value first reaches @p level until
     * it last does; linear in between. */
    RecordedHistory pulse_of(const RecordedHistory &history, const double level)
    {
      const auto is_above = [&](const std::size_t i) {
        return std::abs(history.values[i]) >= level;
      };
      std::size_t first = 0, last = history.times.size() - 1;
      while (first < last && !is_above(first))
        ++first;
      while (last > first && !is_above(last))
        --last;
      RecordedHistory pulse;
      const auto      add = [&](const double time, const double value) {
        pulse.times.push_back(time);
        pulse.values.push_back(value);
      };
      // From the sample @p inside, which is above, towards its neighbour.
      const auto add_crossing = [&](const std::size_t inside,
                                    const std::size_t outside) {
        const double sign = history.values[inside] < 0 ? -1 : 1;
        const double part = crossing(sign * history.values[inside],
                                     sign * history.values[outside],
                                     level);
        add((1 - part) * history.times[inside] + part * history.times[outside],
            (1 - part) * history.values[inside] +
              part * history.values[outside]);
      };
      if (first > 0)
        add_crossing(first, first - 1);
      for (std::size_t i = first; i <= last; ++i)
        add(history.times[i], history.values[i]);
      if (last + 1 < history.times.size())
        add_crossing(last, last + 1);
      return pulse;
    }

    std::optional<Peak> filtered_peak(const RecordedHistory &history,
                                      const FigureOptions   &options)
    {
      if (!options.channel_class || !options.in_time)
        return std::nullopt;
      const auto smooth = filtered(history, *options.channel_class);
      return smooth ? std::optional(peak_of(*smooth)) : std::nullopt;
    }
  } // namespace

  ForceFigures force_figures(const RecordedHistory &force,
                             const FigureOptions   &options)
  {
    ForceFigures figures;
    figures.peak          = peak_of(force);
    figures.filtered_peak = filtered_peak(force, options);
    if (!options.in_time || figures.peak.value == 0)
      return figures;
    const RecordedHistory pulse =
      pulse_of(force, options.pulse_threshold * std::abs(figures.peak.value));
    PulseFigures integrals{trapezoidal_integral(force),
                           pulse.times.back() - pulse.times.front()};
    if (integrals.duration > 0)
      integrals.mean = trapezoidal_integral(pulse) / integrals.duration;
    figures.pulse = integrals;
    return figures;
  }

  std::optional<double> ReboundFigures::restitution() const
  {
    if (!rebound_velocity)
      return std::nullopt;
    return std::abs(*rebound_velocity / initial_velocity);
  }

  ReboundFigures rebound_figures(const RecordedHistory &velocity)
  {
    ReboundFigures figures;
    figures.initial_velocity = velocity.values.front();
    const double direction   = figures.initial_velocity < 0 ? -1 : 1;
    double       largest     = 0;
    for (const double value : velocity.values)
      largest = std::max(largest, -direction * value);
    if (largest > 0)
      figures.rebound_velocity = -direction * largest;
    return figures;
  }

  std::optional<double> settling_time(const RecordedHistory &motion,
                                      const double           band)
  {
    const std::vector<double> &times = motion.times;
    const double               final = motion.values.back();
    const double radius = band * std::abs(final - motion.values.front());
    std::size_t  inside = times.size() - 1;
    while (inside > 0 && std::abs(motion.values[inside - 1] - final) <= radius)
      --inside;
    if (radius == 0 || inside == 0)
      return std::nullopt;
    const double before = motion.values[inside - 1] - final,
                 after  = motion.values[inside] - final;
    const double part = crossing(before, after, before < 0 ? -radius : radius);
    const double settled =
      (1 - part) * times[inside - 1] + part * times[inside];
    constexpr double largest_part = 0.9;
    const double     length       = times.back() - times.front();
    if (settled - times.front() > largest_part * length)
      return std::nullopt;
    return settled - times.front();
  }

  namespace
  {
    const std::vector<std::string> axes = {"x", "y", "z"};

    /** Columns of a body by kind: f, r, u, v, a. */
    class BodyColumns
    {
    public:
      BodyColumns(const std::string &body, const RecordedTable &history)
        : body(body)
        , history(history)
      {}

      const std::vector<double> *find(const char         kind,
                                      const std::string &axis) const
      {
        return history.find(body + "." + kind + axis);
      }

      /** Column along @p axis over time; empty if it is zero up to round-off
       * of the largest value along any axis. */
      std::optional<RecordedHistory> along(const std::string &kinds,
                                           const std::string &axis) const
      {
        for (const char kind : kinds)
          if (const std::vector<double> *const values = find(kind, axis))
            {
              if (largest(*values) <= least_part * largest_along_axes(kind))
                return std::nullopt;
              return RecordedHistory{history.columns[0], *values};
            }
        return std::nullopt;
      }

    private:
      /** Part of the largest component below which another is round-off or the
       * tolerance of the iterations. */
      static constexpr double least_part = 1e-6;

      static double largest(const std::vector<double> &values)
      {
        double result = 0;
        for (const double value : values)
          result = std::max(result, std::abs(value));
        return result;
      }

      double largest_along_axes(const char kind) const
      {
        double result = 0;
        for (const std::string &axis : axes)
          if (const std::vector<double> *const values = find(kind, axis))
            result = std::max(result, largest(*values));
        return result;
      }

      const std::string    body;
      const RecordedTable &history;
    };

    /** Displacement since the start: farthest along the initial velocity, or
     * without one in any direction. */
    Peak stroke_of(RecordedHistory motion, const double initial_velocity)
    {
      const double start = motion.values.front();
      for (double &value : motion.values)
        {
          value -= start;
          if (value * initial_velocity < 0)
            value = 0;
        }
      return peak_of(motion);
    }

    void add_motion(const BodyColumns   &columns,
                    const FigureOptions &options,
                    BodyFigures         &figures)
    {
      const auto velocity = columns.along("v", figures.axis);
      if (velocity && velocity->values.front() != 0)
        figures.rebound = rebound_figures(*velocity);
      if (const auto motion = columns.along("u", figures.axis))
        {
          figures.stroke =
            stroke_of(*motion,
                      figures.rebound ? figures.rebound->initial_velocity : 0);
          if (options.in_time)
            figures.settling_time =
              settling_time(*motion, options.settling_band);
        }
      if (const auto acceleration = columns.along("a", figures.axis))
        {
          figures.acceleration          = peak_of(*acceleration);
          figures.filtered_acceleration = filtered_peak(*acceleration, options);
        }
    }
  } // namespace

  std::vector<BodyFigures> figures_of_body(const std::string   &body,
                                           const RecordedTable &history,
                                           const FigureOptions &options)
  {
    std::vector<BodyFigures> result;
    if (history.n_rows() < 2)
      return result;
    const BodyColumns columns(body, history);
    for (const std::string &axis : axes)
      {
        BodyFigures figures;
        figures.body = body;
        figures.axis = axis;
        if (const auto force = columns.along("fr", axis))
          figures.force = force_figures(*force, options);
        add_motion(columns, options, figures);
        if (figures.force || figures.stroke || figures.rebound ||
            figures.acceleration)
          result.push_back(figures);
      }
    return result;
  }
} // namespace auxfem
