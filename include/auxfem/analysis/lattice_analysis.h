#ifndef auxfem_analysis_lattice_analysis_h
#define auxfem_analysis_lattice_analysis_h

#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

namespace auxfem
{
  /** A LatticeRun from its set-up to the end time. */
  RunResult
  run_lattice(const Scene &scene, MPI_Comm communicator, Recorder &recorder);

  /** Its set-up and start; prints counts and what is simulated. */
  void check_lattice(const Scene &scene, MPI_Comm communicator);
} // namespace auxfem

#endif
