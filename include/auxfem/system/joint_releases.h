#ifndef auxfem_system_joint_releases_h
#define auxfem_system_joint_releases_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>
#include <auxfem/system/effects/revolute_hinges.h>

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
      std::vector<StrutEnd> ends; ///< of elastic struts
      /** In space: rigid parts with a rotation, of the chosen rigid struts. */
      std::vector<unsigned int> rigid_parts;
    };
    /** Of the scene; must outlive this. */
    const JointDefinition *definition;
    std::vector<AtJoint>   joints;
    /** What springs or revolute hinges couple; see couple(). */
    std::vector<TurningPair> pairs;
  };

  /**
   * The releases of all `Joints/NAME`, without pairs. Throws InputError if none
   * of the named struts ends at one of the named joints, or if what ends there
   * cannot turn as asked for.
   */
  std::vector<JointRelease> joint_releases(const Scene   &scene,
                                           const Lattice &lattice);

  /**
   * Marks what is released in @p ties, and pairs, in @p releases and @p ties,
   * released ends with what they turn against: the rotation of the joint if it
   * has one, else that of the first of several ends, else, for a single end,
   * the ground. Throws InputError where that would be a bar, which has no
   * rotation.
   */
  void couple(std::vector<JointRelease> &releases,
              const Lattice             &lattice,
              Ties                      &ties);

  /**
   * The rotational springs. nullptr if this rank has none.
   * @param layout extended by what springs keep of large rotations in space.
   */
  std::unique_ptr<Effect>
  make_rotational_springs(const std::vector<JointRelease> &releases,
                          const DofNumbering              &numbering,
                          StateLayout                     &layout);

  /**
   * The revolute hinges. nullptr if the scene has none.
   * @param length by which their conditions become lengths (m).
   */
  std::unique_ptr<RevoluteHinges>
  make_revolute_hinges(const std::vector<JointRelease> &releases,
                       const DofNumbering              &numbering,
                       bool                             large_rotation,
                       double                           length);
} // namespace auxfem

#endif
