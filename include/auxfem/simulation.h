#ifndef auxfem_simulation_h
#define auxfem_simulation_h

#include <auxfem/output/start_times.h>
#include <auxfem/parameters/scene.h>

#include <mpi.h>

namespace auxfem
{
  /**
   * One run from a scene to a folder of results: builds the lattice and its
   * system, or the reduced cell, which the first rank computes alone; steps
   * through time, writes as it goes. Throws InputError or
   * ComputationError; what was computed until then is on disk.
   * @param start of this rank, for the summary.
   */
  void run(const Scene &scene, MPI_Comm communicator, const StartTimes &start);

  /**
   * The dry run of --check: builds everything, prints counts and effects,
   * computes and writes nothing.
   */
  void check(const Scene &scene, MPI_Comm communicator);

  /**
   * --compare: every scheme of the reduced cell on every one of @p scenes, as a
   * table on the screen and in @p folder. See reduced_cell/comparison.h.
   */
  void compare(const std::vector<Scene> &scenes,
               const std::string        &folder,
               MPI_Comm                  communicator);
} // namespace auxfem

#endif
