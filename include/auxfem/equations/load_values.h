#ifndef auxfem_equations_load_values_h
#define auxfem_equations_load_values_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/loads/time_function.h>

namespace auxfem
{
  /** Value with which a step begins: where there is an event that just after.
   */
  inline double value_at_start(const TimeFunction &load, const Evaluation &step)
  {
    return step.event_at_from ? load.value_after(*step.event_at_from)
                              : load.value(step.from.time);
  }

  /**
   * Value at evaluation.to, where there is an event on the side that the
   * evaluation asks for.
   */
  inline double value_at_end(const TimeFunction &load,
                             const Evaluation   &evaluation)
  {
    if (!evaluation.event_at_to)
      return load.value(evaluation.to.time);
    const auto &[time, side] = *evaluation.event_at_to;
    return side == TimeSide::before ? load.value_before(time)
                                    : load.value_after(time);
  }
} // namespace auxfem

#endif
