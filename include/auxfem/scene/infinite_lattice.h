#ifndef auxfem_scene_infinite_lattice_h
#define auxfem_scene_infinite_lattice_h

#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** Name of the set with the joint that stands for the translation @p d of the
   * period, see Lattice::joint_of_translation(). */
  std::string name_of_translation(unsigned int d);

  /**
   * Makes the lattice of @p scene infinite. For effective properties it
   * prescribes the mean strain: at t = 1, 2, ... one component after the other
   * is 1, the others are 0, in the order of ElasticConstants; one joint is held
   * against translation. Adds what an infinite lattice cannot have to @p
   * mistakes.
   */
  void make_infinite(Scene &scene, Mistakes &mistakes);
} // namespace auxfem

#endif
