#ifndef auxfem_mesh_cells_msh_format_h
#define auxfem_mesh_cells_msh_format_h

#include <string>

namespace auxfem
{
  /**
   * What is wrong with the mesh file @p file, e.g. `line 66: element 5 has node
   * -1, ...`; empty if nothing is found. Looks at the counts, numbers and node
   * references of text files in gmsh's formats 2 and 4.1, on which gmsh's own
   * reader relies; other files are taken as they are.
   */
  std::string mistake_in_mesh_file(const std::string &file);
} // namespace auxfem

#endif
