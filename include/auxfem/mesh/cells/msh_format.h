#ifndef auxfem_mesh_cells_msh_format_h
#define auxfem_mesh_cells_msh_format_h

#include <auxfem/mesh/cells/line_mesh.h>

namespace auxfem
{
  /**
   * Lines of two and three nodes and physical groups of points and curves in
   * @p content of a file in gmsh's format MSH 2 or 4.1, as text or binary.
   * Groups without name are called "group" and their number. The lines may be
   * none. Throws MeshMistake, e.g. `line 66: element 5 has node -1, ...`.
   */
  LineMesh read_msh(const std::string &content);
} // namespace auxfem

#endif
