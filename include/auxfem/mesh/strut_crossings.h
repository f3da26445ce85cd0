#ifndef auxfem_mesh_strut_crossings_h
#define auxfem_mesh_strut_crossings_h

#include <auxfem/mesh/lattice.h>

namespace auxfem
{
  /**
   * Throws InputError if axes of struts meet elsewhere than at joints: if two
   * struts cross, lie on each other, or one ends on the other without a joint
   * there. Struts of rigid parts may meet others, as guided rods do. Arcs are
   * polylines.
   */
  void refuse_crossing_struts(const Lattice &lattice);
} // namespace auxfem

#endif
