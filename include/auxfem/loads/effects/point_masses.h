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

  /** Makes the effect of masses on joints. */
  std::unique_ptr<Effect> make_point_masses(const DofNumbering    &numbering,
                                            std::vector<PointMass> masses);

  /** Inertia tensor (kg m2, global frame at rest) on a spatial rotation of
   * DofNumbering::rotations(). */
  struct RotaryMass
  {
    int         rotation;
    SpaceTensor inertia;
  };

  /** Makes the effect of rotary inertia in space: Euler's equations, without
   * gyroscopic terms if rotations are small. */
  std::unique_ptr<Effect> make_rotary_masses(const DofNumbering &numbering,
                                             bool                large_rotation,
                                             std::vector<RotaryMass> masses);

  /** Makes the effect of inertia of rigid parts in natural coordinates; those
   * with a rotation of their own are not included. */
  std::unique_ptr<Effect> make_rigid_part_inertia(const RigidBodies &bodies);
} // namespace auxfem

#endif
