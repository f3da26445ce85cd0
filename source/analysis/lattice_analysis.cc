#include <auxfem/analysis/lattice_analysis.h>
#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/order_choice.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_output.h>

namespace auxfem
{
  RunResult run_lattice(const Scene   &scene,
                        const MPI_Comm communicator,
                        Recorder      &recorder)
  {
    if (scene.discretization.tolerance)
      return run_with_chosen_orders(scene, communicator, recorder);
    return LatticeRun(scene, communicator).run(recorder);
  }

  void check_lattice(const Scene &scene, const MPI_Comm communicator)
  {
    LatticeRun run(scene, communicator);
    run.prepare();
    refuse_columns_of_nothing(scene, run.lattice);
    print_overview(scene, run.equations);
  }
} // namespace auxfem
