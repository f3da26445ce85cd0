#ifndef auxfem_scene_study_definition_h
#define auxfem_scene_study_definition_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A number, a time history or a field that the runs of a study are compared
   * by. */
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
      integral,         ///< over time, e.g. the impulse of a reaction
      energy_norm,      ///< of the strains of all struts
      total_energy_norm ///< of their strains and velocities
    };

    std::string name;
    Measure     measure = Measure::history;
    /** Of history.csv; one, but a history may be that of a vector, and a norm
     * has none. */
    std::vector<std::string> columns;
    /** Of Measure::at_time and of norms (s); none is the end. */
    std::optional<double> time;
    /** What it should be, a function of time, where that is known. */
    std::optional<TimeFunction> exact;
    /** `Quantities/NAME`, for messages. */
    std::string path;

    /** Whether it is a norm of what all struts do. */
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

  /** `Quantities`. */
  SubsectionSchema quantities_schema();

  /**
   * One of them: `history top.ux, top.uy`, `top.uy at 5 ms`, `maximum of
   * top.uy`, `time of minimum of top.uy`, `integral of base.ry`; ` =
   * EXPRESSION` after it is the exact value; `energy norm at 5 ms`, `total
   * energy norm at end`. Throws InputError for what is none of these.
   */
  QuantityDefinition read_quantity(ParameterValues &values);

  /** `Study`: a scene computed again and again with other parameters. */
  struct StudyDefinition
  {
    /** What is asked, see study/study_kind.h. */
    std::string kind;

    /** @name Values of a parameter to be tried
     * Empty: that of the scene; nothing: some that follow from it. */
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
    /** Whether the limit of ever finer runs is extrapolated from two of them.
     */
    bool extrapolates = false;
    /** Of every simulation whose time is compared. */
    unsigned int repetitions = 1;
    /** Relative change of a quantity that an effect has to make to be called
     * for. */
    double tolerance = 0.01;

    std::vector<QuantityDefinition> quantities;

    /** Whether the exact values of all quantities are known, so that no run is
     * needed as a reference. */
    bool is_exact() const;
  };

  /** `Study`. */
  SubsectionSchema study_schema();

  /** The values of that subsection; the quantities are another one. */
  StudyDefinition read_study(ParameterValues &values);
} // namespace auxfem

#endif
