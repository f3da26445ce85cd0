#ifndef auxfem_model_proportional_loads_h
#define auxfem_model_proportional_loads_h

#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * A load or prescribed motion as the analysis of @p scene takes it: as it is
   * given, or on a path of equilibria a function of the load factor: 0 at 0 or,
   * if the path starts from static equilibrium, what it is at t = 0; at 1 what
   * it is at PathDefinition::load_time.
   */
  TimeFunction proportional(const TimeFunction &history, const Scene &scene);
} // namespace auxfem

#endif
