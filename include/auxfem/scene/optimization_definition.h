#ifndef auxfem_scene_optimization_definition_h
#define auxfem_scene_optimization_definition_h

#include <auxfem/parameters/parameter_values.h>
#include <auxfem/parameters/subsection_schema.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** An entry of `Design variables`: a parameter and its bounds. */
  struct DesignVariable
  {
    std::string path; ///< e.g. `Connectors/damper/Spring stiffness`
    std::string unit; ///< of the bounds, e.g. `kN/m`; empty: none
    double      lower = 0, upper = 1; ///< in `unit`
    /** Whether equal steps of the search are equal factors of the value. */
    bool is_logarithmic = false;

    /** Value (in `unit`) at @p part of the range, from 0 to 1. */
    double value_at(double part) const;

    /** Part of the range at which the variable has @p value (in `unit`). */
    double part_at(double value) const;

    /** Text of the parameter at @p part of the range. */
    std::string text_at(double part) const;
  };

  /** An expression of results to be made small or large. */
  struct Objective
  {
    std::string expression;
    bool        is_maximized = false;

    /** As the user writes it, e.g. `minimize peak_force`. */
    std::string text() const
    {
      return (is_maximized ? "maximize " : "minimize ") + expression;
    }
  };

  /** A limit of an expression of results. */
  struct ResultLimit
  {
    std::string expression;
    std::string limit;           ///< expression in SI units
    std::string unit;            ///< unit word of the limit, if it is a number
    bool        is_upper = true; ///< `<=`, not `>=`
    std::string text;            ///< as the user writes it
  };

  /** `Design variables` and `Optimization`: the parameters of a scene at which
   * its results are best. */
  struct OptimizationDefinition
  {
    std::vector<DesignVariable> variables;
    std::vector<Objective>      objectives; ///< one or two
    std::vector<ResultLimit>    limits;
    /** Methods, one after another; empty: chosen by the problem. */
    std::vector<std::string> methods;
    unsigned int             n_evaluations  = 0; ///< of each search and method
    unsigned int             n_starts       = 1;
    unsigned int             n_front_points = 0;
    unsigned int             seed           = 1;
    /** Parts of the ranges. */
    double first_step = 0, tolerance = 0, difference_step = 0;
    bool   has_sensitivities = true;

    /** Part of a limit by which designs may exceed it. */
    double constraint_tolerance() const
    {
      constexpr double most = 1e-3;
      return std::min(tolerance, most);
    }

    bool is_given() const
    {
      return !variables.empty();
    }
  };

  /** Schema of `Design variables`. */
  SubsectionSchema design_variables_schema();

  /** Reads one entry of `Design variables`, `LOWER:UPPER UNIT`. Throws
   * InputError for bounds that are not understood or cross. */
  DesignVariable read_design_variable(ParameterValues &values);

  /** Schema of `Optimization`. */
  SubsectionSchema optimization_schema();

  /** Reads `Optimization` into @p optimization. Throws InputError for
   * objectives and limits that are not understood. */
  void read_optimization(const ParameterValues  &values,
                         OptimizationDefinition &optimization);
} // namespace auxfem

#endif
