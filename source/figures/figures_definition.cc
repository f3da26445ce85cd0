#include <auxfem/figures/figures_definition.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string no_body = "none", automatic = "auto";

    const Boolean figures = {
      "Figures",
      true,
      "Whether the run ends with figures of every plate, support and probe: "
      "peaks, impulse, stroke, rebound; also in evaluation.csv and "
      "summary.json."};
    const Choice filter_class = {
      "Filter class",
      "1000",
      {"none", "60", "180", "600", "1000"},
      "Channel frequency class of SAE J211 by which forces and accelerations "
      "are filtered for a second peak; needs ten rows of history.csv in the "
      "time of 1 / class in Hz."};
    const Quantity pulse_threshold = {
      "Pulse threshold",
      "5 %",
      "1",
      Range::closed(0, 0.99),
      "Part of the peak force at which a pulse begins and ends, over which the "
      "mean force is taken."};
    const Quantity settling_band = {
      "Settling band",
      "5 %",
      "1",
      Range::open(0, 1),
      "Part of the whole displacement within which a motion has settled."};

    const Text bodies = {
      "Bodies",
      no_body,
      "Names of two plates or supports that crush the lattice between them, "
      "e.g. press, table: the force is that on the first. none: no crush "
      "curve."};
    const Quantity     area    = {"Area",
                                  automatic,
                                  "m2",
                                  Range::positive(),
                                  "Area of the nominal stress. auto: extent of the "
                                         "lattice across the loading, times its depth in "
                                         "the plane.",
                                  {automatic}};
    const Quantity     height  = {"Height",
                                  automatic,
                                  "m",
                                  Range::positive(),
                                  "Height of the nominal strain. auto: extent of "
                                       "the lattice along the loading.",
                                  {automatic}};
    const QuantityList plateau = {
      "Plateau",
      "20 %, 40 %",
      "1",
      Range::open(0, 1),
      2,
      2,
      "Strains between which the plateau stress is the "
      "mean stress, as in ISO 13314."};
    const Quantity yield_strain = {
      "Yield strain",
      "0",
      "1",
      Range{0, 1, false, true},
      "Strain from which energy counts in the efficiency, whose maximum is the "
      "onset of densification."};

    const Text input = {
      "Input",
      no_body,
      "Column of history.csv with the force or motion that goes in; none: no "
      "transmission."};
    const Text output = {
      "Output",
      no_body,
      "Column of history.csv with the force or motion that comes out."};
    const Quantity from   = {"From",
                             "0 s",
                             "s",
                             Range::any(),
                             "Time before which values do not count."};
    const Quantity to     = {"To",
                             "end",
                             "s",
                             Range::positive(),
                             "Time after which values do not count.",
                             {"end"}};
    const Choice   window = {
        "Window",
        "none",
        {"none", "Hann"},
        "Weights of the values in the spectrum: none for pulses that end within "
          "the time, Hann for vibrations that go on."};
    const Quantity largest_frequency = {
      "Largest frequency",
      "all",
      "Hz",
      Range::positive(),
      "Highest frequency in transmission.csv; all: half a row in time.",
      {"all"}};

    const Text     stressed_struts = {"Struts",
                                      "all",
                                      "Set or selection of struts."};
    const Quantity strength        = {"Strength",
                                      "none",
                                      "Pa",
                                      Range::positive(),
                                      "Stress over which the largest one is "
                                             "divided; none: not given.",
                                      {"none"}};

    const Text         member_struts = {"Struts",
                                        no_body,
                                        "Set or selection of struts; none: no "
                                                "table."};
    const QuantityList member_times  = {
       "Times",
       "end",
       "s",
       Range::non_negative(),
       1,
       10000,
       "Times of the rows, interpolated within steps; end: the end of the run.",
       {"end"}};
    const Integer member_points = {
      "Points per element",
      2,
      2,
      1000,
      "Number of points along each element, from end to end."};

    /** The two bodies of the text; empty for none. */
    std::optional<std::array<std::string, 2>>
    read_bodies(const ParameterValues &values)
    {
      if (values[bodies] == no_body)
        return std::nullopt;
      const auto names =
        dealii::Utilities::split_string_list(values[bodies], ',');
      if (names.size() != 2 || names[0] == names[1])
        values.refuse(bodies,
                      "\"" + values[bodies] +
                        "\" is not understood. Give the names of two plates or "
                        "supports, e.g. press, table");
      return std::array<std::string, 2>{{names[0], names[1]}};
    }
  } // namespace

  SubsectionSchema evaluation_schema()
  {
    return {"Evaluation",
            SubsectionSchema::Form::fixed,
            "Figures that a run reports at its end.",
            {figures, filter_class, pulse_threshold, settling_band}};
  }

  void read_evaluation(ParameterValues &values, FiguresDefinition &result)
  {
    result.figures = values[figures];
    if (values[filter_class] == "none")
      result.options.channel_class = std::nullopt;
    else
      result.options.channel_class = std::stod(values[filter_class]);
    result.options.pulse_threshold = values[pulse_threshold];
    result.options.settling_band   = values[settling_band];
  }

  SubsectionSchema crush_curve_schema()
  {
    return {
      "Crush curve",
      SubsectionSchema::Form::fixed,
      "Nominal stress over nominal strain between two plates or supports, "
      "in crush.csv, with its figures.",
      {bodies, area, height, plateau, yield_strain}};
  }

  void read_crush_curve(ParameterValues &values, FiguresDefinition &result)
  {
    const auto names = read_bodies(values);
    if (!names)
      return;
    CrushDefinition crush;
    crush.bodies = *names;
    if (!values.is_word(area))
      crush.area = values[area];
    if (!values.is_word(height))
      crush.height = values[height];
    const std::vector<double> ends = values[plateau];
    if (!(ends[0] < ends[1]))
      values.refuse(plateau, "the second strain must be the larger one");
    crush.options.plateau_begin = ends[0];
    crush.options.plateau_end   = ends[1];
    crush.options.yield_strain  = values[yield_strain];
    result.crush                = crush;
  }

  SubsectionSchema transmission_schema()
  {
    return {
      "Transmission",
      SubsectionSchema::Form::fixed,
      "Transmission from one column of history.csv to another, in time and by "
      "frequency, in transmission.csv.",
      {input, output, from, to, window, largest_frequency}};
  }

  void read_transmission(ParameterValues &values, FiguresDefinition &result)
  {
    const bool has_input = values[input] != no_body;
    if (has_input != (values[output] != no_body))
      values.refuse(has_input ? output : input,
                    "give both columns, Input and Output, or none of them");
    if (!has_input)
      return;
    TransmissionDefinition transmission;
    transmission.input           = values[input];
    transmission.output          = values[output];
    TransmissionOptions &options = transmission.options;
    options.from                 = values[from];
    options.to                   = values.value_or(to, options.to);
    options.hann_window          = values[window] == "Hann";
    options.largest_frequency =
      values.value_or(largest_frequency, options.largest_frequency);
    if (!(options.from < options.to))
      values.refuse(to, "it is before From");
    result.transmission = transmission;
  }

  SubsectionSchema stresses_schema()
  {
    return {"Stresses",
            SubsectionSchema::Form::named_groups,
            "Struts whose largest von Mises stress is written to history.csv, "
            "with its place.",
            {stressed_struts, strength}};
  }

  void read_stress_probe(ParameterValues &values, FiguresDefinition &result)
  {
    StressProbeDefinition probe;
    probe.name   = values.name();
    probe.struts = values[stressed_struts];
    if (!values.is_word(strength))
      probe.strength = values[strength];
    probe.path = values.context.path;
    result.stresses.push_back(probe);
  }

  SubsectionSchema member_forces_schema()
  {
    return {"Member forces",
            SubsectionSchema::Form::fixed,
            "Section forces of struts at some times, in member_forces.csv.",
            {member_struts, member_times, member_points}};
  }

  void read_member_forces(ParameterValues &values, FiguresDefinition &result)
  {
    if (values[member_struts] == no_body)
      return;
    MemberForcesDefinition members;
    members.struts = values[member_struts];
    members.at_end = values.is_word(member_times);
    if (!members.at_end)
      members.times = values[member_times];
    std::sort(members.times.begin(), members.times.end());
    members.points       = values[member_points];
    members.path         = values.context.path;
    result.member_forces = members;
  }
} // namespace auxfem
