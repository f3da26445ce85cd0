#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Corner @p i (0 to 7) of a cube with the edge @p a. */
    dealii::Point<3> corner_of_cube(const unsigned int i, const double a)
    {
      return {i % 2 * a, i / 2 % 2 * a, i / 4 * a};
    }

    /** Middle of the face @p i (0 to 5) of a cube. */
    dealii::Point<3> middle_of_face(const unsigned int i, const double a)
    {
      dealii::Point<3> middle(a / 2, a / 2, a / 2);
      middle[i / 2] = i % 2 * a;
      return middle;
    }

    UnitCell repeated_cube(const CellDrawing &drawing, const double a)
    {
      return drawing.repeated(dealii::Point<3>(a, a, a));
    }

    std::unique_ptr<Cell> make_cubic(ParameterValues &values)
    {
      require_space("cubic", values.context);
      const double L = values[equal_strut_length()];
      CellDrawing  drawing(L);
      for (unsigned int i = 0; i < 8; ++i)
        for (unsigned int d = 0; d < 3; ++d)
          if (!(i >> d & 1))
            drawing.strut(corner_of_cube(i, L),
                          corner_of_cube(i + (1 << d), L),
                          std::string("along ") + "xyz"[d]);
      return std::make_unique<PrebuiltCell>(repeated_cube(drawing, L));
    }

    std::unique_ptr<Cell> make_body_centred(ParameterValues &values)
    {
      require_space("body-centred cubic", values.context);
      const double L = values[equal_strut_length()], a = 2 * L / std::sqrt(3.);
      CellDrawing  drawing(L);
      for (unsigned int i = 0; i < 8; ++i)
        drawing.strut(corner_of_cube(i, a), {a / 2, a / 2, a / 2}, "diagonals");
      return std::make_unique<PrebuiltCell>(repeated_cube(drawing, a));
    }

    /** Struts from the corners of a cube to the middles of its faces. */
    void draw_face_diagonals(const double a, CellDrawing &drawing)
    {
      for (unsigned int face = 0; face < 6; ++face)
        for (unsigned int i = 0; i < 8; ++i)
          if ((i >> face / 2 & 1) == face % 2)
            drawing.strut(corner_of_cube(i, a),
                          middle_of_face(face, a),
                          "diagonals");
    }

    std::unique_ptr<Cell> make_face_centred(ParameterValues &values)
    {
      require_space("face-centred cubic", values.context);
      const double a = std::sqrt(2.) * values[equal_strut_length()];
      CellDrawing  drawing(a);
      draw_face_diagonals(a, drawing);
      return std::make_unique<PrebuiltCell>(repeated_cube(drawing, a));
    }

    std::unique_ptr<Cell> make_octet(ParameterValues &values)
    {
      require_space("octet", values.context);
      const double a = std::sqrt(2.) * values[equal_strut_length()];
      CellDrawing  drawing(a);
      draw_face_diagonals(a, drawing);
      // The octahedron between the middles of the faces.
      for (unsigned int one = 0; one < 6; ++one)
        for (unsigned int other = one + 1; other < 6; ++other)
          if (one / 2 != other / 2)
            drawing.strut(middle_of_face(one, a),
                          middle_of_face(other, a),
                          "octahedra");
      return std::make_unique<PrebuiltCell>(repeated_cube(drawing, a));
    }
  } // namespace

  RegistryEntry<Cell> cubic_cell_entry()
  {
    return {"cubic",
            "Cube of twelve struts (Dimension = 3).",
            {equal_strut_length()},
            make_cubic};
  }

  RegistryEntry<Cell> body_centred_cell_entry()
  {
    return {"body-centred cubic",
            "Struts from the centre of a cube to its corners (Dimension = 3).",
            {equal_strut_length()},
            make_body_centred};
  }

  RegistryEntry<Cell> face_centred_cell_entry()
  {
    return {"face-centred cubic",
            "Diagonals of the faces of a cube (Dimension = 3).",
            {equal_strut_length()},
            make_face_centred};
  }

  RegistryEntry<Cell> octet_cell_entry()
  {
    return {"octet",
            "Tetrahedra and octahedra: the face-centred cubic cell with "
            "struts between the middles of its faces (Dimension = 3).",
            {equal_strut_length()},
            make_octet};
  }
} // namespace auxfem
