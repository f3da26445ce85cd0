#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/lattice_analysis.h>

namespace auxfem
{
  AnalysisEntry transient_entry()
  {
    return {
      "transient",
      "Motion of a lattice with inertia from t = 0 to the end time, by an "
      "implicit time scheme.",
      [](const Scene &scene) {
        return scene.analysis != Analysis::static_path &&
          scene.context.model == Model::lattice &&
          scene.time.scheme->is_dynamic();
      },
      run_lattice,
      check_lattice};
  }
} // namespace auxfem
