#ifndef auxfem_model_ties_h
#define auxfem_model_ties_h

#include <auxfem/mesh/lattice.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Something with a rotation, or the ground, which has none. */
  struct RotationOwner
  {
    enum class What
    {
      ground,
      joint,     ///< with the struts that are rigidly connected there
      strut_end, ///< released from its joint
      rigid_part ///< in space, RigidPart::has_rotation
    };
    What what = What::ground;
    /** Of the joint, strut or rigid part. */
    unsigned int index = 0;
    unsigned int end   = 0; ///< of the strut

    bool operator==(const RotationOwner &other) const
    {
      return what == other.what && index == other.index && end == other.end;
    }
  };

  /** Two rotations at one joint that are coupled by a spring or a hinge. */
  struct RotationPair
  {
    unsigned int  joint;
    RotationOwner base, end;
  };

  /** A component of the motion of a joint. */
  struct JointMotion
  {
    unsigned int joint, component;
  };

  /** What is released, tied and prescribed beyond the rigid joints. */
  struct Ties
  {
    /**
     * For every strut: whether the rotation of its first, second end is free
     * of the joint.
     */
    std::vector<std::array<bool, 2>> released;

    /** Pairs of joints whose motions act on each other through a connector. */
    std::vector<JointPair> connected;

    /** Rotations coupled by springs. */
    std::vector<RotationPair> sprung;

    /** Rotations coupled by revolute hinges, with two constraints each. */
    std::vector<RotationPair> hinged;

    /** Motions that supports prescribe; joints need not have them all. */
    std::vector<JointMotion> prescribed;
  };

  /**
   * For each joint what gives it its rotation: the joint itself, if an elastic
   * strut that is not released ends there; in space a rigid part that clamps
   * these struts, or the only rigid part with a rotation, if no such strut ends
   * there; else nothing (ground).
   * @param released as Ties::released.
   */
  std::vector<RotationOwner>
  joint_rotations(const Lattice                          &lattice,
                  const std::vector<std::array<bool, 2>> &released);
} // namespace auxfem

#endif
