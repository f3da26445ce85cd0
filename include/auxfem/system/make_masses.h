#ifndef auxfem_system_make_masses_h
#define auxfem_system_make_masses_h

#include <auxfem/dofs/numbering.h>
#include <auxfem/parameters/scene.h>
#include <auxfem/system/effect.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * The scene's point masses and their rotary inertia as effects. Throws
   * InputError for rotary inertia on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>>
  make_masses(const Scene        &scene,
              const Lattice      &lattice,
              const DofNumbering &numbering,
              bool                large_rotation);
} // namespace auxfem

#endif
