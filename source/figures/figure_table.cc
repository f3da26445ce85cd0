#include <auxfem/figures/figure_table.h>

#include <functional>

namespace auxfem
{
  namespace
  {
    constexpr double standard_gravity = 9.80665; // m/s2, exact by definition

    using Value   = std::optional<double>;
    using Figures = std::vector<BodyFigure>;

    /** The @p member, or a function, of a part that a body may lack. */
    template <class Part, class Member>
    Value value_in(const std::optional<Part> &part, const Member &member)
    {
      return part ? Value(std::invoke(member, *part)) : Value();
    }

    double in_gravities(const Peak &peak)
    {
      return peak.value / standard_gravity;
    }

    std::optional<Peak> force_peak(const BodyFigures &body)
    {
      return body.force ? std::optional(body.force->peak) : std::nullopt;
    }

    std::optional<Peak> filtered_force_peak(const BodyFigures &body)
    {
      return body.force ? body.force->filtered_peak : std::nullopt;
    }

    std::optional<PulseFigures> pulse(const BodyFigures &body)
    {
      return body.force ? body.force->pulse : std::nullopt;
    }

    Figures force_figure_columns()
    {
      return {
        {{"peak_force", "N", "force farthest from zero"},
         [](const BodyFigures &b) {
           return value_in(force_peak(b), &Peak::value);
         },
         "peak N"},
        {{"peak_force_time", "s", "its time, or position on a path"},
         [](const BodyFigures &b) {
           return value_in(force_peak(b), &Peak::time);
         },
         "at"},
        {{"filtered_peak_force", "N", "after the filter of SAE J211"},
         [](const BodyFigures &b) {
           return value_in(filtered_force_peak(b), &Peak::value);
         },
         "filtered N"},
        {{"filtered_peak_force_time", "s", "its time"},
         [](const BodyFigures &b) {
           return value_in(filtered_force_peak(b), &Peak::time);
         }},
        {{"impulse", "N s", "integral of the force over time"},
         [](const BodyFigures &b) {
           return value_in(pulse(b), &PulseFigures::impulse);
         },
         "impulse N s"},
        {{"pulse_duration",
          "s",
          "time from the first to the last crossing of the pulse threshold"},
         [](const BodyFigures &b) {
           return value_in(pulse(b), &PulseFigures::duration);
         }},
        {{"mean_force", "N", "mean over the duration of the pulse"},
         [](const BodyFigures &b) {
           return value_in(pulse(b), &PulseFigures::mean);
         },
         "mean N"}};
    }

    Figures acceleration_figure_columns()
    {
      return {
        {{"peak_acceleration_g", "1", "acceleration farthest from zero in g"},
         [](const BodyFigures &b) {
           return value_in(b.acceleration, in_gravities);
         },
         "peak g"},
        {{"peak_acceleration_time", "s", "its time"},
         [](const BodyFigures &b) {
           return value_in(b.acceleration, &Peak::time);
         }},
        {{"filtered_peak_acceleration_g", "1", "after the filter of SAE J211"},
         [](const BodyFigures &b) {
           return value_in(b.filtered_acceleration, in_gravities);
         },
         "filtered g"}};
    }

    Figures motion_figure_columns()
    {
      return {
        {{"stroke",
          "m",
          "displacement from the start, farthest along the initial velocity if "
          "there is one"},
         [](const BodyFigures &b) { return value_in(b.stroke, &Peak::value); },
         "stroke m"},
        {{"stroke_time", "s", "its time, or position on a path"},
         [](const BodyFigures &b) { return value_in(b.stroke, &Peak::time); }},
        {{"initial_velocity", "m/s", "velocity at the start"},
         [](const BodyFigures &b) {
           return value_in(b.rebound, &ReboundFigures::initial_velocity);
         }},
        {{"rebound_velocity",
          "m/s",
          "largest velocity against the initial one"},
         [](const BodyFigures &b) {
           return b.rebound ? b.rebound->rebound_velocity : Value();
         },
         "rebound m/s"},
        {{"restitution", "1", "rebound over initial velocity, without signs"},
         [](const BodyFigures &b) {
           return b.rebound ? b.rebound->restitution() : Value();
         },
         "restitution"},
        {{"settling_time",
          "s",
          "last time outside the settling band about the last displacement"},
         [](const BodyFigures &b) { return b.settling_time; },
         "settled s"}};
    }
  } // namespace

  const std::vector<BodyFigure> &body_figure_columns()
  {
    static const Figures all = []() {
      Figures list = force_figure_columns();
      for (const Figures &more :
           {acceleration_figure_columns(), motion_figure_columns()})
        list.insert(list.end(), more.begin(), more.end());
      return list;
    }();
    return all;
  }
} // namespace auxfem
