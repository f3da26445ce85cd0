#include <auxfem/mesh/cells/entries.h>
#include <auxfem/mesh/cells/opening_angle.h>
#include <auxfem/mesh/cells/star_shape.h>

#include <cmath>

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
} // namespace auxfem
