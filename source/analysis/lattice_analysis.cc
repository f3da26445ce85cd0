#include <auxfem/analysis/kinematics_choice.h>
#include <auxfem/analysis/lattice_analysis.h>
#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/order_choice.h>
#include <auxfem/output/console.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_output.h>

#include <iomanip>
#include <iostream>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Says so where statics would do. */
    void advise_on_inertia(LatticeRun &run)
    {
      const auto measure = run.inertia_measure();
      if (!measure || run.model.numbering.layout().rank() != 0 ||
          measure->change > run.scene.effects.tolerance)
        return;
      std::ostringstream note;
      note
        << "Inertia is about " << std::setprecision(2) << measure->change
        << " of the answer, as the loads are slow beside the lattice's "
           "oscillations: Time/Scheme = static would do, unless struts snap.";
      std::cout << "\nNote\n" << indented(note.str()) << std::endl;
    }
  } // namespace

  RunResult run_lattice(const Scene   &scene,
                        const MPI_Comm communicator,
                        Recorder      &recorder)
  {
    RunPlan plan(scene);
    if (const Records *const checkpoint = recorder.goes_on_from())
      plan.restore(*checkpoint);
    else if (scene.discretization.tolerance)
      plan.elements = choose_elements(plan, communicator, recorder);
    return run_with_chosen_kinematics(plan, communicator, recorder);
  }

  void check_lattice(const Scene &scene, const MPI_Comm communicator)
  {
    LatticeRun run(scene, communicator);
    run.prepare();
    refuse_columns_of_nothing(scene, run.lattice);
    explain_kinematics(run);
    print_overview(scene, run.equations);
    advise_on_inertia(run);
    if (scene.discretization.tolerance &&
        run.model.numbering.layout().rank() == 0)
      std::cout
        << "Discretization/Order = auto: the run chooses elements of its "
           "own; these counts are those of order "
        << scene.discretization.order << '.' << std::endl;
  }
} // namespace auxfem
