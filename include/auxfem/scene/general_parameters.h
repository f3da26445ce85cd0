#ifndef auxfem_scene_general_parameters_h
#define auxfem_scene_general_parameters_h

#include <auxfem/figures/derived_columns.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
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

  /** `Effects`: physical effects to be simulated. */
  struct EffectSwitches
  {
    Switch large_rotation      = Switch::automatic;
    Switch shear_flexibility   = Switch::automatic;
    Switch inertia             = Switch::automatic;
    Switch rotary_inertia      = Switch::automatic;
    Switch connector_viscosity = Switch::automatic;
    Switch strut_damping       = Switch::automatic;
    Switch strut_relaxation    = Switch::automatic;
    Switch plasticity          = Switch::automatic;
    Switch gravity             = Switch::automatic;
    Switch hinges              = Switch::automatic;
    Switch contact             = Switch::automatic;
    /** Relative change of the result that leaving out an effect may make. */
    double tolerance = 1e-3;
  };

  /** Schema of `Effects`. */
  SubsectionSchema effects_schema();

  /** Reads `Effects`. */
  EffectSwitches read_effects(ParameterValues &values);

  /** `Analysis`: kind of computation. */
  enum class Analysis
  {
    simulation,           ///< time steps by the time scheme
    static_path,          ///< equilibria by arc length
    modes,                ///< natural frequencies and modes
    buckling,             ///< load factors at which the lattice buckles
    frequency_response,   ///< steady vibrations under harmonic loads
    effective_properties, ///< those of the infinite lattice as a continuum
    effective_response,   ///< the infinite lattice at large mean strains
    dispersion,           ///< waves of the infinite lattice
    study                 ///< many simulations with other parameters
  };

  /** Whether @p analysis takes the lattice as one period of an infinite one. */
  constexpr bool is_infinite(const Analysis analysis)
  {
    return analysis == Analysis::effective_properties ||
      analysis == Analysis::effective_response ||
      analysis == Analysis::dispersion;
  }

  /** Whether @p analysis is linearized about one state. */
  constexpr bool is_linearized(const Analysis analysis)
  {
    return analysis == Analysis::modes || analysis == Analysis::buckling ||
      analysis == Analysis::frequency_response;
  }

  /** Schema of the top level of the parameter file. */
  SubsectionSchema general_schema();

  /** Reads `Title`. */
  std::string read_title(const ParameterValues &values);

  /** Name of @p analysis in the parameter file, e.g. `static path`. */
  std::string name_of(Analysis analysis);

  /** Reads `Analysis`. */
  Analysis read_analysis(const ParameterValues &values);

  /** Name of @p model in the parameter file, e.g. `reduced cell`. */
  std::string name_of(Model model);

  /** `Model` at the top level of the file; nothing for an unknown name, which
   * check_subsection() reports. */
  std::optional<Model> model_of(const ParameterSubsection &root);

  /** `Dimension`, as model_of(). */
  std::optional<unsigned int> dimension_of(const ParameterSubsection &root);

  /** `Probes/NAME`: joints or rigid parts whose mean motion is written to
   * history.csv. */
  struct ProbeDefinition
  {
    std::string name;
    /** A joint selection (mesh/sets.h), or `rigid: STRUTS` or
     * `rigid: STRUTS @ JOINTS` for the rigid parts of struts. */
    std::string selection;
    std::string path; ///< for messages
  };

  /** Schema of `Probes`. */
  SubsectionSchema probes_schema();

  /** Reads one entry `Probes/NAME`. */
  ProbeDefinition read_probe(ParameterValues &values);

  /** `Output`: files of a run. */
  struct OutputParameters
  {
    std::string directory = "output";
    /** Time between .vtu files (s); 0: at start and end only; empty: a fiftieth
     * of the end time. */
    std::optional<double> graphics_interval;
    bool                  graphics = true;
    /** Whether .vtu files have the stresses of struts. */
    bool         stresses         = true;
    unsigned int history_interval = 1; ///< steps between rows of history.csv
    /** Time between rows of history.csv (s), instead of history_interval. */
    std::optional<double> row_interval;
    /** Number of checkpoints, after equal numbers of steps. */
    unsigned int checkpoints = 20;
    unsigned int segments    = 8; ///< straight pieces an element is drawn with
    /** Whether history.csv has the strains between opposite sides. */
    bool effective_strains = false;
    /** Whether a verdict against the results makes the exit code a failure. */
    bool                         verdict_fails = true;
    std::vector<ProbeDefinition> probes;
    std::vector<DerivedColumn>   columns;
  };

  /** Schema of `Output`. */
  SubsectionSchema output_schema();

  /** Reads `Output`, without the probes. */
  OutputParameters read_output(ParameterValues &values);
} // namespace auxfem

#endif
