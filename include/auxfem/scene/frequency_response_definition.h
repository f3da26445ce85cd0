#ifndef auxfem_scene_frequency_response_definition_h
#define auxfem_scene_frequency_response_definition_h

#include <auxfem/parameters/subsection_schema.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /** `Frequency response`: at which frequencies harmonic loads are answered. */
  struct FrequencyResponseDefinition
  {
    double       lowest = 1, highest = 1000; ///< Hz
    unsigned int number         = 200;
    bool         is_logarithmic = true;
    /** Amplitudes are the loads of this time (s); none: the end time. */
    std::optional<double> load_time;
    /** About the static equilibrium under the loads of t = 0, else about rest.
     */
    bool about_equilibrium = false;

    /** All of them, rising (Hz). */
    std::vector<double> frequencies() const;
  };

  SubsectionSchema frequency_response_schema();

  /** Throws InputError for a band without width. */
  FrequencyResponseDefinition
  read_frequency_response(const ParameterValues &values);
} // namespace auxfem

#endif
