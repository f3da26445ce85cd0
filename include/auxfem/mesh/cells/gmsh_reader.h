#ifndef auxfem_mesh_cells_gmsh_reader_h
#define auxfem_mesh_cells_gmsh_reader_h

#include <auxfem/mesh/cells/line_mesh.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>

namespace auxfem
{
  /** Limits of a process and of each process that it starts. */
  struct ProcessLimits
  {
    /** Wall time, and CPU time (s). */
    double seconds = std::numeric_limits<double>::infinity();
    /** Memory beyond that of this process (bytes); 0: no limit. */
    std::size_t memory = 0;
  };

  /**
   * Runs @p action in a silent copy of this process and returns its result, so
   * that a library that crashes or exits ends the copy only. @p action must
   * neither throw nor call MPI. The copy and its children end with @p action,
   * with this process, or at the limits. Throws CrashedProcess if @p action
   * does not complete, std::bad_alloc if the copy cannot be made.
   */
  std::string
  run_in_separate_process(const std::function<std::string()> &action,
                          const ProcessLimits                &limits = {});

  /** Failure of an action in run_in_separate_process(). */
  struct CrashedProcess
  {
    std::string reason; ///< e.g. `Segmentation fault`, `no end after 30 s`
    bool        is_out_of_time = false;
  };

  /**
   * Runs the script @p file in gmsh and meshes its curves. A script may do all
   * that the user may. gmsh runs in a separate process, which ends with this
   * one
   * or after @p seconds, with its children. Throws MeshMistake if gmsh does not
   * understand or complete the script.
   */
  LineMesh run_gmsh_script(const std::string &file, double seconds);

  /** Whether read_with_gmsh() reads files with this @p ending. */
  bool gmsh_can_read(const std::string &ending);

  /**
   * Reads the mesh in @p content by gmsh's reader for the file @p ending, e.g.
   * `.vtk`; such readers run no commands. Limits and errors as in
   * run_gmsh_script().
   */
  LineMesh read_with_gmsh(const std::string &content,
                          const std::string &ending,
                          double             seconds);
} // namespace auxfem

#endif
