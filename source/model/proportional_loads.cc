#include <auxfem/model/proportional_loads.h>

namespace auxfem
{
  namespace
  {
    /** When loads are those of the load factor 1; nothing: there is none. */
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
} // namespace auxfem
