#ifndef auxfem_equations_make_masses_h
#define auxfem_equations_make_masses_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/scene/scene.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * The scene's point masses and their rotary inertia, and those of the rigid
   * parts that have a rotation of their own, as effects. Throws InputError for
   * rotary inertia on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>>
  make_masses(const Scene        &scene,
              const Lattice      &lattice,
              const DofNumbering &numbering,
              const RigidBodies  &bodies,
              bool                large_rotation);
} // namespace auxfem

#endif
