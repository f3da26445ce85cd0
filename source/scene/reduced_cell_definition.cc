#include <auxfem/loads/motion_parameters.h>
#include <auxfem/scene/reduced_cell_definition.h>

namespace auxfem
{
  namespace
  {
    const Quantity cell_bar_length = {"Bar length",
                                      "0.5 m",
                                      "m",
                                      Range::positive(),
                                      "Length L1 of each of the four bars."};
    const Quantity cell_angle      = {
           "Angle",
           "30 deg",
           "deg",
           Range::open(0, 90),
           "Angle theta0 of the bars against the horizontal at rest; at 0 and 90 "
                "degrees there is no cell."};
    const Quantity       bar_mass  = {"Bar mass",
                                      "",
                                      "kg",
                                      Range::non_negative(),
                                      "Mass m1 of each bar."};
    const Quantity       part_mass = {"Part mass",
                                      "auto",
                                      "kg",
                                      Range::non_negative(),
                                      "Mass m2 of the upper and of the lower "
                                            "part; auto: 3 m1, three beams like the "
                                            "bars.",
                                      {"auto"}};
    const TimeExpression load      = {"Load",
                                      "",
                                      "N",
                                      "Force f1 that pushes the upper part down."};
  } // namespace



  SubsectionSchema reduced_cell_schema()
  {
    return {"Reduced cell",
            SubsectionSchema::Form::fixed,
            "The star cell of rigid parts, loaded from above; only with Model "
            "= reduced cell, which also uses Connectors (exactly one), Time, "
            "Newton and Output.",
            {cell_bar_length, cell_angle, bar_mass, part_mass, load},
            "",
            {},
            {Model::reduced_cell}};
  }



  ReducedCellDefinition read_reduced_cell(ParameterValues &values)
  {
    ReducedCellDefinition cell;
    cell.bar_length = values[cell_bar_length];
    cell.angle      = values[cell_angle];
    cell.bar_mass   = values[bar_mass];
    cell.part_mass  = values.value_or(part_mass, 3 * cell.bar_mass);
    cell.load       = read_time_function(values, load);
    cell.path       = values.context.path;
    if (cell.bar_mass == 0 && cell.part_mass == 0)
      values.refuse("Bar mass and Part mass are both 0, so that nothing "
                    "resists acceleration. Give at least one of them");
    return cell;
  }
} // namespace auxfem
