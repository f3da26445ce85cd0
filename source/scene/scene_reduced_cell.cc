#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_sections.h>

namespace auxfem
{
  namespace
  {
    const Quantity bar_length = {"Bar length",
                                 "0.5 m",
                                 "m",
                                 Range::positive(),
                                 "Length L1 of each of the four bars."};
    const Quantity angle      = {
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

    void read_reduced_cell(dealii::ParameterHandler &prm,
                           const std::string &,
                           const SceneContext &context,
                           Scene              &scene)
    {
      ReducedCellDefinition cell;
      cell.bar_length = get(prm, bar_length);
      cell.angle      = get(prm, angle);
      cell.bar_mass   = get(prm, bar_mass);
      cell.part_mass =
        is_word(prm, part_mass) ? 3 * cell.bar_mass : get(prm, part_mass);
      cell.load = read_time_function(prm, load, context);
      cell.path = context.path;
      if (cell.bar_mass == 0 && cell.part_mass == 0)
        throw InputError(context.path +
                         ": Bar mass and Part mass are both 0, so that nothing "
                         "resists acceleration. Give at least one of them");
      scene.reduced_cell = cell;
    }
  } // namespace



  SubsectionKind reduced_cell_kind()
  {
    return {"Reduced cell",
            SubsectionKind::Form::fixed,
            "The star cell of rigid parts, loaded from above; only with Model "
            "= reduced cell, which also uses Connectors (exactly one), Time, "
            "Newton and Output.",
            [](dealii::ParameterHandler &prm) {
              declare(prm, bar_length);
              declare(prm, angle);
              declare(prm, bar_mass);
              declare(prm, part_mass);
              declare(prm, load);
            },
            "",
            {},
            read_reduced_cell,
            {Model::reduced_cell}};
  }
} // namespace auxfem
