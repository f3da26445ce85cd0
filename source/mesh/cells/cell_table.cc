#include <auxfem/mesh/cells/cell_table.h>

namespace auxfem
{
  const Registry<Cell> &cell_registry()
  {
    static const Registry<Cell> registry = {star_cell_entry(),
                                            general_star_cell_entry(),
                                            hinged_star_cell_entry(),
                                            space_star_cell_entry(),
                                            frame_cell_entry(),
                                            mesh_file_cell_entry()};
    return registry;
  }
} // namespace auxfem
