#include <auxfem/analysis/kinematics_choice.h>
#include <auxfem/analysis/lattice_analysis.h>
#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/order_choice.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_output.h>

#include <iostream>

namespace auxfem
{
  RunResult run_lattice(const Scene   &scene,
                        const MPI_Comm communicator,
                        Recorder      &recorder)
  {
    if (scene.discretization.tolerance)
      return run_with_chosen_orders(scene, communicator, recorder);
    return run_with_chosen_kinematics(scene, communicator, recorder);
  }

  void check_lattice(const Scene &scene, const MPI_Comm communicator)
  {
    LatticeRun run(scene, communicator);
    run.prepare();
    refuse_columns_of_nothing(scene, run.lattice);
    explain_kinematics(run);
    print_overview(scene, run.equations);
    if (scene.discretization.tolerance &&
        run.model.numbering.layout().rank() == 0)
      std::cout << "Discretization/Order = auto: the run chooses orders of its "
                   "own; these counts are those of order "
                << scene.discretization.order << '.' << std::endl;
  }
} // namespace auxfem
