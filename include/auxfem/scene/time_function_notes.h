#ifndef auxfem_scene_time_function_notes_h
#define auxfem_scene_time_function_notes_h

#include <auxfem/scene/run_plan.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * What the user should know of loads and motions of supports: tables that end
   * before the run, with the time from which on their last value is held,
   * splines that overshoot, tables of motions that strike at many rows, and
   * functions that the steps do not resolve, with the step in which most is
   * missed. Of the latter, such as change by more than a quarter of their
   * largest value between what the ends of a step show; looked for at up to 64
   * times a step, 2^18 in all, and at kinks and jumps, in runs of fewer than
   * 2^18 steps.
   */
  std::vector<std::string> time_function_notes(const RunPlan &plan);

  /**
   * The loads and motions of supports that are not zero at @p time (s), with
   * their values, in words, e.g. `Loads/press/Force x: '-40 * t' = -4.9`; three
   * at most.
   */
  std::string load_values_text(const RunPlan &plan, double time);
} // namespace auxfem

#endif
