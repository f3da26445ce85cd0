#ifndef auxfem_system_make_loads_h
#define auxfem_system_make_loads_h

#include <auxfem/dofs/numbering.h>
#include <auxfem/parameters/scene.h>
#include <auxfem/system/effect.h>
#include <auxfem/system/rigid_bodies.h>

namespace auxfem
{
  /** A mass (kg, kg m2) at one local unknown. */
  using UnknownMass = std::pair<int, double>;

  /** The scene's point masses by local unknown, ghosts included. */
  std::vector<UnknownMass> point_masses(const Scene        &scene,
                                        const Lattice      &lattice,
                                        const DofNumbering &numbering);

  /**
   * Joint loads, line loads and (if @p gravity) weight of struts, rigid
   * parts and point masses as one effect; nullptr if the scene has none. Throws
   * InputError for a moment on a joint without rotation.
   */
  std::unique_ptr<Effect> make_loads(const Scene                  &scene,
                                     const Lattice                &lattice,
                                     const DofNumbering           &numbering,
                                     const std::vector<Section>   &sections,
                                     const std::vector<RigidBody> &bodies,
                                     bool                          gravity);

  /**
   * Velocities at t = 0 by local unknown. A set moves as a rigid body: its
   * velocity plus the angular velocity about the mean of its joints; nodes
   * inside a strut move along if both ends belong to the set.
   */
  std::vector<std::pair<int, double>>
  initial_velocities(const Scene        &scene,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);
} // namespace auxfem

#endif
