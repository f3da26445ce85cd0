#ifndef auxfem_system_make_masses_h
#define auxfem_system_make_masses_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>
#include <auxfem/system/effect.h>
#include <auxfem/system/rigid_bodies.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * The scene's point masses and their rotary inertia, and those of the rigid
   * parts that have a rotation of their own, as effects. Throws InputError for
   * rotary inertia on a joint without rotation.
   * @param length as for RotaryMasses (m).
   */
  std::vector<std::unique_ptr<Effect>>
  make_masses(const Scene        &scene,
              const Lattice      &lattice,
              const DofNumbering &numbering,
              const RigidBodies  &bodies,
              bool                large_rotation,
              double              length);
} // namespace auxfem

#endif
