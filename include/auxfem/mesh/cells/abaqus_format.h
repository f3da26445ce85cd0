#ifndef auxfem_mesh_cells_abaqus_format_h
#define auxfem_mesh_cells_abaqus_format_h

#include <auxfem/mesh/cells/line_mesh.h>

namespace auxfem
{
  /**
   * Nodes, beam and truss elements, node and element sets in @p content of an
   * input file of Abaqus without parts and instances. Elements are also in a
   * set named by their type. Nodes of sets at which no element ends are left
   * out; this and all else that is not taken over is in the notes. Throws
   * MeshMistake, e.g. `line 12: element 5 has node 9, ...`.
   */
  LineMesh read_abaqus(const std::string &content);
} // namespace auxfem

#endif
