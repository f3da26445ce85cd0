#include <auxfem/loads/load_definitions.h>
#include <auxfem/scene/analysis_definitions.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity lowest_frequency      = {"Lowest frequency",
                                            "1 Hz",
                                            "Hz",
                                            Range::positive(),
                                            "Lower end of the band."};
    const Quantity highest_frequency     = {"Highest frequency",
                                            "1000 Hz",
                                            "Hz",
                                            Range::positive(),
                                            "Upper end of the band."};
    const Integer  number_of_frequencies = {"Number",
                                            200,
                                            2,
                                            1000000,
                                            "Number of frequencies."};
    const Choice   spacing               = {"Spacing",
                                            "logarithmic",
                                            {"logarithmic", "linear"},
                                            "Spacing by equal ratios or equal distances."};
    const Quantity time_of_amplitudes    = {
         "Time of the loads",
         "none",
         "s",
         Range::non_negative(),
         "Time whose loads and prescribed motions are the amplitudes, in phase with "
            "each other; about a static equilibrium, their difference from t = 0. "
            "none: Time/End time.",
         {"none"}};
    const Choice about_state = {
      "About",
      "rest",
      {"rest", "static equilibrium"},
      "State about which the lattice vibrates. rest: the unloaded lattice; static "
      "equilibrium: under loads, weight and prescribed motions of t = 0."};
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
                    "it must be above Lowest frequency. Increase it, or reduce "
                    "Lowest frequency");
    return response;
  }

  namespace
  {
    const Integer number = {
      "Number",
      10,
      1,
      1000,
      "Number of modes, from the lowest frequency or load factor."};
    const Choice about = {
      "About",
      "rest",
      {"rest", "static equilibrium"},
      "State that vibrates or, with further loads, buckles. rest: the unloaded "
      "lattice; static equilibrium: under loads, weight and prescribed motions of "
      "t = 0, with their effect on the stiffness."};
    const Quantity load_time = {
      "Time of the loads",
      "none",
      "s",
      Range::non_negative(),
      "With Analysis = buckling: time whose loads and prescribed motions are "
      "multiplied; about a static equilibrium, their difference from t = 0. "
      "none: Time/End time.",
      {"none"}};
    const Boolean reversed_loads = {
      "Reversed loads",
      false,
      "With Analysis = buckling: whether the loads are reversed."};
    const Boolean damped = {
      "Damped",
      false,
      "With Analysis = modes: whether frequency and damping ratio of each mode "
      "are also computed with damping by connectors and struts; with follower "
      "loads, whether the modes themselves include it."};
    const Integer relaxations = {
      "Relaxations",
      0,
      0,
      1000,
      "With Analysis = modes: number of the slowest motions that decay without "
      "oscillation, by connectors and damping of struts."};
    const Quantity amplitude = {
      "Amplitude",
      "0.05",
      "1",
      Range::positive(),
      "Largest displacement in the files for ParaView, relative to the largest "
      "dimension of the lattice."};
    const Integer pictures = {"Pictures",
                              16,
                              1,
                              1000,
                              "Files for ParaView per period of each mode."};
  } // namespace

  SubsectionSchema modes_schema()
  {
    return {
      "Modes",
      SubsectionSchema::Form::fixed,
      "With Analysis = modes: natural frequencies and modes; with Analysis "
      "= buckling: factors of the loads and buckling modes.",
      {number,
       about,
       load_time,
       reversed_loads,
       damped,
       relaxations,
       amplitude,
       pictures}};
  }

  ModesDefinition read_modes(const ParameterValues &values)
  {
    ModesDefinition modes;
    modes.number            = values[number];
    modes.about_equilibrium = values[about] != "rest";
    if (!values.is_word(load_time))
      modes.load_time = values[load_time];
    modes.reversed_loads = values[reversed_loads];
    modes.damped         = values[damped];
    modes.relaxations    = values[relaxations];
    modes.amplitude      = values[amplitude];
    modes.pictures       = values[pictures];
    return modes;
  }

  namespace
  {
    const std::string none = "none", stable = "stable";

    const Quantity path_load_time = {
      "Time of the loads",
      none,
      "s",
      Range::non_negative(),
      "Time whose loads, weight and prescribed motions the load factor "
      "multiplies; with Time/Start from = static equilibrium, their difference "
      "from t = 0. none: Time/End time.",
      {none}};
    const Boolean path_reversed_loads = {
      "Reversed loads",
      false,
      "Whether the path begins with negative load factors."};
    const Quantity first_increment = {
      "First load increment",
      "0.01",
      "1",
      Range::positive(),
      "Load factor of the first point if the structure were linear; it gives the "
      "first arc length."};
    const Quantity resolution = {
      "Resolution",
      "0.02",
      "1",
      Range{0, 1, true, false},
      "Largest distance of a point from the tangent at the previous point, "
      "relative to the displacements and to the largest load factor so far; it "
      "controls the arc length."};
    const Quantity largest_load_factor = {
      "Largest load factor",
      "1",
      "1",
      Range::positive(),
      "Load factor, of either sign, at which the path ends."};
    const Quantity largest_displacement = {
      "Largest displacement",
      none,
      "m",
      Range::positive(),
      "Displacement of a node at which the path ends.",
      {none}};
    const Integer max_points = {"Points",
                                1000,
                                1,
                                1000000,
                                "Number of points at which the path ends."};
    const Integer branch     = {
          "Branch",
          0,
          0,
          1000,
          "Number of the bifurcation at which the path changes to the other branch; "
              "0: none; stable: all at which the present branch becomes less stable.",
          {stable}};
    const Boolean reverse_branch = {
      "Reverse branch",
      false,
      "Whether the other branch is followed in the direction in which the mode's "
      "largest entry is negative."};
    const Integer points_a_picture = {
      "Graphics interval",
      1,
      1,
      1000000,
      "Number of points from one file for ParaView to the next."};
  } // namespace

  SubsectionSchema path_schema()
  {
    return {"Path",
            SubsectionSchema::Form::fixed,
            "With Analysis = static path: equilibria by arc length, through "
            "limit points and bifurcations.",
            {path_load_time,
             path_reversed_loads,
             first_increment,
             resolution,
             largest_load_factor,
             largest_displacement,
             max_points,
             branch,
             reverse_branch,
             points_a_picture}};
  }

  PathDefinition read_path(const ParameterValues &values)
  {
    PathDefinition path;
    if (!values.is_word(path_load_time))
      path.load_time = values[path_load_time];
    path.reversed_loads      = values[path_reversed_loads];
    path.first_increment     = values[first_increment];
    path.resolution          = values[resolution];
    path.largest_load_factor = values[largest_load_factor];
    if (!values.is_word(largest_displacement))
      path.largest_displacement = values[largest_displacement];
    path.max_points = values[max_points];
    if (values.is_word(branch))
      path.branch = PathDefinition::Branch::stable;
    else if (values[branch] > 0)
      {
        path.branch        = PathDefinition::Branch::numbered;
        path.branch_number = values[branch];
      }
    path.reverse_branch    = values[reverse_branch];
    path.graphics_interval = values[points_a_picture];
    return path;
  }

  namespace
  {
    const Quantity cell_bar_length = {"Bar length",
                                      "0.5 m",
                                      "m",
                                      Range::positive(),
                                      "Length L1 of each of the four bars."};
    const Quantity cell_angle      = {
           "Angle",
           "30 deg",
           "deg",
           Range::open(0, 90),
           "Angle theta0 of the bars to the horizontal, at rest."};
    const Quantity       bar_mass  = {"Bar mass",
                                      "",
                                      "kg",
                                      Range::non_negative(),
                                      "Mass m1 of each bar."};
    const Quantity       part_mass = {"Part mass",
                                      "auto",
                                      "kg",
                                      Range::non_negative(),
                                      "Mass m2 of the upper and of the lower "
                                            "part; auto: 3 m1, as of three bars.",
                                      {"auto"}};
    const TimeExpression load      = {"Load",
                                      "",
                                      "N",
                                      "Force f1 that pushes the upper part down."};
  } // namespace



  SubsectionSchema reduced_cell_schema()
  {
    return {
      "Reduced cell",
      SubsectionSchema::Form::fixed,
      "Star cell of rigid parts, loaded from above. Only with Model = "
      "reduced cell, which also uses Connectors (exactly one), Time, Newton "
      "and Output.",
      {cell_bar_length, cell_angle, bar_mass, part_mass, load},
      "",
      {},
      {Model::reduced_cell}};
  }



  ReducedCellDefinition read_reduced_cell(ParameterValues &values)
  {
    ReducedCellDefinition cell;
    cell.bar_length = values[cell_bar_length];
    cell.angle      = values[cell_angle];
    cell.bar_mass   = values[bar_mass];
    cell.part_mass  = values.value_or(part_mass, 3 * cell.bar_mass);
    cell.load       = read_time_function(values, load);
    cell.path       = values.context.path;
    if (cell.bar_mass == 0 && cell.part_mass == 0)
      values.refuse("Bar mass and Part mass are both 0, so that nothing "
                    "resists acceleration. Give at least one of them");
    return cell;
  }
} // namespace auxfem
