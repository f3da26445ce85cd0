#ifndef auxfem_analysis_kinematics_choice_h
#define auxfem_analysis_kinematics_choice_h

#include <auxfem/analysis/lattice_run.h>

namespace auxfem
{
  /**
   * A run with `Effects/Large rotation = auto`: with small displacements where
   * the static answer to the loads differs little enough by exact kinematics,
   * and as long as KinematicCorrection stays within `Effects/Tolerance`. If
   * it does not, the run is done again from the start with exact kinematics.
   * Other scenes run as they are. Throws as LatticeRun::run(); collective.
   */
  RunResult run_with_chosen_kinematics(const Scene &scene,
                                       MPI_Comm     communicator,
                                       Recorder    &recorder);

  /**
   * The first part of that for a dry run: the line about it among what is
   * simulated. Collective.
   */
  void explain_kinematics(LatticeRun &exact);
} // namespace auxfem

#endif
