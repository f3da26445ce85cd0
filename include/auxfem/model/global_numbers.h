#ifndef auxfem_model_global_numbers_h
#define auxfem_model_global_numbers_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_mesh.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace auxfem
{
  /** Owner of a rotation; the ground has none. */
  struct RotationOwner
  {
    enum class Kind
    {
      ground,
      joint,     ///< with the struts that are rigidly connected there
      strut_end, ///< released from its joint
      rigid_part ///< in space, RigidPart::has_rotation
    };
    Kind kind = Kind::ground;
    /** Index of the joint, strut or rigid part. */
    unsigned int index = 0;
    unsigned int end   = 0; ///< end of the strut

    bool operator==(const RotationOwner &other) const
    {
      return kind == other.kind && index == other.index && end == other.end;
    }
  };

  /** Two rotations at a joint coupled by a spring or a hinge. */
  struct RotationPair
  {
    unsigned int  joint;
    RotationOwner base, end;
  };

  /** A motion component of a joint. */
  struct JointMotion
  {
    unsigned int joint, component;
  };

  /** A sum of multiples of joint motions that is zero (m). */
  struct LinearRelation
  {
    struct Term
    {
      JointMotion motion;
      double      coefficient; ///< m before rotations, else 1
    };
    std::string       path; ///< of its definition, for messages
    std::vector<Term> terms;
    /** Whether the first two terms are one component of two large rotations
     * that are equal; there are such relations for all components. */
    bool is_of_equal_rotations = false;
  };

  /** Releases, couplings and prescribed motions of a lattice. */
  struct Ties
  {
    /** By strut: whether its first and second end are released from the joint
     * rotation. */
    std::vector<std::array<bool, 2>> released;

    /** Joints coupled by connectors. */
    std::vector<JointPair> connected;

    /** Rotations coupled by rotational springs. */
    std::vector<RotationPair> sprung;

    /** Rotations coupled by revolute hinges (two constraints each). */
    std::vector<RotationPair> hinged;

    /** Linear relations between joint motions (one constraint each). */
    std::vector<LinearRelation> relations;

    /** Motions prescribed by supports, including components that a joint
     * lacks. */
    std::vector<JointMotion> prescribed;
  };

  /**
   * Owner of the rotation of each joint. This is the joint itself if an
   * unreleased elastic strut ends there or at an image; in space the rigid part
   * that clamps the struts or is the only one with a rotation; otherwise the
   * ground.
   * @param released as Ties::released
   */
  std::vector<RotationOwner>
  joint_rotations(const Lattice                          &lattice,
                  const std::vector<std::array<bool, 2>> &released);

  class UnknownDistribution;

  /**
   * Global numbers of the unknowns of a lattice, equal on all ranks; each rank
   * owns a contiguous range. A missing unknown has the number -1.
   */
  struct GlobalNumbers
  {
    /** Numbers by motion component. */
    using MotionNumbers = std::array<int, n_motion_components>;

    struct RigidPartNumbers
    {
      std::vector<unsigned int> clamped_joints; ///< in the plane
      /** Displacement of the centre of mass and rotation, if the part owns
       * them. */
      MotionNumbers    motion;
      std::vector<int> multipliers;
    };

    struct HingeNumbers
    {
      unsigned int       joint;
      std::array<int, 2> multipliers;
    };

    struct RelationNumbers
    {
      std::string  path;  ///< of its definition, for messages
      unsigned int joint; ///< of its first term
      int          multiplier;
    };

    /** @param components motion components of nodes */
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
    std::vector<RelationNumbers>  relations;
    /** Index of the first node of each strut in a consecutive list of the nodes
     * of all struts, and the end of the list. Joints are repeated for each
     * strut. */
    std::vector<std::size_t> first_nodes;
    /** By elastic strut: first number of its inner nodes, ordered by element,
     * node and component. */
    std::vector<int> first_inner;
    /** Rank r owns the numbers [first_owned[r], first_owned[r + 1]). */
    std::vector<int> first_owned;

    bool owns(const unsigned int rank, const int number) const
    {
      return number >= first_owned[rank] && number < first_owned[rank + 1];
    }

    /** Numbers of the rotation at an end of an elastic strut, as rotation(). */
    const MotionNumbers &end_rotation(const Lattice &lattice,
                                      unsigned int   strut,
                                      unsigned int   end) const;

    /** Appends the numbers of the nodes of an element of @p order in FE_Q
     * order, with all components per node. */
    void add_element(const Lattice       &lattice,
                     const StrutInterval &element,
                     unsigned int         order,
                     std::vector<int>    &result) const;

    /** Numbers of a rotation; components below first_rotation are -1. */
    MotionNumbers rotation(const RotationOwner &rotation_owner) const;

    /** Numbers of all unknowns coupled by the constraints of a rigid part. */
    std::vector<int> rigid_part_unknowns(const Lattice &lattice,
                                         unsigned int   rigid_part) const;

    /** Joint constrained by multiplier @p number of a rigid part. */
    unsigned int constrained_joint(const Lattice &lattice,
                                   unsigned int   rigid_part,
                                   unsigned int   number) const;

    /** Groups of unknowns coupled by rotational springs, hinges and linear
     * relations, including multipliers. */
    std::vector<std::vector<int>> coupled(const Ties &ties) const;

  private:
    void assign_numbers(const UnknownDistribution &distribution);

    std::vector<unsigned int> components; ///< motion components of nodes
  };

  /**
   * Unknowns of rigid parts, hinges and linear relations: their own motions and
   * Lagrange multipliers, as local numbers; -1 if not on this rank.
   */
  class ConstraintUnknowns
  {
  public:
    /** @param rigid_parts rigid parts of this rank, with all their unknowns */
    ConstraintUnknowns(const GlobalNumbers             &numbers,
                       const UnknownLayout             &layout,
                       const std::vector<unsigned int> &rigid_parts);

    /** Rigid parts of this rank, with all their unknowns. */
    const std::vector<unsigned int> &rigid_parts() const
    {
      return local_rigid_parts;
    }

    /** Displacement of the centre of mass or rotation of a part with
     * RigidPart::has_rotation. */
    int motion(const unsigned int rigid_part,
               const unsigned int component) const
    {
      return rigid_part_numbers[rigid_part].motion[component];
    }

    /** Joints whose rotation is constrained to a rigid part, in the plane. */
    const std::vector<unsigned int> &
    clamped_joints(const unsigned int rigid_part) const
    {
      return rigid_part_numbers[rigid_part].clamped_joints;
    }

    /** A multiplier of a rigid part. With a rotation: 3 k + c for component c
     * of joint k. Otherwise 0 is the base length, then d per joint k = 2, 3,
     * ... in d dimensions, then one per clamped joint in the plane. */
    int multiplier(const unsigned int rigid_part,
                   const unsigned int number) const
    {
      return rigid_part_numbers[rigid_part].multipliers[number];
    }

    /** Number of multipliers of a rigid part; equal on all ranks. */
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

    /** Multiplier of a relation of Ties::relations. */
    int relation_multiplier(const unsigned int relation) const
    {
      return relation_numbers[relation];
    }

    /** Multipliers on this rank. */
    const std::vector<int> &multipliers() const
    {
      return local_multipliers;
    }

    /** Number of multipliers over all ranks. */
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
    std::vector<int>                relation_numbers;
    std::vector<int>                local_multipliers;
  };
} // namespace auxfem

#endif
