#ifndef auxfem_equations_make_loads_h
#define auxfem_equations_make_loads_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/numbering.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/scene/scene.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Joint loads, line loads and weight of struts, rigid parts and point masses
   * as effects: dead loads, and loads that follow their joints. Throws
   * InputError for a moment on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>>
  make_loads(const Scene                &scene,
             const Lattice              &lattice,
             const DofNumbering         &numbering,
             const std::vector<Section> &sections,
             const RigidBodies          &bodies,
             const SimulatedEffects     &simulated);
} // namespace auxfem

#endif
