#ifndef auxfem_equations_make_couplings_h
#define auxfem_equations_make_couplings_h

#include <auxfem/equations/constraints.h>
#include <auxfem/model/joint_releases.h>

#include <memory>

namespace auxfem
{
  /**
   * The rotational springs of this rank. nullptr if the scene has none.
   * @param large_rotations whether there are large rotations in space.
   */
  std::unique_ptr<Effect>
  make_rotational_springs(const std::vector<JointRelease> &releases,
                          const DofNumbering              &numbering,
                          bool                             large_rotations);

  /**
   * The revolute hinges. nullptr if the scene has none.
   * @param length by which their constraints become lengths (m).
   */
  std::unique_ptr<Constraints>
  make_revolute_hinges(const std::vector<JointRelease> &releases,
                       const DofNumbering              &numbering,
                       bool                             large_rotation,
                       double                           length);
} // namespace auxfem

#endif
