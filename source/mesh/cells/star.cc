#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/mesh/cells/star.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    [[noreturn]] void refuse(const OpeningAngle &angle,
                             const SceneContext &context,
                             const std::string  &reason)
    {
      std::ostringstream text;
      text << context.path << ": the cell '" << angle.cell
           << "' cannot have an opening angle "
           << "theta0 = " << angle.value * 180. / dealii::numbers::PI
           << " deg. " << reason << " Set 'Opening angle' to more than "
           << angle.lower_limit << " and at most 90 deg.";
      throw InputError(text.str());
    }
  } // namespace

  void check_opening_angle(const OpeningAngle &angle,
                           const SceneContext &context)
  {
    // Angles come from degrees: equality holds up to round-off only.
    if (angle.value > dealii::numbers::PI_2 + round_off)
      refuse(angle,
             context,
             "Above 90 deg the vertices between the tips point outwards: "
             "theta0 <= 90 deg fails.");
    if (angle.vertex_distance <= round_off * angle.strut_length)
      {
        std::ostringstream reason;
        reason << "Its notches would cross in the centre: b = "
               << angle.distance_formula
               << " > 0 fails with b = " << angle.vertex_distance
               << " m for L = " << angle.strut_length << " m." << angle.advice;
        refuse(angle, context, reason.str());
      }
  }

  namespace
  {
    /** Sides in the order of the vertices and stub ends. */
    constexpr std::array<const char *, 4> sides = {
      {"right", "top", "left", "bottom"}};

    constexpr unsigned int first_vertex = 4;

    std::string overlap_sentence(const std::string &side,
                                 const double       depth,
                                 const double       stub)
    {
      std::ostringstream text;
      text << "Its tips would reach past those of the next cell: the " << side
           << " stub length " << stub
           << " m must not be less than the notch depth " << depth
           << " m along the same direction.";
      return text.str();
    }

    class StarCell : public Cell
    {
    public:
      explicit StarCell(const StarShape &shape) : shape(shape)
      {}

      UnitCell build() const override
      {
        return build_star(shape);
      }

    private:
      StarShape shape;
    };

    /** Adds the joints, stubs, ports and joint sets. */
    void add_joints(UnitCell &cell, const StarShape &shape)
    {
      const double w = shape.half_width;
      const double g = shape.half_height;
      const double b = w - shape.side_depth;
      const double c = g - shape.top_depth;
      cell.joints    = {{w, g, 0},
                        {-w, g, 0},
                        {-w, -g, 0},
                        {w, -g, 0},
                        {b, 0, 0},
                        {0, c, 0},
                        {-b, 0, 0},
                        {0, -c, 0}};

      for (unsigned int i = 0; i < sides.size(); ++i)
        {
          const unsigned int axis = i % 2;
          const double       sign = i < 2 ? 1. : -1.;
          const double       length =
            axis == 0 ? shape.horizontal_stub : shape.vertical_stub;
          unsigned int port = first_vertex + i;
          if (length > 0.)
            {
              dealii::Point<3> end = cell.joints[port];
              end[axis] += sign * length;
              port = cell.joints.size();
              cell.joints.push_back(end);
              cell.struts.push_back({first_vertex + i, port, 0., {"stubs"}});
            }
          cell.ports[sides[i]] = {port};
        }
      cell.joint_sets["tips"]    = {0, 1, 2, 3};
      cell.joint_sets["notches"] = {4, 5, 6, 7};
    }

    void add_edges(UnitCell &cell)
    {
      // Tip i lies between the vertices i and i + 1: tip 0 between right and
      // top, and so on.
      for (unsigned int tip = 0; tip < 4; ++tip)
        for (const unsigned int vertex : {tip, (tip + 1) % 4})
          cell.struts.push_back({tip, first_vertex + vertex, 0., {"edges"}});
    }

    void set_period(UnitCell &cell, const StarShape &shape)
    {
      // With equal lengths, up to round-off, tips of neighbours are merged.
      const auto overlaps = [](const double depth, const double stub) {
        return depth - stub > 1e-9 * std::max(depth, stub);
      };
      if (overlaps(shape.side_depth, shape.horizontal_stub))
        cell.no_vector_reasons[0] = overlap_sentence("horizontal",
                                                     shape.side_depth,
                                                     shape.horizontal_stub);
      else
        cell.vectors[0][0] = cell.joints[cell.ports["right"][0]][0] -
          cell.joints[cell.ports["left"][0]][0];

      if (overlaps(shape.top_depth, shape.vertical_stub))
        cell.no_vector_reasons[1] =
          overlap_sentence("vertical", shape.top_depth, shape.vertical_stub);
      else
        cell.vectors[1][1] = cell.joints[cell.ports["top"][0]][1] -
          cell.joints[cell.ports["bottom"][0]][1];

      cell.no_vector_reasons[2] = "It is planar and has no Layer distance.";
    }
  } // namespace

  UnitCell build_star(const StarShape &shape)
  {
    UnitCell cell;
    add_edges(cell);
    add_joints(cell, shape);
    const unsigned int right = 4, top = 5, left = 6, bottom = 7;
    cell.pairs["in-cell"]   = {{top, bottom}};
    cell.pairs["in-cell x"] = {{left, right}};
    cell.pairs["rod"]       = {{top, cell.ports["bottom"][0]}};
    set_period(cell, shape);
    return cell;
  }

  std::unique_ptr<Cell> make_star_cell(const StarShape &shape)
  {
    return std::make_unique<StarCell>(shape);
  }

  namespace
  {
    const Quantity star_strut_length{"Strut length",
                                     "10 mm",
                                     "m",
                                     Range::positive(),
                                     "Length L of all 12 struts of the cell."};

    const Quantity star_opening_angle{
      "Opening angle",
      "60 deg",
      "deg",
      Range::positive(),
      "Angle theta0 of the upper and lower edges to the horizontal through the "
      "side vertices; more than 45 deg and at most 90 deg."};

    std::unique_ptr<Cell> make_star(ParameterValues &values)
    {
      const double length = values[star_strut_length];
      const double angle  = values[star_opening_angle];
      check_opening_angle({"star",
                           angle,
                           length,
                           length * (std::sin(angle) - std::cos(angle)),
                           "L (sin(theta0) - cos(theta0))",
                           "45 deg",
                           " For flatter edges choose the cell 'general "
                           "star', whose half width must only exceed "
                           "L cos(theta0)."},
                          values.context);

      const double tip   = length * std::sin(angle);
      const double depth = length * std::cos(angle);
      return make_star_cell({tip, tip, depth, depth, length, length});
    }
  } // namespace

  RegistryEntry<Cell> star_cell_entry()
  {
    return {"star",
            "Symmetric star of 12 struts of equal length: 8 edges between 4 "
            "tips and 4 re-entrant vertices, 4 stubs to the neighbour cells.",
            {star_strut_length, star_opening_angle},
            make_star};
  }

  namespace
  {
    const Quantity half_width{
      "Half width",
      "9 mm",
      "m",
      Range::positive(),
      "Distance w of the tips from the vertical through the cell's centre."};

    const Quantity half_height{
      "Half height",
      "9 mm",
      "m",
      Range::positive(),
      "Distance g of the tips from the horizontal through the cell's centre."};

    const Quantity side_depth{
      "Side notch depth",
      "5 mm",
      "m",
      Range::non_negative(),
      "Depth of the notches at the left and right side, L cos(theta0) for "
      "edges of length L at angle theta0; less than the half width."};

    const Quantity top_depth{
      "Top notch depth",
      "5 mm",
      "m",
      Range::non_negative(),
      "Depth of the notches at top and bottom; less than the half height."};

    const Quantity horizontal_stub{
      "Horizontal stub length",
      "10 mm",
      "m",
      Range::non_negative(),
      "Length of the stubs at the left and right side, 0 for none. Several "
      "cells along x need at least the side notch depth."};

    const Quantity vertical_stub{
      "Vertical stub length",
      "10 mm",
      "m",
      Range::non_negative(),
      "Length of the stubs at top and bottom, 0 for none. Several cells along "
      "y need at least the top notch depth."};

    /** Refuses a notch that reaches the centre. @p symbols is the inequality
     * extent > depth as a formula, @p explanation the meaning of the depth. */
    void check_notch(const Quantity     &extent_entry,
                     const double        extent,
                     const Quantity     &depth_entry,
                     const double        depth,
                     const std::string  &symbols,
                     const std::string  &explanation,
                     const SceneContext &context)
    {
      if (extent - depth > 1e-12 * extent)
        return;
      std::ostringstream text;
      text << context.path << ": the notches of the cell 'general star' cross "
           << "or meet in its centre. " << symbols
           << " fails: " << extent_entry.name << " = " << extent << " m, "
           << depth_entry.name << " = " << depth << " m" << explanation
           << ". Increase '" << extent_entry.name << "' or reduce '"
           << depth_entry.name << "'.";
      throw InputError(text.str());
    }

    void check_shape(const StarShape &shape, const SceneContext &context)
    {
      std::ostringstream edges;
      edges << " (edges of length L = "
            << std::hypot(shape.side_depth, shape.half_height)
            << " m at theta0 = "
            << std::atan2(shape.half_height, shape.side_depth) * 180. /
          dealii::numbers::PI
            << " deg)";
      check_notch(half_width,
                  shape.half_width,
                  side_depth,
                  shape.side_depth,
                  "w > L cos(theta0), the side notch depth,",
                  edges.str(),
                  context);
      check_notch(half_height,
                  shape.half_height,
                  top_depth,
                  shape.top_depth,
                  "g > top notch depth",
                  "",
                  context);
    }

    std::unique_ptr<Cell> make_general_star(ParameterValues &values)
    {
      const StarShape shape = {values[half_width],
                               values[half_height],
                               values[side_depth],
                               values[top_depth],
                               values[horizontal_stub],
                               values[vertical_stub]};
      check_shape(shape, values.context);
      return make_star_cell(shape);
    }
  } // namespace

  RegistryEntry<Cell> general_star_cell_entry()
  {
    return {"general star",
            "Star with independent half width, half height, notch depths and "
            "stub lengths, also with edges flatter than 45 deg.",
            {half_width,
             half_height,
             side_depth,
             top_depth,
             horizontal_stub,
             vertical_stub},
            make_general_star};
  }
} // namespace auxfem
