#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/mesh/cells/star_shape.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
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
