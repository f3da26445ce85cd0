#ifndef auxfem_model_rotation_numbers_h
#define auxfem_model_rotation_numbers_h

#include <auxfem/model/numbering.h>

namespace auxfem
{
  /**
   * A number for each of DofNumbering::spatial_rotations() that names the same
   * rotation on any number of ranks: that of the rigid part that has it, else
   * of the joint, else of the end or the node inside a strut. None in the
   * plane.
   */
  std::vector<unsigned int> rotation_numbers(const Lattice      &lattice,
                                             const DofNumbering &numbering);
} // namespace auxfem

#endif
