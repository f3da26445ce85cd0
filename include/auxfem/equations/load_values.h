#ifndef auxfem_equations_load_values_h
#define auxfem_equations_load_values_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/loads/time_function.h>

namespace auxfem
{
  /** Value with which a step begins: where the load jumps that just after. */
  inline double value_at_start(const TimeFunction &load, const Evaluation &step)
  {
    return step.jumps_at_from ? load.value_after(step.from.time)
                              : load.value(step.from.time);
  }

  /**
   * Value with which a step ends: where the load jumps that just before. At an
   * instant it is that just after, for what begins then.
   */
  inline double value_at_end(const TimeFunction &load,
                             const Evaluation   &evaluation)
  {
    const double time = evaluation.to.time;
    if (!evaluation.jumps_at_to)
      return load.value(time);
    return evaluation.kind == Evaluation::Kind::rates ? load.value_after(time)
                                                      : load.value_before(time);
  }
} // namespace auxfem

#endif
