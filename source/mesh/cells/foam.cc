#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace auxfem
{
  namespace
  {
    /** Corners of a truncated octahedron in a cube with the edge @p a: the
     * permutations of (0, +-1/4, +-1/2) a about its centre. */
    std::vector<dealii::Point<3>> corners_of_kelvin_cell(const double a)
    {
      std::vector<dealii::Point<3>> corners;
      for (const double quarter : {-0.25, 0.25})
        for (const double half : {-0.5, 0.5})
          for (unsigned int zero = 0; zero < 3; ++zero)
            for (const unsigned int order : {1, 2})
              {
                dealii::Point<3> corner(a / 2, a / 2, a / 2);
                corner[(zero + order) % 3] += quarter * a;
                corner[(zero + 3 - order) % 3] += half * a;
                corners.push_back(corner);
              }
      return corners;
    }

    std::unique_ptr<Cell> make_kelvin(ParameterValues &values)
    {
      require_space("Kelvin", values.context);
      const double L = values[equal_strut_length()], a = 2 * std::sqrt(2.) * L;
      CellDrawing  drawing(a);
      const auto   corners = corners_of_kelvin_cell(a);
      for (const auto &one : corners)
        for (const auto &other : corners)
          if (std::abs(one.distance(other) - L) < 1e-6 * L)
            drawing.strut(one, other, "edges");
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(a, a, a)));
    }

    std::unique_ptr<Cell> make_diamond(ParameterValues &values)
    {
      require_space("diamond", values.context);
      const double L = values[equal_strut_length()], a = 4 * L / std::sqrt(3.);
      CellDrawing  drawing(a);
      // Four joints inside, each joined to a corner of the cube and three
      // middles of faces: at (1, 1, 1) a / 4, and with two signs changed.
      for (unsigned int i = 0; i < 4; ++i)
        {
          dealii::Tensor<1, 3> sign({1, 1, 1});
          for (unsigned int d = 0; d < 3; ++d)
            if (i > 0 && d != i - 1)
              sign[d] = -1;
          const dealii::Point<3> centre(a / 2, a / 2, a / 2),
            inside = centre - a / 4 * sign;
          drawing.strut(inside, centre - a / 2 * sign, "struts");
          for (unsigned int d = 0; d < 3; ++d)
            {
              dealii::Point<3> face = centre;
              face[d] -= a / 2 * sign[d];
              drawing.strut(inside, face, "struts");
            }
        }
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(a, a, a)));
    }
  } // namespace

  RegistryEntry<Cell> kelvin_cell_entry()
  {
    return {"Kelvin",
            "Edges of truncated octahedra, the foam of Kelvin (Dimension = 3).",
            {equal_strut_length()},
            make_kelvin};
  }

  RegistryEntry<Cell> diamond_cell_entry()
  {
    return {"diamond",
            "Joints of four struts each, as the atoms of diamond (Dimension = "
            "3).",
            {equal_strut_length()},
            make_diamond};
  }
} // namespace auxfem
