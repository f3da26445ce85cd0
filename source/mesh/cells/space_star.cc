#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/mesh/cells/star.h>
#include <auxfem/parameters/errors.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity space_star_strut_length{
      "Strut length",
      "10 mm",
      "m",
      Range::positive(),
      "Length L of all 30 struts of the cell."};

    const Quantity space_star_opening_angle{
      "Opening angle",
      "70 deg",
      "deg",
      Range::positive(),
      "Angle theta0 between an edge and the axis through its re-entrant vertex; "
      "more than 54.74 deg (tan(theta0) > sqrt(2)) and at most 90 deg."};

    /** Sides in the order of vertices and stub ends: side i lies on axis i / 2,
     * at negative coordinates for even i. */
    constexpr std::array<const char *, 6> space_star_sides = {
      {"left", "right", "bottom", "top", "back", "front"}};

    constexpr unsigned int n_tips            = 8;
    constexpr unsigned int space_star_vertex = n_tips;
    constexpr unsigned int space_star_stub =
      space_star_vertex + space_star_sides.size();

    /** Whether a tip lies at a positive coordinate along @p axis. */
    bool tip_is_positive(const unsigned int tip, const unsigned int axis)
    {
      return (tip >> axis & 1) != 0;
    }

    bool side_is_positive(const unsigned int side)
    {
      return side % 2 != 0;
    }

    void add_tips(const double coordinate, UnitCell &cell)
    {
      for (unsigned int tip = 0; tip < n_tips; ++tip)
        {
          dealii::Point<3> position;
          for (unsigned int axis = 0; axis < 3; ++axis)
            position[axis] =
              tip_is_positive(tip, axis) ? coordinate : -coordinate;
          cell.joints.push_back(position);
          cell.joint_sets["tips"].push_back(tip);
        }
    }

    /** A joint on each half axis, at @p distance from the centre. */
    void add_joints_on_axes(const double distance, UnitCell &cell)
    {
      for (unsigned int side = 0; side < space_star_sides.size(); ++side)
        {
          dealii::Point<3> position;
          position[side / 2] = side_is_positive(side) ? distance : -distance;
          cell.joints.push_back(position);
        }
    }

    void add_edges_and_stubs(UnitCell &cell)
    {
      for (unsigned int tip = 0; tip < n_tips; ++tip)
        for (unsigned int side = 0; side < space_star_sides.size(); ++side)
          if (tip_is_positive(tip, side / 2) == side_is_positive(side))
            cell.struts.push_back(
              {tip, space_star_vertex + side, 0., {"edges"}});
      for (unsigned int side = 0; side < space_star_sides.size(); ++side)
        cell.struts.push_back(
          {space_star_vertex + side, space_star_stub + side, 0., {"stubs"}});
    }

    void name_sides(UnitCell &cell)
    {
      for (unsigned int side = 0; side < space_star_sides.size(); ++side)
        {
          cell.joint_sets["notches"].push_back(space_star_vertex + side);
          cell.ports[space_star_sides[side]] = {space_star_stub + side};
        }
    }

    /** Adds pairs of opposite vertices, named as in the planar star. */
    void add_pairs(UnitCell &cell)
    {
      const unsigned int left = space_star_vertex, right = left + 1,
                         bottom = left + 2, top = left + 3, back = left + 4,
                         front  = left + 5;
      cell.pairs["in-cell"]     = {{top, bottom}};
      cell.pairs["in-cell x"]   = {{left, right}};
      cell.pairs["in-cell z"]   = {{back, front}};
      cell.pairs["in-cell all"] = {{left, right}, {top, bottom}, {back, front}};
    }

    /**
     * Joints: 8 tips, 6 re-entrant vertices, 6 stub ends shared with neighbour
     * cells. Tips of neighbours are 2 L (1 - cos(theta0)) > 0 apart at every
     * allowed angle, so the cell can be repeated along all axes.
     */
    UnitCell build_space_star(const double length, const double angle)
    {
      const double tip    = length * std::sin(angle) / std::sqrt(2.);
      const double vertex = tip - length * std::cos(angle);

      UnitCell cell;
      add_tips(tip, cell);
      add_joints_on_axes(vertex, cell);
      add_joints_on_axes(vertex + length, cell);
      add_edges_and_stubs(cell);
      name_sides(cell);
      add_pairs(cell);
      for (unsigned int axis = 0; axis < 3; ++axis)
        cell.vectors[axis][axis] = 2. * (vertex + length);
      return cell;
    }

    std::unique_ptr<Cell> make_space_star(ParameterValues &values)
    {
      if (values.context.dimension != 3)
        throw InputError(values.context.path +
                         ": the cell 'space star' does not lie in a plane. Set "
                         "Dimension = 3 at the top of the file, or choose the "
                         "cell 'star'.");
      const double length = values[space_star_strut_length];
      const double angle  = values[space_star_opening_angle];
      check_opening_angle(
        {"space star",
         angle,
         length,
         length * (std::sin(angle) / std::sqrt(2.) - std::cos(angle)),
         "L (sin(theta0) / sqrt(2) - cos(theta0))",
         "54.74 deg (tan(theta0) > sqrt(2))",
         ""},
        values.context);
      return std::make_unique<PrebuiltCell>(build_space_star(length, angle));
    }
  } // namespace

  RegistryEntry<Cell> space_star_cell_entry()
  {
    return {"space star",
            "Symmetric star in space (Dimension = 3) of 30 struts of equal "
            "length: 24 edges between 8 tips and 6 re-entrant vertices on the "
            "axes, 6 stubs to the neighbour cells.",
            {space_star_strut_length, space_star_opening_angle},
            make_space_star};
  }
} // namespace auxfem
