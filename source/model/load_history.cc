#include <auxfem/model/load_history.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/scene/step_ends.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/beam_shape.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Largest number of samples of a load. */
    constexpr unsigned long max_samples = 4096;

    unsigned long n_samples(const RunPlan &plan)
    {
      return std::min(plan.time.n_steps(), max_samples);
    }

    /** All nonzero load histories of the scene. */
    std::vector<TimeFunction> load_histories(const RunPlan &plan)
    {
      std::vector<TimeFunction> loads = functions_of_time(plan);
      loads.erase(std::remove_if(loads.begin(),
                                 loads.end(),
                                 [](const TimeFunction &load) {
                                   return load.is_zero();
                                 }),
                  loads.end());
      return loads;
    }

    bool has_jump(const TimeFunction &load, const RunPlan &plan)
    {
      if (!plan.time.static_start && load.value(0) != 0)
        return true;
      const std::vector<TimeEvent> events = load.events(0, plan.time.end_time);
      return std::any_of(events.begin(),
                         events.end(),
                         [](const TimeEvent &event) {
                           return event.kind == TimeEvent::Kind::jump;
                         });
    }

    double relative_rate(const TimeFunction &load, const RunPlan &plan)
    {
      const unsigned long n        = n_samples(plan);
      const double        interval = plan.time.end_time / n;
      double previous = load.value(0), largest = std::abs(previous), rate = 0;
      for (unsigned long i = 1; i <= n; ++i)
        {
          const double value = load.value_before(i * interval);
          largest            = std::max(largest, std::abs(value));
          rate     = std::max(rate, std::abs(value - previous) / interval);
          previous = value;
        }
      return largest > 0 ? rate / largest : 0;
    }

    /** uncommanded_motion() of one load without jumps. */
    double uncommanded_part(const TimeFunction &load,
                            const RunPlan      &plan,
                            const double        frequency)
    {
      const double        end      = plan.time.end_time;
      const unsigned long n        = n_samples(plan);
      const auto          at_start = load.jet(0);
      double              largest  = std::abs(at_start[0]),
             uncommanded           = std::abs(at_start[1]);
      for (const TimeEvent &event : load.events(0, end))
        uncommanded =
          std::max(uncommanded,
                   std::abs(load.jet(event.time, TimeSide::after)[1] -
                            load.jet(event.time, TimeSide::before)[1]));
      for (unsigned long i = 1; i <= n; ++i)
        {
          const auto now = load.jet(end * i / n, TimeSide::before);
          largest        = std::max(largest, std::abs(now[0]));
          uncommanded    = std::max(uncommanded, std::abs(now[2]) / frequency);
        }
      return largest > 0 ? uncommanded / frequency / largest : 0;
    }
  } // namespace

  double uncommanded_motion(const RunPlan &plan, const double frequency)
  {
    if (load_history(plan).is_sudden)
      return 1;
    double largest = 0;
    try
      {
        for (const TimeFunction &load : load_histories(plan))
          largest = std::max(largest, uncommanded_part(load, plan, frequency));
      }
    catch (const ComputationError &)
      {
        // The load may be finite where its slope is infinite.
        return 1;
      }
    return std::min(1., largest);
  }

  double resolved_frequency(const RunPlan &plan)
  {
    // The period error of the trapezoidal rule is then 0.8 %.
    constexpr double steps_per_period = 20;
    return 2 * std::acos(-1.) / (steps_per_period * plan.time.step);
  }

  LoadHistory load_history(const RunPlan &plan)
  {
    const std::vector<TimeFunction> loads    = load_histories(plan);
    const double                    resolved = resolved_frequency(plan);
    const bool                      falls_freely =
      loads.empty() && !plan.scene.gravity.is_zero() && !plan.time.static_start;
    if (falls_freely || !plan.initial_velocities().empty())
      return {resolved, true};
    double rate = 0;
    try
      {
        for (const TimeFunction &load : loads)
          {
            if (has_jump(load, plan))
              return {resolved, true};
            rate = std::max(rate, relative_rate(load, plan));
          }
      }
    catch (const ComputationError &)
      {
        // An invalid load value stops the run later, at its time.
        return {resolved, true};
      }
    return {std::min(rate, resolved), false};
  }

  double LoadHistory::lost(const RunPlan &plan, const double per_radian) const
  {
    const double radians = is_sudden && plan.time.scheme->is_dynamic()
      ? std::max(1., rate * plan.time.end_time / 2)
      : 1.;
    return std::min(1., per_radian * radians);
  }

  namespace
  {
    /** Time of the loads at load factor 1; empty without load factor. */
    std::optional<double> time_of_reference(const RunPlan &plan)
    {
      if (plan.analysis == Analysis::static_path)
        return plan.scene.path.load_time.value_or(plan.time.end_time);
      if (plan.analysis == Analysis::frequency_response)
        return plan.scene.frequency_response.load_time.value_or(
          plan.time.end_time);
      return std::nullopt;
    }
  } // namespace

  bool has_load_factor(const RunPlan &plan)
  {
    return time_of_reference(plan).has_value();
  }

  TimeFunction proportional(const TimeFunction &history, const RunPlan &plan)
  {
    const std::optional<double> reference = time_of_reference(plan);
    if (!reference)
      return history;
    return TimeFunction::line(plan.time.static_start ? history.value(0) : 0.,
                              history.value_before(*reference),
                              history.origin());
  }

  LineRule::LineRule(const unsigned int order)
  {
    dispatch_order(order, [this](auto p) {
      const BeamShape<p> shape;
      integrals.assign(shape.integral, shape.integral + p + 1);
      nodes.assign(shape.node, shape.node + p + 1);
      const dealii::QGauss<1> gauss(p + 1);
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          Point point{2 * gauss.point(q)[0] - 1,
                      2 * gauss.weight(q),
                      std::vector<double>(p + 1)};
          shape.values_at(point.xi, point.shapes.data());
          points.push_back(point);
        }
    });
  }
} // namespace auxfem
