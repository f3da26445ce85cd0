#include <auxfem/scene/frequency_response_definition.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity lowest_frequency      = {"Lowest frequency",
                                            "1 Hz",
                                            "Hz",
                                            Range::positive(),
                                            "Begin of the band."};
    const Quantity highest_frequency     = {"Highest frequency",
                                            "1000 Hz",
                                            "Hz",
                                            Range::positive(),
                                            "End of the band."};
    const Integer  number_of_frequencies = {"Number",
                                            200,
                                            2,
                                            1000000,
                                            "How many frequencies."};
    const Choice   spacing               = {"Spacing",
                                            "logarithmic",
                                            {"logarithmic", "linear"},
                                            "Whether frequencies lie at equal ratios or at "
                                                            "equal distances."};
    const Quantity time_of_amplitudes    = {
         "Time of the loads",
         "none",
         "s",
         Range::non_negative(),
         "Loads and prescribed motions of this time are the amplitudes, in phase "
            "with each other; about a static equilibrium what they differ from those "
            "of t = 0. none: Time/End time.",
         {"none"}};
    const Choice about_state = {
      "About",
      "rest",
      {"rest", "static equilibrium"},
      "State about which the lattice swings. rest: as it is given, without "
      "loads; static equilibrium: that under the loads, weight and prescribed "
      "motions of t = 0."};
  } // namespace

  std::vector<double> FrequencyResponseDefinition::frequencies() const
  {
    std::vector<double> all;
    for (unsigned int i = 0; i < number; ++i)
      {
        const double part = double(i) / (number - 1);
        all.push_back(is_logarithmic ? lowest * std::pow(highest / lowest, part)
                                     : lowest + (highest - lowest) * part);
      }
    return all;
  }

  SubsectionSchema frequency_response_schema()
  {
    return {"Frequency response",
            SubsectionSchema::Form::fixed,
            "With Analysis = frequency response: steady vibrations under "
            "harmonic loads.",
            {lowest_frequency,
             highest_frequency,
             number_of_frequencies,
             spacing,
             time_of_amplitudes,
             about_state}};
  }

  FrequencyResponseDefinition
  read_frequency_response(const ParameterValues &values)
  {
    FrequencyResponseDefinition response;
    response.lowest         = values[lowest_frequency];
    response.highest        = values[highest_frequency];
    response.number         = values[number_of_frequencies];
    response.is_logarithmic = values[spacing] == "logarithmic";
    if (!values.is_word(time_of_amplitudes))
      response.load_time = values[time_of_amplitudes];
    response.about_equilibrium = values[about_state] != "rest";
    if (!(response.lowest < response.highest))
      values.refuse(highest_frequency,
                    "it must be above Lowest frequency. Raise it, or lower the "
                    "other");
    return response;
  }
} // namespace auxfem
