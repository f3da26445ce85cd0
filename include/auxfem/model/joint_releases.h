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

  /** Straight struts in one line that turn about it without any resistance. */
  struct FreeSpin
  {
    /** In order; several where they are rigidly connected to each other. */
    std::vector<unsigned int> struts;
    /** The released end of the first strut. */
    StrutEnd end;
  };

  /**
   * The bars between ball hinges: straight elastic struts in space released by
   * a hinge at both ends, or at one and alone at a joint that may turn at the
   * other; or several in line, rigidly connected with each other alone, with
   * such outer ends. No load can turn them about their own axis. None in the
   * plane.
   * @param releases of @p lattice
   */
  std::vector<FreeSpin> free_spins(const RunPlan                   &plan,
                                   const Lattice                   &lattice,
                                   const std::vector<JointRelease> &releases);
} // namespace auxfem

#endif
