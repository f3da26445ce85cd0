#ifndef auxfem_scene_general_parameters_h
#define auxfem_scene_general_parameters_h

#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** On, off, or decided from the scene. */
  enum class Switch
  {
    automatic,
    on,
    off
  };

  /** `Effects`: what is simulated. */
  struct EffectSwitches
  {
    Switch large_rotation      = Switch::automatic;
    Switch shear_flexibility   = Switch::automatic;
    Switch inertia             = Switch::automatic;
    Switch rotary_inertia      = Switch::automatic;
    Switch connector_viscosity = Switch::automatic;
    Switch strut_damping       = Switch::automatic;
    Switch gravity             = Switch::automatic;
    Switch hinges              = Switch::automatic;
    Switch contact             = Switch::automatic;
    /** Relative change of the answer that may be given away. */
    double tolerance = 1e-3;
  };

  /** `Effects`. */
  SubsectionSchema effects_schema();

  /** The values of that subsection. */
  EffectSwitches read_effects(ParameterValues &values);

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

  /**
   * `Probes/NAME`: a set of joints or rigid parts whose mean motion goes to
   * history.csv.
   */
  struct ProbeDefinition
  {
    std::string name;
    /**
     * Name of a joint set or a joint selection (see mesh/sets.h), or
     * `rigid: STRUTS` or `rigid: STRUTS @ JOINTS` for the rigid parts of
     * struts.
     */
    std::string selection;
    std::string path;
  };

  /** `Probes`. */
  SubsectionSchema probes_schema();

  /** One of them. */
  ProbeDefinition read_probe(ParameterValues &values);

  /** `Output`. */
  struct OutputParameters
  {
    std::string directory = "output";
    double      graphics_interval =
      0; ///< s between .vtu files; 0: start and end only
    bool         graphics         = true;
    unsigned int history_interval = 1;  ///< steps between rows of history.csv
    std::optional<double> row_interval; ///< in place of it (s)
    /** Of a run, at equal numbers of steps; 0: there are none. */
    unsigned int checkpoints = 20;
    unsigned int segments    = 8; ///< straight pieces an element is drawn with
    /** Whether history.csv has the strains between opposite sides. */
    bool effective_strains = false;
    /** Whether results that are not to be used are a failure. */
    bool                         verdict_fails = true;
    std::vector<ProbeDefinition> probes;
  };

  /** `Output`. */
  SubsectionSchema output_schema();

  /** The values of that subsection; the probes are another one. */
  OutputParameters read_output(ParameterValues &values);
} // namespace auxfem

#endif
