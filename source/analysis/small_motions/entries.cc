#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/small_motions/frequency_response.h>
#include <auxfem/analysis/small_motions/modes.h>

namespace auxfem
{
  AnalysisEntry modes_entry()
  {
    return {"modes",
            "Natural frequencies and modes of a lattice, at rest or about an "
            "equilibrium.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::modes;
            },
            run_modes,
            nullptr,
            check_modes,
            modes_files()};
  }

  AnalysisEntry buckling_entry()
  {
    return {
      "buckling",
      "Factors of the loads at which a lattice buckles, by linear theory, "
      "and its buckling modes.",
      [](const Scene &scene) { return scene.analysis == Analysis::buckling; },
      run_modes,
      nullptr,
      check_modes,
      modes_files()};
  }

  AnalysisEntry frequency_response_entry()
  {
    return {"frequency response",
            "Amplitudes and phases of steady vibrations over the frequency.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::frequency_response;
            },
            run_frequency_response,
            nullptr,
            check_frequency_response,
            frequency_response_contents().names()};
  }
} // namespace auxfem
