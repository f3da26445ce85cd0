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

  /** Of a hinge: @p base, @p end are local rotations of which the second turns against the
   * first; base of -1: against the ground. */
  struct RevoluteHinge
  {
    std::array<int, 3> base, end;
    std::array<int, 2> multipliers;
    SpaceVector        axis; ///< unit vector
  };

  /** Revolute hinges in space.
   * @param length by which their constraints become lengths (m). */
  std::unique_ptr<Constraints>
  make_revolute_hinges(const DofNumbering               &numbering,
                       bool                              large_rotation,
                       double                            length,
                       const std::vector<RevoluteHinge> &hinges);
} // namespace auxfem

#endif
