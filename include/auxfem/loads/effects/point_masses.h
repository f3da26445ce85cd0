#ifndef auxfem_loads_effects_point_masses_h
#define auxfem_loads_effects_point_masses_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>
#include <auxfem/model/rigid_bodies.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /** A mass (kg, or kg m2 on a rotation) on a local unknown. */
  struct PointMass
  {
    int    unknown;
    double mass;
  };

  /** Masses and rotary inertias on joints. */
  std::unique_ptr<Effect> make_point_masses(const DofNumbering    &numbering,
                                            std::vector<PointMass> masses);

  /** Inertia (kg m2, global frame at rest) on one of
   * DofNumbering::spatial_rotations(). */
  struct RotaryMass
  {
    int         rotation;
    SpaceTensor inertia;
  };

  /**
   * Rotary inertia at nodes in space: Euler's equations with their gyroscopic
   * terms, which are left out if rotations are small.
   */
  std::unique_ptr<Effect> make_rotary_masses(const DofNumbering &numbering,
                                             bool                large_rotation,
                                             std::vector<RotaryMass> masses);

  /** Inertia of rigid parts in natural coordinates. Those of @p bodies with a
   * rotation of their own are left out. */
  std::unique_ptr<Effect> make_rigid_part_inertia(const RigidBodies &bodies);
} // namespace auxfem

#endif
