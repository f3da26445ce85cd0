#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/lattice_analysis.h>
#include <auxfem/output/run_output.h>

namespace auxfem
{
  AnalysisEntry simulation_entry()
  {
    return {
      "simulation",
      "Motion of a lattice under its loads from t = 0 to the end time, with "
      "inertia by an implicit time scheme, or as a series of equilibria.",
      [](const Scene &scene) {
        return scene.analysis == Analysis::simulation &&
          scene.context.model == Model::lattice;
      },
      [](const Scene         &scene,
         const MPI_Comm       communicator,
         const FolderOptions &options) {
        return run_lattice(scene,
                           communicator,
                           *make_run_output(scene, communicator, options));
      },
      run_lattice,
      check_lattice,
      {}};
  }
} // namespace auxfem
