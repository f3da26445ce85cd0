#ifndef auxfem_equations_load_values_h
#define auxfem_equations_load_values_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/loads/time_function.h>

namespace auxfem
{
  /**
   * Value with which a step begins: where there is an event that just after;
   * without inertia that just before, from which the step raises the load.
   */
  inline double value_at_start(const TimeFunction &load, const Evaluation &step)
  {
    if (!step.event_at_from)
      return load.value(time_of_loads(step.from));
    const double event = *step.event_at_from;
    const bool   is_raised =
      step.kind == Evaluation::Kind::static_step && step.from.time > 0;
    return is_raised ? load.value_before(event) : load.value_after(event);
  }

  /**
   * Value at evaluation.to, where there is an event on the side that the
   * evaluation asks for.
   */
  inline double value_at_end(const TimeFunction &load,
                             const Evaluation   &evaluation)
  {
    if (!evaluation.event_at_to)
      return load.value(time_of_loads(evaluation.to));
    const auto &[time, side] = *evaluation.event_at_to;
    return side == TimeSide::before ? load.value_before(time)
                                    : load.value_after(time);
  }
} // namespace auxfem

#endif
