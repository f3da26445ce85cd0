#ifndef auxfem_analysis_small_motions_frequency_response_h
#define auxfem_analysis_small_motions_frequency_response_h

#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <mpi.h>

namespace auxfem
{
  /**
   * `Analysis = frequency response`: amplitudes and phases of probes and
   * reactions over the band, into Output/Directory (frequency_response.csv,
   * summary.json) and, the largest, onto the screen. Throws InputError,
   * ComputationError; rows until then are kept. Collective.
   */
  RunResult run_frequency_response(const Scene         &scene,
                                   MPI_Comm             communicator,
                                   const FolderOptions &options);

  /** The dry run: builds everything, prints counts and effects. Collective. */
  void check_frequency_response(const Scene &scene, MPI_Comm communicator);

  /** What such runs write beside log.txt and summary.json. */
  FolderContents frequency_response_contents();
} // namespace auxfem

#endif
