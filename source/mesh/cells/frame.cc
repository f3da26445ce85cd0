#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/mesh/cells/frame_text.h>

namespace auxfem
{
  namespace
  {
    std::unique_ptr<Cell> make_frame(ParameterValues &values)
    {
      UnitCell cell = read_frame(values, "frame");
      merge_joints_of_frame(values, cell);
      cell.no_vector_reasons.fill(
        "A frame has no neighbour cells; Cell = pattern repeats one.");
      return std::make_unique<PrebuiltCell>(cell);
    }
  } // namespace

  RegistryEntry<Cell> frame_cell_entry()
  {
    return {"frame",
            "Frame of arbitrary joints and straight or circular struts.",
            frame_parameters(),
            make_frame};
  }
} // namespace auxfem
