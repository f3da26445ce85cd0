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
  /** What a run has left in its folder for one that goes on from there. */
  struct RestartedRun
  {
    std::string folder;
    /** The file that the scene was read from, from the root of all folders. */
    std::string scene_file;
    /** Scene::all_parameters. */
    std::string parameters;
    /** Checksums (CRC-32) of the other files that it was read from, by name. */
    std::map<std::string, unsigned int> input_files;
    /** Those of this rank; of all ranks where there were others. */
    CheckpointData records;
    /** What is wrong with a newer checkpoint; empty: nothing. */
    std::string warning;
  };

  /** Whether the checksums of @p run are those of its files now: the name of
   * one that has changed, or is gone; empty: they are. */
  std::string changed_input_file(const RestartedRun &run);

  /**
   * Finds the last checkpoint in @p folder. Throws InputError if there is none
   * that can be used. Every rank reads it.
   */
  RestartedRun find_run_to_resume(const std::string &folder,
                                  MPI_Comm           communicator);

  /**
   * Writes checkpoints of a run into its folder, so rarely that they take less
   * than a 300th of its time, beside the first and the last. All functions are
   * collective.
   */
  class RunCheckpoints
  {
  public:
    /** @param scene must outlive the object. */
    RunCheckpoints(const Scene &scene, MPI_Comm communicator);

    /** Whether another one takes no more than that. */
    bool is_due();

    /**
     * Writes one with the @p records of all ranks; @p files belong to it, and
     * are on the disk before it. Throws ComputationError if the disk takes no
     * more.
     */
    void write(CheckpointData records, const std::vector<std::string> &files);

  private:
    using Clock = std::chrono::steady_clock;

    CheckpointContent content_of(std::string bytes) const;

    const Scene      &scene;
    const MPI_Comm    communicator;
    CheckpointFiles   files; ///< for the first rank
    Clock::time_point last;
    Clock::duration   took{0};
  };
} // namespace auxfem

#endif
