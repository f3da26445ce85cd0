#ifndef auxfem_mesh_position_text_h
#define auxfem_mesh_position_text_h

#include <deal.II/base/point.h>

#include <string>

namespace auxfem
{
  /**
   * A position for messages, `(x, y) m` in the plane (@p dimension 2) and
   * `(x, y, z) m` in space.
   */
  std::string position_text(const dealii::Point<3> &position,
                            unsigned int            dimension);
} // namespace auxfem

#endif
