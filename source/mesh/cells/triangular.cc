#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Two rows of equilateral triangles. */
    std::unique_ptr<Cell> make_triangular(ParameterValues &values)
    {
      const double       L = values[equal_strut_length()];
      const double       h = std::sqrt(3.) / 2 * L;
      CellDrawing        drawing(L);
      const unsigned int middle = drawing.joint(L / 2, h);
      for (const double y : {0., 2 * h})
        {
          const unsigned int left  = drawing.joint(0, y),
                             right = drawing.joint(L, y);
          drawing.strut(left, right, "horizontal");
          drawing.strut(left, middle, "inclined");
          drawing.strut(right, middle, "inclined");
        }
      drawing.strut_across(middle, middle, {{1, 0, 0}}, "horizontal");
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(L, 2 * h, 0)));
    }

    /** Two rows of triangles that meet at their corners only. */
    std::unique_ptr<Cell> make_kagome(ParameterValues &values)
    {
      const double L = values[equal_strut_length()];
      const double h = std::sqrt(3.) / 2 * L;
      CellDrawing  drawing(L);
      unsigned int triangle[2][3];
      for (unsigned int row = 0; row < 2; ++row)
        {
          const double x = row * L, y = row * 2 * h;
          triangle[row][0] = drawing.joint(x, y);
          triangle[row][1] = drawing.joint(x + L, y);
          triangle[row][2] = drawing.joint(x + L / 2, y + h);
          drawing.strut(triangle[row][0], triangle[row][1], "horizontal");
          drawing.strut(triangle[row][1], triangle[row][2], "inclined");
          drawing.strut(triangle[row][2], triangle[row][0], "inclined");
          drawing.strut_across(triangle[row][1],
                               triangle[row][0],
                               {{1, 0, 0}},
                               "horizontal");
        }
      // From the tops to the corners of the row above.
      drawing.strut(triangle[0][2], triangle[1][0], "inclined");
      drawing.strut_across(triangle[1][1],
                           triangle[0][2],
                           {{1, 0, 0}},
                           "inclined");
      drawing.strut_across(triangle[1][2],
                           triangle[0][0],
                           {{1, 1, 0}},
                           "inclined");
      drawing.strut_across(triangle[1][2],
                           triangle[0][1],
                           {{0, 1, 0}},
                           "inclined");
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(2 * L, 4 * h, 0)));
    }
  } // namespace

  RegistryEntry<Cell> triangular_cell_entry()
  {
    return {"triangular",
            "Equilateral triangles, two rows of them.",
            {equal_strut_length()},
            make_triangular};
  }

  RegistryEntry<Cell> kagome_cell_entry()
  {
    return {"kagome",
            "Equilateral triangles that meet at their corners, two rows of "
            "them.",
            {equal_strut_length()},
            make_kagome};
  }
} // namespace auxfem
