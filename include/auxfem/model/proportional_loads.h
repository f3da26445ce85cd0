#ifndef auxfem_model_proportional_loads_h
#define auxfem_model_proportional_loads_h

#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** Whether the analysis of @p plan takes loads as functions of a load factor
   * (State::path). */
  bool has_load_factor(const RunPlan &plan);

  /**
   * A load or prescribed motion as the analysis of @p plan takes it: as it is
   * given, or a function of the load factor: at 0 it is 0 or, with a start from
   * static equilibrium, what it is at t = 0; at 1 what it is at the time of the
   * loads that the analysis has been given.
   */
  TimeFunction proportional(const TimeFunction &history, const RunPlan &plan);
} // namespace auxfem

#endif
