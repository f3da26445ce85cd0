#ifndef auxfem_mesh_cells_cell_table_h
#define auxfem_mesh_cells_cell_table_h

#include <auxfem/mesh/cell.h>

namespace auxfem
{
  /** Symmetric star cell (mesh/cells/star.cc). */
  RegistryEntry<Cell> star_cell_entry();

  /** Star cell with free widths, notches and stubs (mesh/cells/star.cc). */
  RegistryEntry<Cell> general_star_cell_entry();

  /** Cell of bars, rigid parts and a rod by Shokri Rad, Mohsenizadeh and Ahmad
   * (mesh/cells/hinged_star.cc). */
  RegistryEntry<Cell> hinged_star_cell_entry();

  /** Symmetric star cell in space (mesh/cells/space_star.cc). */
  RegistryEntry<Cell> space_star_cell_entry();

  /** @name Cells of common lattices, one file per family in mesh/cells/ */
  ///@{
  RegistryEntry<Cell> square_cell_entry();
  RegistryEntry<Cell> triangular_cell_entry();
  RegistryEntry<Cell> kagome_cell_entry();
  RegistryEntry<Cell> hexagonal_cell_entry();
  RegistryEntry<Cell> reentrant_cell_entry();
  RegistryEntry<Cell> arrowhead_cell_entry();
  RegistryEntry<Cell> tetrachiral_cell_entry();
  RegistryEntry<Cell> anti_tetrachiral_cell_entry();
  RegistryEntry<Cell> hexachiral_cell_entry();
  RegistryEntry<Cell> rotating_squares_cell_entry();
  RegistryEntry<Cell> cubic_cell_entry();
  RegistryEntry<Cell> body_centred_cell_entry();
  RegistryEntry<Cell> face_centred_cell_entry();
  RegistryEntry<Cell> octet_cell_entry();
  RegistryEntry<Cell> kelvin_cell_entry();
  RegistryEntry<Cell> diamond_cell_entry();
  RegistryEntry<Cell> space_reentrant_cell_entry();
  ///@}

  /** Joints and struts given one by one (mesh/cells/frame.cc). */
  RegistryEntry<Cell> frame_cell_entry();

  /** A cell of the user's own, repeated by vectors (mesh/cells/pattern.cc). */
  RegistryEntry<Cell> pattern_cell_entry();

  /** Line elements of a mesh file (mesh/cells/mesh_file.cc). */
  RegistryEntry<Cell> mesh_file_cell_entry();
} // namespace auxfem

#endif
