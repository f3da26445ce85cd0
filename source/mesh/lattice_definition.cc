#include <auxfem/mesh/lattice_definition.h>

namespace auxfem
{
  namespace
  {
    Choice cell_choice()
    {
      return {"Cell", "", names_of(cell_registry()), "Kind of unit cell."};
    }

    const Integer cells_x = {"Cells x",
                             1,
                             1,
                             100000,
                             "Number of unit cells along x."};
    const Integer cells_y = {"Cells y",
                             1,
                             1,
                             100000,
                             "Number of unit cells along y."};
    const Integer cells_z = {"Cells z",
                             1,
                             1,
                             100000,
                             "Number of unit cells or layers along z; more "
                             "than 1 only with Dimension = 3."};

    const Quantity layer_distance = {
      "Layer distance",
      "0 m",
      "m",
      Range::non_negative(),
      "Distance of the layers of a planar cell along z, joined by straight "
      "struts (set \"columns\"); 0: not repeated along z. Only with "
      "Dimension = 3."};

    const Text columns_at = {
      "Columns at",
      "all",
      "Joints of the cell at which these struts stand: sets of joints or sides "
      "of the cell joined by +, or all; only with a Layer distance."};

    const Boolean struts_may_cross = {
      "Struts may cross",
      false,
      "Whether struts may pass through each other, as those that lie side by "
      "side across the plane may; else the verdict tells when they do."};

    /** The chosen cell, repeated along z at the layer distance if there is one.
     */
    std::shared_ptr<const Cell> read_cell(ParameterValues &values)
    {
      std::unique_ptr<Cell> cell =
        find_entry(cell_registry(), values[cell_choice()]).make(values);
      const double      distance = values[layer_distance];
      const std::string columns  = values[columns_at];
      if (distance > 0)
        return std::make_shared<GivenCell>(
          extrude(cell->build(), distance, columns, values.context.path));
      if (columns != columns_at.default_value)
        values.refuse(columns_at,
                      "there are no layers for columns to join. Remove "
                      "it or give a Layer distance");
      return cell;
    }
  } // namespace



  SubsectionSchema lattice_schema()
  {
    return {"Lattice",
            SubsectionSchema::Form::fixed,
            "The array of unit cells.",
            {cell_choice(),
             cells_x,
             cells_y,
             cells_z,
             layer_distance,
             columns_at,
             struts_may_cross},
            "Cell",
            variants_of(cell_registry())};
  }



  LatticeDefinition read_lattice(ParameterValues &values)
  {
    if (values[cells_z] > 1)
      require_space(values, cells_z);
    if (values[layer_distance] > 0)
      require_space(values, layer_distance);
    return {read_cell(values),
            {{values[cells_x], values[cells_y], values[cells_z]}},
            values[struts_may_cross]};
  }
} // namespace auxfem
