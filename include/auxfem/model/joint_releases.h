#ifndef auxfem_model_joint_releases_h
#define auxfem_model_joint_releases_h

#include <auxfem/model/numbering.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** The end (0: first, 1: second) of a strut. */
  struct StrutEnd
  {
    unsigned int strut, end;
  };

  /** Strut ends released by one `Joints/NAME` of the scene. */
  struct JointRelease
  {
    struct AtJoint
    {
      unsigned int          joint;
      std::vector<StrutEnd> ends; ///< ends of elastic struts
      /** Rigid parts with a rotation among the chosen rigid struts, in
       * space. */
      std::vector<unsigned int> rigid_parts;
    };
    /** Definition in the scene; must outlive the object. */
    const JointDefinition *definition;
    std::vector<AtJoint>   joints;
    /** Rotations coupled by springs or revolute hinges. */
    std::vector<RotationPair> pairs;
  };

  /**
   * Releases of all `Joints/NAME`. Released ends rotate relative to the joint
   * rotation; without one relative to the first of several ends, and a single
   * end relative to the ground.
   *
   * Throws InputError if no named strut ends at a named joint, if the release
   * is impossible there, and for springs or hinges on bars, which have no
   * rotation.
   */
  std::vector<JointRelease> joint_releases(const Scene   &scene,
                                           const Lattice &lattice);

  /** Whether some of @p releases have springs. */
  bool have_rotational_springs(const std::vector<JointRelease> &releases);

  /** Converts @p releases to Ties. */
  Ties ties_of(const std::vector<JointRelease> &releases,
               const Lattice                   &lattice);

  /**
   * Collinear straight struts that can spin about their axis without
   * resistance.
   */
  struct FreeSpin
  {
    /** Struts in order; several if rigidly connected to each other. */
    std::vector<unsigned int> struts;
    /** The released end of the first strut. */
    StrutEnd end;
  };

  /**
   * Bars between ball hinges in space: straight elastic struts, or collinear
   * chains of them, whose outer ends are hinged or alone at a free joint. No
   * load can spin them about their axis. Empty in the plane.
   * @param releases, relations those of @p lattice
   */
  std::vector<FreeSpin>
  free_spins(const RunPlan                     &plan,
             const Lattice                     &lattice,
             const std::vector<JointRelease>   &releases,
             const std::vector<LinearRelation> &relations);
} // namespace auxfem

#endif
