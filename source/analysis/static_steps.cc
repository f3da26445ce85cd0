#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/lattice_analysis.h>

namespace auxfem
{
  AnalysisEntry static_steps_entry()
  {
    return {"static steps",
            "Equilibria of a lattice in a course of loads and prescribed "
            "motions, of which time is the parameter.",
            [](const Scene &scene) {
              return scene.analysis != Analysis::static_path &&
                scene.context.model == Model::lattice &&
                !scene.time.scheme->is_dynamic();
            },
            run_lattice,
            check_lattice};
  }
} // namespace auxfem
