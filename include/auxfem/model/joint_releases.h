#ifndef auxfem_model_joint_releases_h
#define auxfem_model_joint_releases_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/scene.h>

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
    /** What springs or revolute hinges couple. */
    std::vector<RotationPair> pairs;
  };

  /**
   * The releases of all `Joints/NAME`. Released ends are coupled with what they
   * turn against: the rotation of the joint if it has one, else that of the
   * first of several ends, else, for a single end, the ground.
   *
   * Throws InputError if none of the named struts ends at one of the named
   * joints, if what ends there cannot turn as asked for, and where it would
   * turn against a bar, which has no rotation.
   */
  std::vector<JointRelease> joint_releases(const Scene   &scene,
                                           const Lattice &lattice);

  /** Whether some of @p releases have springs. */
  bool have_rotational_springs(const std::vector<JointRelease> &releases);

  /** What @p releases release and couple. */
  Ties ties_of(const std::vector<JointRelease> &releases,
               const Lattice                   &lattice);
} // namespace auxfem

#endif
