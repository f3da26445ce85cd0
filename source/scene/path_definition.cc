#include <auxfem/scene/path_definition.h>

namespace auxfem
{
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
      "Opposite side",
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
} // namespace auxfem
