#ifndef auxfem_model_linear_relations_h
#define auxfem_model_linear_relations_h

#include <auxfem/model/joint_releases.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** A motion of an image in an infinite lattice and that of the joint which it
   * repeats. */
  struct ImageTie
  {
    unsigned int       image, base; ///< joints
    unsigned int       component;   ///< of motion
    std::array<int, 3> shift;       ///< as JointImage::shift
  };

  /**
   * Ties of all images: displacements to those of their base joints, and
   * rotations if they have any.
   * @param releases strut ends that rotate by themselves
   */
  std::vector<ImageTie> image_ties(const Lattice                   &lattice,
                                   const std::vector<JointRelease> &releases);

  /**
   * Relations of image_ties() under a mean deformation: displacements differ by
   * its part over the shift, rotations are equal.
   * @param length coefficient (m) of rotations
   */
  std::vector<LinearRelation>
  periodic_relations(const Lattice                   &lattice,
                     const std::vector<JointRelease> &releases,
                     double                           length);

  /**
   * Linear relations of all `Constraints/NAME`: n - 1 for n joints that move
   * alike, one across each line in the plane and two in space.
   *
   * Throws InputError for unknown joints and for relations without meaning.
   * @param length coefficient (m) of rotations in relations without
   *   displacements; the largest coefficient of displacements becomes 1
   */
  std::vector<LinearRelation>
  linear_relations(const Scene &scene, const Lattice &lattice, double length);

  /** Throws InputError for motions in @p relations that @p numbering lacks, and
   * for components of large rotations in space, which do not add up. */
  void check_relations(const std::vector<LinearRelation> &relations,
                       const DofNumbering                &numbering,
                       bool                               large_rotation);
} // namespace auxfem

#endif
