#ifndef auxfem_mesh_cells_separate_process_h
#define auxfem_mesh_cells_separate_process_h

#include <functional>
#include <string>

namespace auxfem
{
  /**
   * Runs @p action in a copy of this process, mute, and returns what it returns:
   * a library that crashes, aborts or exits ends the copy only. It must neither
   * throw nor call MPI. Throws CrashedProcess if the copy has not come to an
   * end, std::bad_alloc if none can be made.
   */
  std::string
  run_in_separate_process(const std::function<std::string()> &action);

  /** How a process has ended that run_in_separate_process() has started. */
  struct CrashedProcess
  {
    std::string how; ///< e.g. `Segmentation fault`
  };
} // namespace auxfem

#endif
