#include <auxfem/mesh/lattice_definition.h>

namespace auxfem
{
  SubsectionSchema sets_schema()
  {
    return {"Sets",
            SubsectionSchema::Form::free_entries,
            "Sets of joints or struts: \"joints: \" or \"struts: \" followed "
            "by set names joined by +, by numbers, by \"nearest: x, y\" (in "
            "space \"nearest: x, y, z\") or by a condition in x, y and z (m), "
            "e.g. joints: y > ymax - 1e-6."};
  }



  SetDefinition read_set(ParameterValues &values)
  {
    return {values.name(), text_of_free_entry(values), values.context.path};
  }

  namespace
  {
    Choice cell_choice()
    {
      return {"Cell", "", names_of(cell_registry()), "Kind of unit cell."};
    }

    template <class Map>
    std::string listed(const std::string &heading, const Map &map)
    {
      std::string names;
      for (const auto &item : map)
        names += (names.empty() ? "" : ", ") + item.first;
      return names.empty() ? "" : " " + heading + ": " + names + ".";
    }

    /** Sentences on the sets and pairs of a cell of the kind @p entry. */
    std::string set_names(const RegistryEntry<Cell> &entry)
    {
      for (const Parameter &parameter : entry.parameters)
        if (parameter.required)
          return "";
      SceneContext context;
      context.dimension = 3;
      ParameterValues values(entry.parameters, context);
      const UnitCell  cell = entry.make(values)->build();

      std::map<std::string, bool> strut_sets, pairs;
      for (const UnitStrut &strut : cell.struts)
        for (const std::string &set : strut.sets)
          strut_sets[set] = true;
      for (const StrutsAcross &across : cell.struts_across)
        strut_sets[across.set] = true;
      for (const auto &set : cell.pairs)
        pairs[set.first] = true;
      for (const auto &set : cell.pairs_across)
        pairs[set.first] = true;
      return listed("Sets of joints", cell.joint_sets) +
        listed("Sets of struts", strut_sets) +
        listed("Pairs for connectors", pairs);
    }

    std::vector<SubsectionVariant> cell_variants()
    {
      std::vector<SubsectionVariant> variants = variants_of(cell_registry());
      for (SubsectionVariant &variant : variants)
        variant.sentence +=
          set_names(find_entry(cell_registry(), variant.name));
      return variants;
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
                             "Number of unit cells or layers along z; above 1 "
                             "only with Dimension = 3."};

    const Quantity layer_distance = {
      "Layer distance",
      "0 m",
      "m",
      Range::non_negative(),
      "Distance of layers of a planar cell along z, joined by straight struts "
      "(set \"columns\"); 0: one layer. Only with Dimension = 3."};

    const Text interlayer_joints = {
      "Interlayer joints",
      "all",
      "Joints of the cell that these struts connect: sets of joints or sides of "
      "the cell joined by +, or all. Only with a Layer distance."};

    const Boolean struts_may_cross = {
      "Struts may cross",
      false,
      "Whether struts may pass through each other, e.g. because they lie side by "
      "side; otherwise the verdict reports it."};

    /** Reads the cell, in layers along z if there is a layer distance. */
    std::shared_ptr<const Cell> read_cell(ParameterValues &values)
    {
      std::unique_ptr<Cell> cell =
        find_entry(cell_registry(), values[cell_choice()]).make(values);
      const double      distance = values[layer_distance];
      const std::string columns  = values[interlayer_joints];
      if (distance > 0)
        return std::make_shared<PrebuiltCell>(
          extrude(cell->build(), distance, columns, values.context.path));
      if (columns != interlayer_joints.default_value)
        values.refuse(interlayer_joints,
                      "there are no layers for columns to join. Remove "
                      "it or give a Layer distance");
      return cell;
    }
  } // namespace



  SubsectionSchema lattice_schema()
  {
    Parameters parameters = {cell_choice(),
                             cells_x,
                             cells_y,
                             cells_z,
                             layer_distance,
                             interlayer_joints,
                             struts_may_cross};
    for (const Parameter &parameter : array_change_parameters())
      parameters.push_back(parameter);
    return {
      "Lattice",
      SubsectionSchema::Form::fixed,
      "Array of unit cells. In addition to the sets of the cell it has the "
      "joint sets all, left, right, bottom, top, in space back and front, "
      "and the strut sets all and, with a Layer distance, columns.",
      parameters,
      "Cell",
      cell_variants()};
  }



  LatticeDefinition read_lattice(ParameterValues &values)
  {
    if (values[cells_z] > 1)
      require_space(values, cells_z);
    if (values[layer_distance] > 0)
      require_space(values, layer_distance);
    return {read_cell(values),
            {{values[cells_x], values[cells_y], values[cells_z]}},
            read_array_changes(values),
            values[struts_may_cross],
            false};
  }
} // namespace auxfem
