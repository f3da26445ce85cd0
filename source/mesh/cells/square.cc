#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>

namespace auxfem
{
  namespace
  {
    std::unique_ptr<Cell> make_square(ParameterValues &values)
    {
      const double           L = values[equal_strut_length()];
      CellDrawing            drawing(L);
      const dealii::Point<3> corners[] = {{0, 0, 0},
                                          {L, 0, 0},
                                          {L, L, 0},
                                          {0, L, 0}};
      for (unsigned int i = 0; i < 4; ++i)
        drawing.strut(corners[i],
                      corners[(i + 1) % 4],
                      i % 2 == 0 ? "horizontal" : "vertical");
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(L, L, 0)));
    }
  } // namespace

  RegistryEntry<Cell> square_cell_entry()
  {
    return {"square",
            "Square of four struts.",
            {equal_strut_length()},
            make_square};
  }
} // namespace auxfem
