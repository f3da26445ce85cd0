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

  namespace
  {
    const Integer number = {
      "Number",
      10,
      1,
      1000,
      "How many modes, those of the lowest frequencies or "
      "factors of the loads."};
    const Choice about = {
      "About",
      "rest",
      {"rest", "static equilibrium"},
      "State that vibrates or, with further loads, buckles. rest: as the lattice "
      "is given, without loads; static equilibrium: that under the loads, weight and prescribed motions of t = "
      "0, with all they change of the stiffness."};
    const Quantity load_time = {
      "Time of the loads",
      "none",
      "s",
      Range::non_negative(),
      "Of Analysis = buckling: the lattice buckles under a multiple of the loads "
      "and prescribed motions of this time or, about a static equilibrium, of "
      "what they differ from those of t = 0. none: Time/End time.",
      {"none"}};
    const Boolean reversed_loads = {
      "Reversed loads",
      false,
      "Of Analysis = buckling: whether the opposite of the loads is multiplied."};
    const Boolean damped = {
      "Damped",
      false,
      "Of Analysis = modes: whether frequency and damping ratio of each mode are "
      "computed with connectors and damping of struts, too; where loads follow "
      "their joints, whether modes are those with damping."};
    const Integer relaxations = {
      "Relaxations",
      0,
      0,
      1000,
      "Of Analysis = modes: how many of the slowest motions that decay without "
      "swinging are computed, by connectors and damping of struts."};
    const Quantity amplitude = {
      "Amplitude",
      "0.05",
      "1",
      Range::positive(),
      "Largest displacement in the files for ParaView, over the largest "
      "extension of the lattice."};
    const Integer pictures = {"Pictures",
                              16,
                              1,
                              1000,
                              "Files for ParaView of one period of each mode."};
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
      "The load factor multiplies all loads, weight and prescribed motions of "
      "this time; with Time/Start from = static equilibrium what they differ "
      "from those of t = 0, which stay as they are. none: Time/End time.",
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
      "Load factor of the first point, were the structure linear. Its distance "
      "from the start is the first arc length."};
    const Quantity resolution = {
      "Resolution",
      "0.02",
      "1",
      Range{0, 1, true, false},
      "How far a point may lie off the tangent to the path at the point before, "
      "as a part of the displacements and of the largest load factor so far. "
      "Arc lengths follow it."};
    const Quantity largest_load_factor = {
      "Largest load factor",
      "1",
      "1",
      Range::positive(),
      "The path ends with this load factor, or its opposite."};
    const Quantity largest_displacement = {
      "Largest displacement",
      none,
      "m",
      Range::positive(),
      "The path ends at the first point where a node has moved this far.",
      {none}};
    const Integer most_points = {"Points",
                                 1000,
                                 1,
                                 1000000,
                                 "The path ends after this many points."};
    const Integer branch      = {
           "Branch",
           0,
           0,
           1000,
           "The bifurcation at which the path leaves the branch it came on, 1 for "
                "the first; 0: at none; stable: at every one from which on that branch is "
                "less stable.",
           {stable}};
    const Boolean opposite_side = {
      "Reverse branch",
      false,
      "Which of both ways the path goes where it leaves a branch; false: in the "
      "sense in which the mode's largest entry is positive."};
    const Integer points_a_picture = {
      "Graphics interval",
      1,
      1,
      1000000,
      "Points from one picture for ParaView to the next."};
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
             most_points,
             branch,
             opposite_side,
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
    path.most_points = values[most_points];
    if (values.is_word(branch))
      path.branch = PathDefinition::Branch::stable;
    else if (values[branch] > 0)
      {
        path.branch        = PathDefinition::Branch::numbered;
        path.branch_number = values[branch];
      }
    path.opposite_side     = values[opposite_side];
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
           "Angle theta0 of the bars against the horizontal at rest; at 0 and 90 "
                "degrees there is no cell."};
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
                                            "part; auto: 3 m1, three beams like the "
                                            "bars.",
                                      {"auto"}};
    const TimeExpression load      = {"Load",
                                      "",
                                      "N",
                                      "Force f1 that pushes the upper part down."};
  } // namespace



  SubsectionSchema reduced_cell_schema()
  {
    return {"Reduced cell",
            SubsectionSchema::Form::fixed,
            "The star cell of rigid parts, loaded from above; only with Model "
            "= reduced cell, which also uses Connectors (exactly one), Time, "
            "Newton and Output.",
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
