#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Walls of length @p h along y and @p l at @p angle to the x axis,
     * negative if they point inwards. Two rows of whole hexagons. */
    UnitCell build_hexagons(const double h, const double l, const double angle)
    {
      const double c = l * std::cos(angle), s = l * std::sin(angle);
      CellDrawing  drawing(h + l);
      for (unsigned int row = 0; row < 2; ++row)
        {
          // Lower end of the wall between this hexagon and the next one.
          const double           x = row * c, y = row * (h + s);
          const dealii::Point<3> corners[] = {{x, y, 0},
                                              {x + c, y - s, 0},
                                              {x + 2 * c, y, 0},
                                              {x + 2 * c, y + h, 0},
                                              {x + c, y + h + s, 0},
                                              {x, y + h, 0}};
          for (unsigned int i = 0; i < 6; ++i)
            drawing.strut(corners[i],
                          corners[(i + 1) % 6],
                          i % 3 == 2 ? "vertical" : "inclined");
        }
      return drawing.repeated(dealii::Point<3>(2 * c, 2 * (h + s), 0));
    }

    const Quantity hexagon_vertical{"Vertical length",
                                    "10 mm",
                                    "m",
                                    Range::positive(),
                                    "Length h of the vertical walls."};
    const Quantity hexagon_inclined{"Inclined length",
                                    "10 mm",
                                    "m",
                                    Range::positive(),
                                    "Length l of the inclined walls."};
    const Quantity hexagon_angle{"Wall angle",
                                 "30 deg",
                                 "deg",
                                 Range::positive(),
                                 "Angle of the inclined walls to the "
                                 "horizontal, below 90 deg."};

    void refuse_upright(const ParameterValues &values, const Quantity &angle)
    {
      if (!(values[angle] < dealii::numbers::PI_2))
        values.refuse(angle,
                      "the inclined walls are not inclined. Give less than 90 "
                      "deg");
    }

    std::unique_ptr<Cell> make_hexagonal(ParameterValues &values)
    {
      refuse_upright(values, hexagon_angle);
      return std::make_unique<PrebuiltCell>(
        build_hexagons(values[hexagon_vertical],
                       values[hexagon_inclined],
                       values[hexagon_angle]));
    }

    const Quantity reentrant_vertical{"Vertical length",
                                      "20 mm",
                                      "m",
                                      Range::positive(),
                                      "Length h of the vertical walls."};
    const Quantity reentrant_angle{"Wall angle",
                                   "30 deg",
                                   "deg",
                                   Range::positive(),
                                   "Angle of the inclined walls to the "
                                   "horizontal, by which they point inwards; "
                                   "below 90 deg, and h > 2 l sin(angle)."};

    std::unique_ptr<Cell> make_reentrant(ParameterValues &values)
    {
      refuse_upright(values, reentrant_angle);
      const double h = values[reentrant_vertical], l = values[hexagon_inclined],
                   angle = values[reentrant_angle],
                   depth = 2 * l * std::sin(angle);
      if (!(h > (1 + 1e-12) * depth))
        {
          std::ostringstream text;
          text.precision(4);
          text << "the inclined walls of the cell meet or cross: h > 2 l "
                  "sin(angle) fails with "
               << h << " m and " << depth
               << " m. Increase it, or reduce Inclined length or Wall angle";
          values.refuse(reentrant_vertical, text.str());
        }
      return std::make_unique<PrebuiltCell>(build_hexagons(h, l, -angle));
    }
  } // namespace

  RegistryEntry<Cell> hexagonal_cell_entry()
  {
    return {"hexagonal",
            "Honeycomb of hexagons with two vertical walls, two rows of them.",
            {hexagon_vertical, hexagon_inclined, hexagon_angle},
            make_hexagonal};
  }

  RegistryEntry<Cell> reentrant_cell_entry()
  {
    return {"re-entrant",
            "Auxetic honeycomb of hexagons whose inclined walls point inwards, "
            "two rows of them.",
            {reentrant_vertical, hexagon_inclined, reentrant_angle},
            make_reentrant};
  }
} // namespace auxfem
