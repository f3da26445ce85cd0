#ifndef auxfem_scene_study_definition_h
#define auxfem_scene_study_definition_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A number, or a time history, that the runs of a study are compared by. */
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
      integral ///< over time, e.g. the impulse of a reaction
    };

    std::string name;
    Measure     measure = Measure::history;
    /** Of history.csv; one, but a history may be that of a vector. */
    std::vector<std::string> columns;
    /** Of Measure::at_time (s); none is the end. */
    std::optional<double> time;
    /** What it should be, a function of time, where that is known. */
    std::optional<TimeFunction> exact;
    /** `Quantities/NAME`, for messages. */
    std::string path;
  };

  /** `Quantities`. */
  SubsectionSchema quantities_schema();

  /**
   * One of them: `history top.ux, top.uy`, `top.uy at 5 ms`, `maximum of
   * top.uy`, `time of minimum of top.uy`, `integral of base.ry`; ` =
   * EXPRESSION` after it is the exact value. Throws InputError for what is none
   * of these.
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
  };

  /** `Study`. */
  SubsectionSchema study_schema();

  /** The values of that subsection; the quantities are another one. */
  StudyDefinition read_study(ParameterValues &values);
} // namespace auxfem

#endif
