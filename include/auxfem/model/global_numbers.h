#ifndef auxfem_model_global_numbers_h
#define auxfem_model_global_numbers_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_mesh.h>

#include <array>
#include <map>
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

  class UnknownDistribution;

  /**
   * Global numbers of the unknowns of a lattice, the same on every rank; each
   * rank owns a contiguous range. -1: there is no such unknown.
   */
  struct GlobalNumbers
  {
    /** By component of motion. */
    using MotionNumbers = std::array<int, n_motion_components>;

    struct RigidPartNumbers
    {
      std::vector<unsigned int> clamped_joints; ///< in the plane
      /** Displacement of its centre of mass and rotation, if they are unknowns
       * of its own. */
      MotionNumbers    motion;
      std::vector<int> multipliers;
    };

    struct HingeNumbers
    {
      unsigned int       joint;
      std::array<int, 2> multipliers;
    };

    /** @param components of motion that nodes have */
    GlobalNumbers(const Lattice                   &lattice,
                  const StrutPartition            &partition,
                  const std::vector<unsigned int> &components,
                  const Ties                      &ties,
                  unsigned int                     n_ranks);

    std::vector<MotionNumbers> joints;
    /** Rotations of the released ends of elastic struts, by strut and end. */
    std::map<std::pair<unsigned int, unsigned int>, MotionNumbers>
                                  released_ends;
    std::vector<RigidPartNumbers> rigid_parts;
    std::vector<HingeNumbers>     hinges;
    /**
     * Of each strut the first of its nodes, if those of all struts are numbered
     * one after the other, and the end of the last; joints count anew at each
     * strut.
     */
    std::vector<std::size_t> first_nodes;
    /** Of each elastic strut the first number of its inner nodes, element by
     * element, each with all its components. */
    std::vector<int> first_inner;
    /** Numbers owned by rank r: [first_owned[r], first_owned[r + 1]). */
    std::vector<int> first_owned;

    bool owns(const unsigned int rank, const int number) const
    {
      return number >= first_owned[rank] && number < first_owned[rank + 1];
    }

    /** Of the rotation of the end of an elastic strut, released or not, as
     * rotation(). */
    const MotionNumbers &end_rotation(const Lattice &lattice,
                                      unsigned int   strut,
                                      unsigned int   end) const;

    /**
     * Adds to @p result those of the nodes of an element of @p order, in the
     * order of FE_Q, each with all components that nodes have.
     */
    void add_element(const Lattice       &lattice,
                     const StrutInterval &element,
                     unsigned int         order,
                     std::vector<int>    &result) const;

    /** Of a rotation; components below first_rotation are -1. */
    MotionNumbers rotation(const RotationOwner &rotation_owner) const;

    /** Of all unknowns that the constraints of a rigid part couple. */
    std::vector<int> rigid_part_unknowns(const Lattice &lattice,
                                         unsigned int   rigid_part) const;

    /** Joint that multiplier @p number of a rigid part holds to the others. */
    unsigned int constrained_joint(const Lattice &lattice,
                                   unsigned int   rigid_part,
                                   unsigned int   number) const;

    /**
     * Of unknowns that act on each other through rotational springs and hinges,
     * each with the multipliers.
     */
    std::vector<std::vector<int>> coupled(const Ties &ties) const;

  private:
    void assign_numbers(const UnknownDistribution &distribution);

    std::vector<unsigned int> components; ///< of motion that nodes have
  };

  /**
   * The unknowns of rigid parts and hinges beside those of joints: own motions
   * and Lagrange multipliers. Local numbers; -1 if not on this rank.
   */
  class ConstraintUnknowns
  {
  public:
    /** @param rigid_parts those kept on this rank, with all their unknowns. */
    ConstraintUnknowns(const GlobalNumbers             &numbers,
                       const UnknownLayout             &layout,
                       const std::vector<unsigned int> &rigid_parts);

    /** Rigid parts kept on this rank, with all their unknowns. */
    const std::vector<unsigned int> &rigid_parts() const
    {
      return local_rigid_parts;
    }

    /**
     * An unknown of a rigid part's own, RigidPart::has_rotation: displacement
     * of its centre of mass, rotation.
     */
    int motion(const unsigned int rigid_part,
               const unsigned int component) const
    {
      return rigid_part_numbers[rigid_part].motion[component];
    }

    /** In the plane: joints whose rotation is tied to that of a rigid part. */
    const std::vector<unsigned int> &
    clamped_joints(const unsigned int rigid_part) const
    {
      return rigid_part_numbers[rigid_part].clamped_joints;
    }

    /**
     * A multiplier of a rigid part: of one with a rotation of its own 3 k + c
     * for component c of joint k. Of others 0 for the distance of the base
     * joints, then d for each joint k = 2, 3, ... of the part in d dimensions;
     * then, in the plane, one for each of its clamped joints.
     */
    int multiplier(const unsigned int rigid_part,
                   const unsigned int number) const
    {
      return rigid_part_numbers[rigid_part].multipliers[number];
    }

    /** Number of multipliers of a rigid part; the same on every rank. */
    unsigned int n_multipliers(const unsigned int rigid_part) const
    {
      return rigid_part_numbers[rigid_part].multipliers.size();
    }

    /** Multiplier @p number (0, 1) of a pair of Ties::hinged. */
    int hinge_multiplier(const unsigned int hinge,
                         const unsigned int number) const
    {
      return hinge_numbers[hinge][number];
    }

    /** The multipliers kept on this rank. */
    const std::vector<int> &multipliers() const
    {
      return local_multipliers;
    }

    /** Number of all multipliers, over all ranks. */
    unsigned int n_multipliers() const;

  private:
    struct RigidPartNumbers
    {
      std::array<int, n_motion_components> motion;
      std::vector<unsigned int>            clamped_joints;
      std::vector<int>                     multipliers;
    };

    std::vector<unsigned int>       local_rigid_parts;
    std::vector<RigidPartNumbers>   rigid_part_numbers;
    std::vector<std::array<int, 2>> hinge_numbers;
    std::vector<int>                local_multipliers;
  };
} // namespace auxfem

#endif
