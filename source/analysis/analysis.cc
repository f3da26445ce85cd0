#include <auxfem/analysis/analysis.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace auxfem
{
  const std::vector<AnalysisEntry> &analysis_registry()
  {
    static const std::vector<AnalysisEntry> registry = {
      // Scenes with many runs have another analysis for each of them.
      sweep_entry(),
      optimization_entry(),
      simulation_entry(),
      static_path_entry(),
      modes_entry(),
      buckling_entry(),
      frequency_response_entry(),
      effective_properties_entry(),
      effective_response_entry(),
      dispersion_entry(),
      reduced_cell_entry(),
      study_entry()};
    return registry;
  }

  const AnalysisEntry &analysis_of(const Scene &scene)
  {
    const auto &registry = analysis_registry();
    const auto  entry    = std::find_if(registry.begin(),
                                    registry.end(),
                                    [&scene](const AnalysisEntry &candidate) {
                                      return candidate.serves(scene);
                                    });
    AssertThrow(entry != registry.end(),
                dealii::ExcMessage("No analysis serves the scene."));
    return *entry;
  }
} // namespace auxfem
