#ifndef auxfem_mesh_cells_gmsh_reader_h
#define auxfem_mesh_cells_gmsh_reader_h

#include <auxfem/mesh/cells/line_mesh.h>

namespace auxfem
{
  /**
   * Has gmsh run the script @p file, which may do all that the user may, and
   * mesh its curves. gmsh runs in a process of its own, which ends with this
   * one, and together with all that it has started after @p seconds.
   * Throws MeshMistake for what gmsh does not understand or complete.
   */
  LineMesh run_gmsh_script(const std::string &file, double seconds);

  /** Whether read_with_gmsh() reads files with this @p ending. */
  bool gmsh_reads(const std::string &ending);

  /**
   * Mesh in @p content of a file with the @p ending of a format for which gmsh
   * has a reader that runs nothing, e.g. `.vtk`. Limits and errors as in
   * run_gmsh_script().
   */
  LineMesh read_with_gmsh(const std::string &content,
                          const std::string &ending,
                          double             seconds);
} // namespace auxfem

#endif
