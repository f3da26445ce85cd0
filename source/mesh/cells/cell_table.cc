#include <auxfem/mesh/cells/cell_table.h>

namespace auxfem
{
  const Registry<Cell> &cell_registry()
  {
    static const Registry<Cell> registry = {star_cell_entry(),
                                            general_star_cell_entry(),
                                            hinged_star_cell_entry(),
                                            space_star_cell_entry(),
                                            square_cell_entry(),
                                            triangular_cell_entry(),
                                            kagome_cell_entry(),
                                            hexagonal_cell_entry(),
                                            reentrant_cell_entry(),
                                            arrowhead_cell_entry(),
                                            tetrachiral_cell_entry(),
                                            anti_tetrachiral_cell_entry(),
                                            hexachiral_cell_entry(),
                                            rotating_squares_cell_entry(),
                                            cubic_cell_entry(),
                                            body_centred_cell_entry(),
                                            face_centred_cell_entry(),
                                            octet_cell_entry(),
                                            kelvin_cell_entry(),
                                            diamond_cell_entry(),
                                            space_reentrant_cell_entry(),
                                            frame_cell_entry(),
                                            pattern_cell_entry(),
                                            mesh_file_cell_entry()};
    return registry;
  }
} // namespace auxfem
