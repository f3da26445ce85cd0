#ifndef auxfem_output_summary_h
#define auxfem_output_summary_h

#include <auxfem/equations/equations.h>
#include <auxfem/figures/run_figures.h>
#include <auxfem/model/mass_and_size.h>
#include <auxfem/output/failures.h>
#include <auxfem/output/history.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/run_quantities.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/step_report.h>

#include <map>

namespace auxfem
{
  /** Sizes of a scene over all ranks. */
  struct Counts
  {
    unsigned int joints   = 0;
    unsigned int struts   = 0;
    unsigned int elements = 0;
    /** Number of elastic struts by division into elements. */
    std::map<StrutDivision, unsigned int> struts_of_division;
    unsigned int                          connectors  = 0;
    unsigned int                          rigid_parts = 0;
    /** Displacements, rotations and multipliers. */
    unsigned int unknowns = 0;
    /** Displacements and rotations that are not prescribed. */
    unsigned int free_unknowns = 0;
    /** Constraints, each with a multiplier. */
    unsigned int constraints = 0;
    unsigned int ranks       = 1;
    MassAndSize  mass_and_size;
  };

  /** Counts of @p equations. Collective. */
  Counts count(const Equations &equations);

  /** Memory and time of a run. */
  struct Resources
  {
    /** Largest peak of a rank (bytes). */
    unsigned long largest_memory = 0;
    unsigned long memory         = 0; ///< sum of the ranks' peaks (bytes)
    double        cpu_seconds    = 0; ///< over all ranks
    double        wall_seconds   = 0; ///< wall time of the slowest rank
    PhaseTimes    wall; ///< wall time of the slowest rank by phase
    /**
     * Times before the run: wall times of the slowest rank, processor time of
     * all.
     */
    StartTimes start;
  };

  /** Processor time of this process since its start (s). */
  double cpu_seconds();

  /** Peak memory of this process (bytes). */
  unsigned long peak_memory();

  /**
   * Resources of all ranks since their start. Collective.
   * @param start, wall_seconds, wall times of this rank
   */
  Resources gather_resources(const StartTimes &start,
                             double            wall_seconds,
                             const PhaseTimes &wall,
                             MPI_Comm          communicator);

  /** Content of summary.json. */
  struct Summary
  {
    Counts        counts;
    Work          totals;
    Resources     resources;
    EnergyRecord  energies;
    LargestStrain strain;               ///< if effective strains are requested
    double        largest_rotation = 0; ///< rad
    /** Struts that broke. */
    std::vector<BrokenStrut>      broken            = {};
    std::vector<BrokenConnectors> broken_connectors = {};
    /** Largest penetration over the strut thickness; with plates only. */
    std::optional<double> largest_penetration;
    double                time = 0; ///< final time (s)
    /**
     * Final position on a path of equilibria; `time` is then the arc length
     * (m).
     */
    std::optional<PathPosition> path;
    /** See RunResult. */
    std::optional<double>      time_error, small_displacement_error;
    std::optional<OrderReport> orders;
    /** Figures from the history. */
    RunFigures figures;
    /** Quantities of the scene that are numbers, and lines on them. */
    NamedResults quantities;
    std::string  quantities_text;
    /** Notes on the scene, see notes_on(). */
    std::vector<std::string> notes;
    /** Simulated and omitted effects. */
    std::vector<EffectDecision> decisions;
    /** `completed`, or the reason of an early end. */
    std::string exit_state;
    /** Findings on the results, the worst first. */
    std::vector<Finding> findings;
  };

  /**
   * Version, revision and build type of the program, e.g. `0.1.0 (1a2b3c4,
   * Release)`.
   */
  std::string version_text();

  /**
   * First members of every summary.json: program, date, scene, @p exit_state
   * and the final @p time (s).
   */
  Json
  json_of_run(const Scene &scene, const std::string &exit_state, double time);

  /** Size, mass and relative density as far as known, and struts by section. */
  Json json_of(const MassAndSize &found);

  /** Names of the groups in @p definitions. */
  template <class Definition>
  std::vector<std::string>
  names_of_groups(const std::vector<Definition> &definitions)
  {
    std::vector<std::string> names;
    names.reserve(definitions.size());
    for (const Definition &definition : definitions)
      names.push_back(definition.name);
    return names;
  }

  /** Last lines about energies and the folder; see closing_text(). */
  std::string closing_energies_text(const EnergyRecord &record,
                                    const std::string  &folder);

  /** The text of summary.json, with the date of now. */
  std::string summary_json(const Scene &scene, const Summary &summary);

  /** The last lines of a run on the screen, without the last line break. */
  std::string closing_text(const Summary &summary, const std::string &folder);
} // namespace auxfem

#endif
