#ifndef auxfem_reduced_cell_cell_run_h
#define auxfem_reduced_cell_cell_run_h

#include <auxfem/output/start_times.h>
#include <auxfem/reduced_cell/cell_scheme.h>

namespace auxfem
{
  /**
   * One run of the reduced cell from a scene to a folder of results, on the
   * calling rank. Throws InputError or ComputationError; what was computed
   * until then is on disk.
   * @param start of the calling rank, for the summary.
   */
  void run_reduced_cell(const Scene &scene, const StartTimes &start);

  /** The dry run of --check: prints what is simulated, writes nothing. */
  void check_reduced_cell(const Scene &scene);

  /** The course of a cell that is kept in memory. */
  struct CellCourse
  {
    std::vector<CellSample> samples;
    /** `completed`, or why it ended early. */
    std::string exit_state;
  };

  /** Computes @p scene and writes nothing; failures are in the exit state. */
  CellCourse compute_course(const Scene &scene);
} // namespace auxfem

#endif
