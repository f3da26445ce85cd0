#ifndef auxfem_system_joint_releases_h
#define auxfem_system_joint_releases_h

#include <auxfem/dofs/numbering.h>
#include <auxfem/parameters/scene.h>
#include <auxfem/system/effects/rotational_springs.h>

namespace auxfem
{
  /** The end (0: first, 1: second) of a strut. */
  struct StrutEnd
  {
    unsigned int strut, end;
  };

  /** The strut ends that a `Joints/NAME` of the scene releases. */
  struct JointRelease
  {
    struct AtJoint
    {
      unsigned int          joint;
      std::vector<StrutEnd> ends; ///< at least one
    };
    JointDefinition::Type type;
    double                stiffness; ///< of rotational springs (N m/rad)
    std::vector<AtJoint>  joints;
  };

  /**
   * The releases of all `Joints/NAME`. Throws InputError if none of the named
   * struts ends at one of the named joints.
   */
  std::vector<JointRelease> joint_releases(const Scene   &scene,
                                           const Lattice &lattice);

  /** Marks what is released, and the joints that have springs, in @p ties. */
  void release(const std::vector<JointRelease> &releases, Ties &ties);

  /**
   * The springs between released ends and what they turn against: the rotation
   * of the joint if a strut is rigid there, else that of the first of several
   * released struts, else, for a strut alone, the ground. nullptr if this rank
   * has none.
   */
  std::unique_ptr<RotationalSprings>
  make_rotational_springs(const std::vector<JointRelease> &releases,
                          const DofNumbering              &numbering);
} // namespace auxfem

#endif
