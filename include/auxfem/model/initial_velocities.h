#ifndef auxfem_model_initial_velocities_h
#define auxfem_model_initial_velocities_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * Velocities at t = 0 by local unknown (m/s, rad/s). A set moves as a rigid
   * body: its velocity plus the angular velocity about the mean of its joints;
   * nodes inside a strut move along if both ends belong to the set, rigid parts
   * with a rotation of their own turn along if all their joints do.
   */
  std::vector<std::pair<int, double>>
  initial_velocities(const Scene        &scene,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);
} // namespace auxfem

#endif
