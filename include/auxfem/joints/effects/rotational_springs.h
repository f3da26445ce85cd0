#ifndef auxfem_joints_effects_rotational_springs_h
#define auxfem_joints_effects_rotational_springs_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>

#include <array>
#include <memory>
#include <vector>

namespace auxfem
{

  /** Between two local rotations, the first -1: between the ground and the
   * second. */
  struct RotationalSpring
  {
    std::array<int, 2> unknowns;
    double             stiffness; ///< N m/rad
  };

  /** Linear springs between two rotations of one joint: M = K' (phi_2 - phi_1).
   */
  std::unique_ptr<Effect>
  make_rotational_springs(const DofNumbering           &numbering,
                          std::vector<RotationalSpring> springs);

  /** Between two of DofNumbering::spatial_rotations(), the first -1: between
   * the ground and the second. */
  struct SpaceSpring
  {
    int          first, second;
    double       stiffness; ///< N m/rad
    unsigned int number;    ///< among those of all ranks
  };

  /** Springs between two large rotations in space. */
  std::unique_ptr<Effect>
  make_space_springs(const DofNumbering             &numbering,
                     const std::vector<SpaceSpring> &springs);
} // namespace auxfem

#endif
