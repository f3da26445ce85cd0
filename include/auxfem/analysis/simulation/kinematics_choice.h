#ifndef auxfem_analysis_simulation_kinematics_choice_h
#define auxfem_analysis_simulation_kinematics_choice_h

#include <auxfem/analysis/simulation/lattice_run.h>

namespace auxfem
{
  /**
   * A run with `Effects/Large rotation = auto`: by small displacements where
   * their error in the static answer to the loads is within
   * `Effects/Tolerance`. If the run comes to SmallDisplacementLimit, it is
   * done again from the start with exact kinematics. Other scenes run as they
   * are. Throws as LatticeRun::run(); collective.
   */
  RunResult run_with_chosen_kinematics(const RunPlan &plan,
                                       MPI_Comm       communicator,
                                       Recorder      &recorder);

  /**
   * The first part of that for a dry run: the line about it among what is
   * simulated. Collective.
   */
  void explain_kinematics(LatticeRun &exact);
} // namespace auxfem

#endif
