#ifndef auxfem_output_run_checkpoints_h
#define auxfem_output_run_checkpoints_h

#include <auxfem/output/checkpoint_files.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>

#include <mpi.h>

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Data of an interrupted run in its folder, from which another run continues.
   */
  struct RestartedRun
  {
    std::string folder;
    /** Absolute path of the scene file. */
    std::string scene_file;
    /** Scene::all_parameters. */
    std::string parameters;
    /** Checksums (CRC-32) of the other input files, by name. */
    std::map<std::string, unsigned int> input_files;
    /**
     * Checkpoint data of this rank; of all ranks if their number has changed.
     */
    CheckpointData records;
    /** Defect of a newer checkpoint; empty: none. */
    std::string warning;
  };

  /**
   * Name of an input file of @p run that has changed or is missing; empty if
   * there is none.
   */
  std::string changed_input_file(const RestartedRun &run);

  /**
   * Reads the last checkpoint in @p folder on every rank. Throws InputError if
   * there is no usable one.
   */
  RestartedRun find_run_to_resume(const std::string &folder,
                                  MPI_Comm           communicator);

  /**
   * Writes checkpoints of a run to its folder, so rarely that they take less
   * than 1/300 of its time, except the first and the last. All functions are
   * collective.
   */
  class RunCheckpoints
  {
  public:
    /** @param scene must outlive the object. */
    RunCheckpoints(const Scene &scene, MPI_Comm communicator);

    /** Whether another checkpoint stays within this time. */
    bool is_due();

    /**
     * Writes a checkpoint with the @p records of all ranks, after syncing @p
     * files, which belong to it. Throws ComputationError if writing fails.
     */
    void write(CheckpointData records, const std::vector<std::string> &files);

  private:
    using Clock = std::chrono::steady_clock;

    CheckpointContent content_of(std::string bytes) const;

    const Scene      &scene;
    const MPI_Comm    communicator;
    CheckpointFiles   files; ///< for the first rank
    Clock::time_point last_write;
    Clock::duration   write_duration{0};
  };
} // namespace auxfem

#endif
