#ifndef auxfem_model_rigid_parts_h
#define auxfem_model_rigid_parts_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /**
   * Makes the rigid parts of @p scene in @p lattice: struts of the definitions
   * become rigid (and lose their section), struts that meet at a joint and are
   * of one definition become one part unless they are to be parts of their own.
   * Mass is spread evenly along the struts, or equally over the joints of a
   * part without struts.
   *
   * Throws InputError for a strut of two definitions, a part of fewer than two
   * joints or of joints at one position.
   */
  void make_rigid_parts(const Scene &scene, Lattice &lattice);

  /** For every joint of @p lattice whether it is one of a rigid part. */
  std::vector<bool> joints_of_rigid_parts(const Lattice &lattice);

  /** The parts that struts of @p struts belong to, each once, in order. */
  std::vector<unsigned int>
  rigid_parts_of(const Lattice                   &lattice,
                 const std::vector<unsigned int> &struts);
} // namespace auxfem

#endif
