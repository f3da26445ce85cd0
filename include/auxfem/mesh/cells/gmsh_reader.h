#ifndef auxfem_mesh_cells_gmsh_reader_h
#define auxfem_mesh_cells_gmsh_reader_h

#include <auxfem/mesh/cells/line_mesh.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>

namespace auxfem
{
  /** Limits of a process and, one by one, of those that it starts. */
  struct ProcessLimits
  {
    /** Time on the clock, and computing time (s). */
    double seconds = std::numeric_limits<double>::infinity();
    /** Memory beyond that of this process (bytes); 0: no limit. */
    std::size_t memory = 0;
  };

  /**
   * Runs @p action in a copy of this process, mute, and returns what it returns:
   * a library that crashes, aborts or exits ends the copy only. It must neither
   * throw nor call MPI. The copy and all that it has started end with this
   * process, with @p action, or after the time of @p limits. Throws
   * CrashedProcess if the copy has not come to an end, std::bad_alloc if none
   * can be made.
   */
  std::string
  run_in_separate_process(const std::function<std::string()> &action,
                          const ProcessLimits                &limits = {});

  /** How a process has ended that run_in_separate_process() has started. */
  struct CrashedProcess
  {
    std::string how; ///< e.g. `Segmentation fault`, `no end after 30 s`
    bool        is_out_of_time = false;
  };

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
