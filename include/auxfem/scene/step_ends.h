#ifndef auxfem_scene_step_ends_h
#define auxfem_scene_step_ends_h

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
   * More than eight kinks of a function that follow each other within a time
   * step are left out: such a function, a measured one, say, is sampled by the
   * steps. Fewer, as those of a pulse, are not, and jumps never are.
   */
  std::vector<TimeEvent> step_ends(const Scene &scene);

  /** Part of a time step within which events are one. */
  constexpr double nearness_of_step_ends = 1e-6;

  /** All functions of time that act on the lattice. */
  std::vector<TimeFunction> functions_of_time(const Scene &scene);
} // namespace auxfem

#endif
