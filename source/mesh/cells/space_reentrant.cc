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
    const Quantity space_reentrant_vertical{"Vertical length",
                                            "20 mm",
                                            "m",
                                            Range::positive(),
                                            "Length H of the vertical struts."};
    const Quantity space_reentrant_oblique{"Oblique length",
                                           "12 mm",
                                           "m",
                                           Range::positive(),
                                           "Length L of the oblique struts."};
    const Quantity space_reentrant_angle{
      "Oblique angle",
      "60 deg",
      "deg",
      Range::positive(),
      "Angle of the oblique struts to the vertical ones, between which they "
      "point back; below 90 deg, and H > 2 L cos(angle)."};

    void check_space_reentrant(const ParameterValues &values)
    {
      if (!(values[space_reentrant_angle] < dealii::numbers::PI_2))
        values.refuse(space_reentrant_angle,
                      "the oblique struts do not point back. Give less than 90 "
                      "deg");
      const double H     = values[space_reentrant_vertical],
                   depth = 2 * values[space_reentrant_oblique] *
        std::cos(values[space_reentrant_angle]);
      if (H > (1 + 1e-12) * depth)
        return;
      std::ostringstream text;
      text.precision(4);
      text << "the oblique struts of the cell meet or cross: H > 2 L "
              "cos(angle) fails with "
           << H << " m and " << depth
           << " m. Increase it, or reduce Oblique length";
      values.refuse(space_reentrant_vertical, text.str());
    }

    /**
     * Vertical struts from a joint to one above it, from which four oblique
     * struts lead down to the lower joints at (+-s, 0, h) and (0, +-s, h) from
     * its own, s = L sin(angle), h = H - L cos(angle). There are lower joints
     * at (i s, j s, k h) with even i + j + k, four of them in a cell.
     */
    std::unique_ptr<Cell> make_space_reentrant(ParameterValues &values)
    {
      require_space("space re-entrant", values.context);
      check_space_reentrant(values);
      const double H     = values[space_reentrant_vertical],
                   L     = values[space_reentrant_oblique],
                   angle = values[space_reentrant_angle],
                   s = L * std::sin(angle), h = H - L * std::cos(angle);
      CellDrawing  drawing(H + L);
      unsigned int low[2][2], high[2][2];
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          {
            const dealii::Point<3> foot(i * s, j * s, (i + j) % 2 * h);
            low[i][j]  = drawing.joint(foot);
            high[i][j] = drawing.joint(foot + dealii::Point<3>(0, 0, H));
            drawing.strut(low[i][j], high[i][j], "vertical");
          }
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          for (const auto &[to_i, to_j] :
               {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
            {
              const int          at[] = {int(i) + to_i,
                                         int(j) + to_j,
                                         int((i + j) % 2) + 1};
              std::array<int, 3> shift;
              for (unsigned int d = 0; d < 3; ++d)
                shift[d] = at[d] >= 0 ? at[d] / 2 : -1;
              const unsigned int target = low[(at[0] + 2) % 2][(at[1] + 2) % 2];
              if (shift == std::array<int, 3>{{0, 0, 0}})
                drawing.strut(high[i][j], target, "oblique");
              else
                drawing.strut_across(high[i][j], target, shift, "oblique");
            }
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(2 * s, 2 * s, 2 * h)));
    }
  } // namespace

  RegistryEntry<Cell> space_reentrant_cell_entry()
  {
    return {"space re-entrant",
            "Auxetic cell of vertical struts and oblique ones that point back "
            "(Dimension = 3).",
            {space_reentrant_vertical,
             space_reentrant_oblique,
             space_reentrant_angle},
            make_space_reentrant};
  }
} // namespace auxfem
