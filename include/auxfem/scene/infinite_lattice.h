#ifndef auxfem_scene_infinite_lattice_h
#define auxfem_scene_infinite_lattice_h

#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** Name of the set with the joint that stands for the axis @p d of the mean
   * deformation, see Lattice::joint_of_axis(). */
  std::string name_of_axis(unsigned int d);

  /**
   * Depth of the continuum of a planar lattice (m): that of its widest section;
   * 1 m if sections have no dimensions, and in space, where sizes have no such
   * factor.
   */
  double depth_of_continuum(const Scene &scene);

  /** Makes the lattice of @p scene infinite. Adds what an infinite lattice
   * cannot have to @p mistakes. */
  void make_infinite(Scene &scene, Mistakes &mistakes);

  /**
   * Adds supports and loads that hold one joint of an infinite lattice against
   * translation and deform it on average as the analysis asks for: by
   * `Mean deformation`, or, for effective properties, so that at t = 1, 2, ...
   * one strain after the other is 1, the others are 0, in the order of
   * ElasticConstants. Needs the final sections.
   */
  void prescribe_mean_deformation(Scene &scene);
} // namespace auxfem

#endif
