#ifndef auxfem_model_initial_velocities_h
#define auxfem_model_initial_velocities_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /**
   * Velocities at t = 0 by local unknown (m/s, rad/s). A set moves as a rigid
   * body: its velocity plus the angular velocity about the mean of its joints;
   * of several sets with a joint the last counts. Struts whose ends both have
   * an initial velocity, by one set or two, move with them (StrutVelocities);
   * others are at rest but for the end. Rigid parts with a rotation of their
   * own turn with a set if all their joints belong to it.
   *
   * Throws InputError for a velocity that a support does not allow, and for an
   * angular velocity that turns nothing.
   */
  std::vector<std::pair<int, double>>
  initial_velocities(const RunPlan      &plan,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);
} // namespace auxfem

#endif
