#ifndef auxfem_mesh_cells_translations_h
#define auxfem_mesh_cells_translations_h

#include <auxfem/mesh/cell.h>

namespace auxfem
{
  /** `Vector x`, `Vector y`, `Vector z`: translations of the user's cells. */
  Parameters translation_parameters();

  /**
   * Sets the vectors of @p cell from these parameters and its merge distance.
   * Throws InputError if they depend on each other, or if repeated cells would
   * not meet: more pieces in an array of two cells in each direction than in
   * one cell, without pairs that connectors could link.
   */
  void set_translations(const ParameterValues &values, UnitCell &cell);
} // namespace auxfem

#endif
