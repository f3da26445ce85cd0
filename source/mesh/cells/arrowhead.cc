#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity arrowhead_half_width{"Half width",
                                        "10 mm",
                                        "m",
                                        Range::positive(),
                                        "Half the width w of an arrowhead."};
    const Quantity arrowhead_long_angle{"Long angle",
                                        "60 deg",
                                        "deg",
                                        Range::positive(),
                                        "Angle of the long struts to the "
                                        "horizontal, below 90 deg."};
    const Quantity arrowhead_short_angle{"Short angle",
                                         "30 deg",
                                         "deg",
                                         Range::positive(),
                                         "Angle of the short struts to the "
                                         "horizontal, below the long angle."};

    std::unique_ptr<Cell> make_arrowhead(ParameterValues &values)
    {
      const double w           = values[arrowhead_half_width],
                   long_angle  = values[arrowhead_long_angle],
                   short_angle = values[arrowhead_short_angle];
      if (!(long_angle < dealii::numbers::PI_2))
        values.refuse(arrowhead_long_angle,
                      "the long struts are not inclined. Give less than 90 "
                      "deg");
      if (!(short_angle < (1 - 1e-12) * long_angle))
        values.refuse(arrowhead_short_angle,
                      "the arrowhead has no height. Give less than Long "
                      "angle = " +
                        values.text(arrowhead_long_angle));
      const double high = w * std::tan(long_angle),
                   low  = w * std::tan(short_angle);
      CellDrawing drawing(w + high);
      for (const double side : {-w, w})
        {
          drawing.strut({side, 0, 0}, {0, high, 0}, "long");
          drawing.strut({side, 0, 0}, {0, low, 0}, "short");
        }
      drawing.cell.joint_sets["wings"] = {drawing.joint(-w, 0),
                                          drawing.joint(w, 0)};
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(2 * w, high - low, 0)));
    }
  } // namespace

  RegistryEntry<Cell> arrowhead_cell_entry()
  {
    return {"double arrowhead",
            "Auxetic arrowhead of two long and two short struts.",
            {arrowhead_half_width, arrowhead_long_angle, arrowhead_short_angle},
            make_arrowhead};
  }
} // namespace auxfem
