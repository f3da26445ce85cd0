#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <vector>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

    const Quantity square_side{"Square side",
                               "10 mm",
                               "m",
                               Range::positive(),
                               "Side s of the squares."};
    const Quantity square_turn{"Turn angle",
                               "20 deg",
                               "deg",
                               Range::positive(),
                               "Angle by which a square is turned, to the left "
                               "and to the right in turn, from where its "
                               "diagonals are along the axes; below 45 deg."};
    const Quantity hinge_length{"Hinge length",
                                "1 mm",
                                "m",
                                Range::positive(),
                                "Length h of the struts that join corners."};

    /** Corners of a square: right, top, left, bottom. */
    std::vector<unsigned int> draw_square(const dealii::Point<3> &centre,
                                          const double            side,
                                          const double            turn,
                                          CellDrawing            &drawing)
    {
      std::vector<unsigned int> corners;
      for (unsigned int k = 0; k < 4; ++k)
        {
          const double angle = turn + k * PI / 2;
          corners.push_back(
            drawing.joint(centre[0] + side / std::sqrt(2.) * std::cos(angle),
                          centre[1] + side / std::sqrt(2.) * std::sin(angle)));
        }
      const unsigned int middle = drawing.joint(centre);
      for (unsigned int k = 0; k < 4; ++k)
        {
          drawing.strut(corners[k], corners[(k + 1) % 4], "edges");
          drawing.strut(middle, corners[k], "spokes");
        }
      return corners;
    }

    /** Squares at (i D, j D), i, j = 0, 1, D = sqrt(2) s cos(turn) + h, turned
     * to the left for even i + j, else to the right. */
    std::unique_ptr<Cell> make_rotating_squares(ParameterValues &values)
    {
      const double side = values[square_side], turn = values[square_turn];
      if (!(turn < PI / 4))
        values.refuse(square_turn,
                      "neighbours would meet along their sides. Give less "
                      "than 45 deg");
      const double D =
        std::sqrt(2.) * side * std::cos(turn) + values[hinge_length];
      CellDrawing drawing(D);
      const auto  square = [&](const unsigned int i, const unsigned int j) {
        return draw_square(dealii::Point<3>(i * D, j * D, 0),
                           side,
                           (i + j) % 2 == 0 ? turn : -turn,
                           drawing);
      };
      const auto low_left = square(0, 0), low_right = square(1, 0),
                 high_left = square(0, 1), high_right = square(1, 1);
      enum Corner
      {
        right,
        top,
        left,
        bottom
      };
      drawing.strut(low_left[right], low_right[left], "hinges");
      drawing.strut(high_left[right], high_right[left], "hinges");
      drawing.strut(low_left[top], high_left[bottom], "hinges");
      drawing.strut(low_right[top], high_right[bottom], "hinges");
      const std::array<int, 3> along_x = {{1, 0, 0}}, along_y = {{0, 1, 0}};
      drawing.strut_across(low_right[right], low_left[left], along_x, "hinges");
      drawing.strut_across(high_right[right],
                           high_left[left],
                           along_x,
                           "hinges");
      drawing.strut_across(high_left[top], low_left[bottom], along_y, "hinges");
      drawing.strut_across(high_right[top],
                           low_right[bottom],
                           along_y,
                           "hinges");
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(2 * D, 2 * D, 0)));
    }
  } // namespace

  RegistryEntry<Cell> rotating_squares_cell_entry()
  {
    return {"rotating squares",
            "Four squares with spokes, joined at their corners by short "
            "struts; auxetic. Rigid squares: Rigid parts with Struts = edges "
            "+ spokes.",
            {square_side, square_turn, hinge_length},
            make_rotating_squares};
  }
} // namespace auxfem
