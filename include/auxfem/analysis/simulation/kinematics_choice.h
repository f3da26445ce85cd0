#ifndef auxfem_analysis_simulation_kinematics_choice_h
#define auxfem_analysis_simulation_kinematics_choice_h

#include <auxfem/analysis/simulation/lattice_run.h>

namespace auxfem
{
  /**
   * Runs with `Effects/Large rotation = auto`: uses small displacements if
   * their error in the static response to the loads is within
   * `Effects/Tolerance`. If the run reaches SmallDisplacementLimit, it
   * restarts with exact kinematics. Other scenes run unchanged. Throws as
   * LatticeRun::run(); collective.
   */
  RunResult run_with_chosen_kinematics(const RunPlan &plan,
                                       MPI_Comm       communicator,
                                       Recorder      &recorder);

  /**
   * For a dry run: only adds the decision to the list of simulated effects.
   * Collective.
   */
  void explain_kinematics(LatticeRun &exact);
} // namespace auxfem

#endif
