#ifndef auxfem_scene_sweep_definition_h
#define auxfem_scene_sweep_definition_h

#include <auxfem/parameters/parameter_values.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** An entry of `Sweep`: values of one parameter. */
  struct SweptParameter
  {
    std::string path; ///< e.g. `Lattice/Opening angle`
    /** Values as written for the parameter, e.g. `50 deg`; empty if only a
     * range is given. */
    std::vector<std::string> values;
    /** Limits of a range, in `unit`. */
    std::optional<std::array<double, 2>> range;
    std::string                          unit; ///< of a range, e.g. `deg`

    /** The part of the path that columns show, e.g. `Opening angle`. */
    std::string name() const
    {
      return path.substr(path.rfind('/') + 1);
    }

    /** Text of the parameter for @p part of the range, from 0 to 1. */
    std::string at(double part) const;
  };

  /** `Sweep` and `Sampling`: one scene with many values of its parameters. */
  struct SweepDefinition
  {
    std::vector<SweptParameter> parameters;
    /** Number of cases of a Latin hypercube; none: all combinations. */
    std::optional<unsigned int> samples;
    unsigned int                seed = 1;
    /** Results by which cases are tabulated; empty: all of the analysis. */
    std::vector<std::string> results;

    bool is_given() const
    {
      return !parameters.empty();
    }
  };

  /** Schema of `Sweep`. */
  SubsectionSchema sweep_schema();

  /** Reads one entry of `Sweep`. Throws InputError for values not understood.
   */
  SweptParameter read_swept_parameter(ParameterValues &values);

  /** Schema of `Sampling`. */
  SubsectionSchema sampling_schema();

  /** Reads `Sampling` into @p sweep. */
  void read_sampling(const ParameterValues &values, SweepDefinition &sweep);

  /**
   * Points of a Latin hypercube in the unit cube of @p n_coordinates coordinates: each
   * coordinate has one point in each of @p n_points equal intervals (McKay,
   * Beckman and Conover, 1979, Technometrics 21, 239). Equal for equal seeds.
   */
  std::vector<std::vector<double>> latin_hypercube(unsigned int n_points,
                                                   unsigned int n_coordinates,
                                                   unsigned int seed);

  /**
   * The texts of all parameters, case by case: all combinations, the last
   * parameter changing fastest; or a latin_hypercube(). Throws InputError for a
   * range without a step where all combinations are asked for.
   */
  std::vector<std::vector<std::string>> cases_of(const SweepDefinition &sweep);
} // namespace auxfem

#endif
