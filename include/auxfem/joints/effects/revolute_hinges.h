#ifndef auxfem_joints_effects_revolute_hinges_h
#define auxfem_joints_effects_revolute_hinges_h

#include <auxfem/equations/effect.h>
#include <auxfem/mathematics/rotation.h>
#include <auxfem/model/numbering.h>

#include <array>
#include <memory>
#include <vector>

namespace auxfem
{
  /** A revolute hinge in space, by local unknowns. */
  struct RevoluteHinge
  {
    /** Rotation unknowns of the base (-1: ground) and of the strut end that
     * turns against it. */
    std::array<int, 3> base, end;
    std::array<int, 2> multipliers;
    SpaceVector        axis; ///< unit vector
  };

  /** Makes the constraints of revolute hinges in space.
   * @param length scales them to lengths (m) */
  std::unique_ptr<Constraints>
  make_revolute_hinges(const DofNumbering               &numbering,
                       bool                              large_rotation,
                       double                            length,
                       const std::vector<RevoluteHinge> &hinges);
} // namespace auxfem

#endif
