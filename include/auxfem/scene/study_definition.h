#ifndef auxfem_scene_study_definition_h
#define auxfem_scene_study_definition_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** `Quantities/NAME`: a number, a time history or a field by which a study
   * compares its runs. */
  struct QuantityDefinition
  {
    enum class Measure
    {
      history, ///< the whole time history
      at_time,
      maximum,
      minimum,
      time_of_maximum,
      time_of_minimum,
      integral,              ///< over time, e.g. the impulse of a reaction
      mean_square_deviation, ///< mean over time of the square of column -
                             ///< target
      energy_norm,           ///< of the strains of all struts
      total_energy_norm      ///< of their strains and velocities
    };

    std::string name;
    Measure     measure = Measure::history;
    /** Columns of history.csv: one; several for the history of a vector; none
     * for norms. */
    std::vector<std::string> columns;
    /** Time (s) of Measure::at_time and of norms; none: the end. */
    std::optional<double> time;
    /** Target of Measure::mean_square_deviation. */
    std::optional<TimeFunction> target;
    /** Exact value as a function of time, where it is known. */
    std::optional<TimeFunction> exact;
    /** `Quantities/NAME`, for messages. */
    std::string path;

    /** Whether it is a norm over all struts. */
    bool is_field() const
    {
      return measure == Measure::energy_norm ||
        measure == Measure::total_energy_norm;
    }

    bool is_number() const
    {
      return measure != Measure::history && !is_field();
    }
  };

  /** Schema of `Quantities`. */
  SubsectionSchema quantities_schema();

  /**
   * Reads one entry `Quantities/NAME`: `history top.ux, top.uy`, `top.uy at
   * 5 ms`, `maximum of top.uy`, `time of minimum of top.uy`, `integral of
   * base.ry`, `mean square deviation of f2 from table: f2.csv`, each maybe with
   * an exact value, ` = EXPRESSION`; or `energy norm at 5 ms`, `total energy
   * norm at end`. Throws InputError for anything else.
   */
  QuantityDefinition read_quantity(ParameterValues &values);

  /** `Study`: many runs of a scene with other parameters. */
  struct StudyDefinition
  {
    /** Kind of study, see study/study_kind.h. */
    std::string kind;

    /** @name Parameter values to be compared
     * An empty list means the value of the scene, no list (auto) values derived
     * from it. */
    ///@{
    std::optional<std::vector<unsigned int>> orders;
    std::optional<std::vector<unsigned int>> refinements;
    std::optional<std::vector<double>>       time_steps; ///< s
    std::vector<double>                      time_tolerances;
    std::vector<double>                      newton_tolerances;
    std::vector<std::string>                 schemes;
    ///@}

    /** Whether mesh and time step are refined together, not each alone. */
    bool together = false;
    /** Whether the reference is extrapolated from two runs (Richardson). */
    bool extrapolates = false;
    /** Number of repetitions of each timed run. */
    unsigned int repetitions = 1;
    /** Relative change of a quantity above which an effect is needed. */
    double tolerance = 0.01;

    std::vector<QuantityDefinition> quantities;

    /** Whether the exact values of all quantities are known, so that no
     * reference run is needed. */
    bool is_exact() const;
  };

  /** Schema of `Study`. */
  SubsectionSchema study_schema();

  /** Reads `Study`, without the quantities. */
  StudyDefinition read_study(ParameterValues &values);
} // namespace auxfem

#endif
