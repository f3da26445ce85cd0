#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/lattice_analysis.h>

namespace auxfem
{
  AnalysisEntry static_path_entry()
  {
    return {"static path",
            "Equilibria of a lattice along a path of loads and prescribed "
            "motions, of which time is the parameter.",
            [](const Scene &scene) {
              return scene.context.model == Model::lattice &&
                !scene.time.scheme->is_dynamic();
            },
            run_lattice,
            check_lattice};
  }
} // namespace auxfem
