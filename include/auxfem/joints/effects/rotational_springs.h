#ifndef auxfem_joints_effects_rotational_springs_h
#define auxfem_joints_effects_rotational_springs_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/equations/effect.h>
#include <auxfem/joints/effects/relative_angles.h>
#include <auxfem/model/numbering.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace auxfem
{
  /** A linear rotational spring at a joint: M = K' (phi_2 - phi_1). */
  struct RotationalSpring
  {
    std::array<int, 2> unknowns;  ///< local rotations; first of -1: ground
    double             stiffness; ///< N m/rad
  };

  /** Makes the effect of linear rotational springs. */
  std::unique_ptr<Effect>
  make_rotational_springs(const DofNumbering           &numbering,
                          std::vector<RotationalSpring> springs);

  /**
   * Factor on mean moments between two plane rotations in a discrete-gradient
   * step with large rotations: moments do work on Cayley's measure of the
   * increments.
   * @param unknowns of both rotations; first of -1: ground
   */
  double mean_moment_factor(const std::array<int, 2> &unknowns,
                            const Evaluation         &step);

  /**
   * Makes the effect of springs in the plane whose moment M (N m) follows a law
   * of the relative rotation (rad).
   * @param name of the group
   * @param unknowns of both rotations; first of -1: ground
   * @param numbers among the springs of the group on all ranks
   */
  std::unique_ptr<Effect>
  make_rotational_laws(const DofNumbering                    &numbering,
                       const std::string                     &name,
                       std::shared_ptr<const ConnectorLaw>    law,
                       const std::vector<std::array<int, 2>> &unknowns,
                       const std::vector<unsigned int>       &numbers);

  /** As above in space, about the axes of revolute hinges. */
  std::unique_ptr<Effect>
  make_axis_laws(const DofNumbering                 &numbering,
                 bool                                large_rotation,
                 const std::string                  &name,
                 std::shared_ptr<const ConnectorLaw> law,
                 const std::vector<AxisPair>        &pairs);

  /** A spring between two large rotations in space, numbered as in
   * DofNumbering::rotations(). */
  struct SpaceSpring
  {
    int          first, second; ///< first of -1: ground
    double       stiffness;     ///< N m/rad
    unsigned int number;        ///< among the springs of all ranks
  };

  /** Makes the effect of springs between large rotations in space. */
  std::unique_ptr<Effect>
  make_space_springs(const DofNumbering             &numbering,
                     const std::vector<SpaceSpring> &springs);
} // namespace auxfem

#endif
