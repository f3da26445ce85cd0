#ifndef auxfem_model_constraint_unknowns_h
#define auxfem_model_constraint_unknowns_h

#include <auxfem/algebra/unknown_layout.h>
#include <auxfem/model/global_numbers.h>

namespace auxfem
{
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
      return kept_rigid_parts;
    }

    /**
     * An unknown of a rigid part's own, RigidPart::has_rotation: displacement
     * of its centre of mass, rotation.
     */
    int motion(const unsigned int rigid_part,
               const unsigned int component) const
    {
      return of_rigid_part[rigid_part].motion[component];
    }

    /** In the plane: joints whose rotation is tied to that of a rigid part. */
    const std::vector<unsigned int> &
    clamped_joints(const unsigned int rigid_part) const
    {
      return of_rigid_part[rigid_part].clamped_joints;
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
      return of_rigid_part[rigid_part].multipliers[number];
    }

    /** Number of multipliers of a rigid part; the same on every rank. */
    unsigned int n_multipliers(const unsigned int rigid_part) const
    {
      return of_rigid_part[rigid_part].multipliers.size();
    }

    /** Multiplier @p number (0, 1) of a pair of Ties::hinged. */
    int hinge_multiplier(const unsigned int hinge,
                         const unsigned int number) const
    {
      return of_hinge[hinge][number];
    }

    /** The multipliers kept on this rank. */
    const std::vector<int> &multipliers() const
    {
      return kept_multipliers;
    }

    /** Number of all multipliers, over all ranks. */
    unsigned int n_multipliers() const;

  private:
    struct OfRigidPart
    {
      std::array<int, n_motion_components> motion;
      std::vector<unsigned int>            clamped_joints;
      std::vector<int>                     multipliers;
    };

    std::vector<unsigned int>       kept_rigid_parts;
    std::vector<OfRigidPart>        of_rigid_part;
    std::vector<std::array<int, 2>> of_hinge;
    std::vector<int>                kept_multipliers;
  };
} // namespace auxfem

#endif
