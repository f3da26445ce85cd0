#ifndef auxfem_scene_output_parameters_h
#define auxfem_scene_output_parameters_h

#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
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
