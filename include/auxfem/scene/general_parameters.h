#ifndef auxfem_scene_general_parameters_h
#define auxfem_scene_general_parameters_h

#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** `Analysis`: what is computed of a scene. */
  enum class Analysis
  {
    simulation,  ///< the scene, as its time scheme does
    static_path, ///< equilibria by arc length
    modes,       ///< natural frequencies and modes
    buckling,    ///< factors of the loads at which the lattice buckles
    /** Steady vibrations under harmonic loads. */
    frequency_response,
    study ///< many simulations with other parameters
  };

  /** Whether it looks at small motions about one state: modes, buckling,
   * frequency response. */
  constexpr bool is_of_small_motions(const Analysis analysis)
  {
    return analysis == Analysis::modes || analysis == Analysis::buckling ||
      analysis == Analysis::frequency_response;
  }

  /** The top level of the parameter file, outside all subsections. */
  SubsectionSchema general_schema();

  /** `Title`. */
  std::string read_title(const ParameterValues &values);

  /** The word for @p analysis, e.g. `static path`. */
  std::string name_of(Analysis analysis);

  /** `Analysis`. */
  Analysis read_analysis(const ParameterValues &values);

  /**
   * `Constants`: names and values. Throws InputError for one that is not
   * understood, has a meaning already or is given twice.
   */
  std::vector<std::pair<std::string, double>>
  read_constants(const ParameterValues &values);

  /** The word for @p model, e.g. `reduced cell`. */
  std::string name_of(Model model);

  /**
   * The model that the top level of the file asks for; nothing if its word is
   * none, which check_subsection() reports.
   */
  std::optional<Model> model_of(const ParameterSubsection &root);

  /** As model_of(), the dimension of space. */
  std::optional<unsigned int> dimension_of(const ParameterSubsection &root);
} // namespace auxfem

#endif
