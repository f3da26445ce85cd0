#ifndef auxfem_analysis_step_ends_h
#define auxfem_analysis_step_ends_h

#include <auxfem/loads/time_event.h>
#include <auxfem/scene/scene.h>

#include <vector>

namespace auxfem
{
  /**
   * The times within a run, rising, at which loads and motions of supports have
   * kinks or jump, so that a step has to end there: the time schemes take
   * forces and motions for smooth over a step.
   *
   * Kinks of a function that follow each other within a time step are left out:
   * such a function, a measured one, say, is sampled by the steps. Jumps never
   * are.
   */
  std::vector<TimeEvent> step_ends(const Scene &scene);
} // namespace auxfem

#endif
