#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_sections.h>
#include <auxfem/scene/scene_space.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;

    template <class Product>
    std::vector<SubsectionVariant>
    variants_of(const Registry<Product> &registry)
    {
      std::vector<SubsectionVariant> variants;
      for (const RegistryEntry<Product> &entry : registry)
        variants.push_back({entry.name, entry.description, entry.declare});
      return variants;
    }

    std::vector<std::string>
    names_of(const std::vector<SubsectionVariant> &variants)
    {
      std::vector<std::string> names;
      for (const SubsectionVariant &variant : variants)
        names.push_back(variant.name);
      return names;
    }

    template <class Product>
    const RegistryEntry<Product> &find(const Registry<Product> &registry,
                                       const std::string       &name)
    {
      return *std::find_if(registry.begin(),
                           registry.end(),
                           [&name](const RegistryEntry<Product> &entry) {
                             return entry.name == name;
                           });
    }

    // Lattice

    Choice cell_choice()
    {
      return {"Cell",
              "",
              names_of(variants_of(cell_registry())),
              "Kind of unit cell."};
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

    /** In the plane there is one layer of no thickness. */
    void refuse_layers(dealii::ParameterHandler &prm,
                       const SceneContext       &context)
    {
      if (get(prm, cells_z) > 1)
        refuse_in_plane(prm, cells_z.name, context, "Remove it");
      if (get(prm, layer_distance) > 0)
        refuse_in_plane(prm, layer_distance.name, context, "Remove it");
    }

    /** The chosen cell, repeated along z at the layer distance if there is one.
     */
    std::shared_ptr<const Cell> read_cell(dealii::ParameterHandler &prm,
                                          const SceneContext       &context)
    {
      std::unique_ptr<Cell> cell =
        find(cell_registry(), get(prm, cell_choice())).make(prm, context);
      const double      distance = get(prm, layer_distance);
      const std::string columns  = get(prm, columns_at);
      if (distance > 0)
        return std::make_shared<GivenCell>(
          extrude(cell->build(), distance, columns, context.path));
      if (columns != columns_at.default_value)
        throw InputError(context.path + "/" + columns_at.name + " = " +
                         columns +
                         ": there are no layers for columns to join. Remove "
                         "it or give a Layer distance");
      return cell;
    }

    void read_lattice(dealii::ParameterHandler &prm,
                      const std::string &,
                      const SceneContext &context,
                      Scene              &scene)
    {
      if (context.dimension == 2)
        refuse_layers(prm, context);
      scene.n_cells = {
        {get(prm, cells_x), get(prm, cells_y), get(prm, cells_z)}};
      scene.cell             = read_cell(prm, context);
      scene.struts_may_cross = get(prm, struts_may_cross);
    }

    SubsectionKind lattice_kind()
    {
      return {"Lattice",
              Form::fixed,
              "The array of unit cells.",
              [](dealii::ParameterHandler &prm) {
                declare(prm, cell_choice());
                declare(prm, cells_x);
                declare(prm, cells_y);
                declare(prm, cells_z);
                declare(prm, layer_distance);
                declare(prm, columns_at);
                declare(prm, struts_may_cross);
              },
              "Cell",
              variants_of(cell_registry()),
              read_lattice};
    }

    // Sets

    SubsectionKind sets_kind()
    {
      return {
        "Sets",
        Form::free_entries,
        "Sets of joints or struts: \"joints: \" or \"struts: \" followed "
        "by set names joined by +, by numbers, by \"nearest: x, y\" (in "
        "space \"nearest: x, y, z\") or by a condition in x, y and z (m), "
        "e.g. joints: y > ymax - 1e-6.",
        {},
        "",
        {},
        [](dealii::ParameterHandler &prm,
           const std::string        &name,
           const SceneContext       &context,
           Scene                    &scene) {
          scene.sets.push_back({name, prm.get(name), context.path});
        }};
    }

    // Joints

    const Text released_struts =
      {"Struts", "all", "Set of struts whose ends are released there."};
    const Choice       joint_type = {"Type",
                                     "hinge",
                                     {"hinge", "revolute", "rotational spring"},
                                     "How the struts are connected."};
    const QuantityList joint_axis = {
      "Axis",
      "",
      "1",
      Range::any(),
      3,
      3,
      "Components x, y and z at rest of the axis about which struts turn, of "
      "any length but zero."};
    const Quantity joint_stiffness = {
      "Stiffness",
      "",
      "N m/rad",
      Range::non_negative(),
      "Stiffness between a released strut and the unreleased ones of the "
      "joint, else the first released one; a strut alone: the ground."};

    void read_joint(dealii::ParameterHandler &prm,
                    const std::string        &name,
                    const SceneContext       &context,
                    Scene                    &scene)
    {
      JointDefinition joint;
      joint.name             = name;
      joint.path             = context.path;
      joint.joints           = get(prm, set_of_joints);
      joint.struts           = get(prm, released_struts);
      const std::string type = get(prm, joint_type);
      if (type == "revolute")
        {
          require_space(prm,
                        joint_type,
                        context,
                        "In the plane that is Type = hinge; set it");
          joint.type = JointDefinition::Type::revolute;
          joint.axis = read_unit_vector(prm, joint_axis, context);
        }
      if (type == "rotational spring")
        {
          joint.type      = JointDefinition::Type::rotational_spring;
          joint.stiffness = get(prm, joint_stiffness);
        }
      scene.joints.push_back(joint);
    }

    SubsectionKind joints_kind()
    {
      return {"Joints",
              Form::named_groups,
              "Joints at which struts are not rigidly connected.",
              [](dealii::ParameterHandler &prm) {
                declare(prm, set_of_joints);
                declare(prm, released_struts);
                declare(prm, joint_type);
              },
              "Type",
              {{"hinge", "Struts turn freely, in space about every axis.", {}},
               {"revolute",
                "Struts turn freely about one axis only; with Dimension = 3.",
                [](dealii::ParameterHandler &prm) {
                  declare(prm, joint_axis);
                }},
               {"rotational spring",
                "A spring resists the relative rotation, in space about every "
                "axis alike.",
                [](dealii::ParameterHandler &prm) {
                  declare(prm, joint_stiffness);
                }}},
              read_joint};
    }

    // Connectors

    Choice law_choice()
    {
      return {"Law",
              "",
              names_of(variants_of(connector_law_registry())),
              "Relation between force and extension."};
    }

    const Text between = {
      "Between",
      "in-cell",
      "Pairs of joints: a set of pairs the cell offers (in-cell, rod), numbers "
      "\"3 5; 7 9\", or \"ground: JOINTS\"."};
    const Choice geometry = {
      "Geometry",
      "line",
      {"line", "direction"},
      "Extension along the current line between the two ends, or along a "
      "direction fixed in space."};
    const QuantityList direction = {
      "Direction",
      "0 0",
      "1",
      Range::any(),
      2,
      3,
      "Components x, y and in space z of the direction, of any length but zero; "
      "only with Geometry = direction."};
    const QuantityList ground_offset = {
      "Ground offset",
      "0 0",
      "m",
      Range::any(),
      2,
      3,
      "Place x, y and in space z of the ground point, counted from the joint at "
      "rest; only with Between = ground: JOINTS."};

    void check_connector(const ConnectorDefinition &connector,
                         const double               direction_length)
    {
      const bool along_line =
        connector.geometry == ConnectorDefinition::Geometry::line;
      const bool grounded = connector.between.compare(0, 7, "ground:") == 0;
      const bool offset   = connector.ground_offset.norm() > 0;
      if (along_line && direction_length > 0)
        throw InputError(connector.path +
                         ": Direction is given, but Geometry = line. Remove "
                         "Direction or set Geometry = direction");
      if (!along_line && !(direction_length > 0))
        throw InputError(connector.path +
                         ": Geometry = direction needs a Direction other than "
                         "zero, e.g. set Direction = 0 1");
      if (offset && !grounded)
        throw InputError(connector.path +
                         ": Ground offset is given, but "
                         "Between = " +
                         connector.between +
                         ". Remove it or set Between = ground: JOINTS");
      if (along_line && grounded && !offset)
        throw InputError(connector.path +
                         ": a line from a joint to itself has no direction. "
                         "Give a Ground offset or set Geometry = direction");
    }

    /** The place of the reduced cell's connector is part of the model. */
    void refuse_place(dealii::ParameterHandler &prm,
                      const SceneContext       &context)
    {
      const auto refuse = [&](const std::string &name,
                              const std::string &default_value) {
        if (prm.get(name) != default_value)
          throw InputError(
            context.path + "/" + name + " = " + prm.get(name) +
            ": with Model = reduced cell the connector stands between the "
            "upper part and the rod on the foundation. Remove " +
            name);
      };
      refuse(between.name, between.default_value);
      refuse(geometry.name, geometry.default_value);
      refuse(direction.name, direction.default_value);
      refuse(ground_offset.name, ground_offset.default_value);
    }

    void read_connector(dealii::ParameterHandler &prm,
                        const std::string        &name,
                        const SceneContext       &context,
                        Scene                    &scene)
    {
      if (scene.model == Model::reduced_cell)
        refuse_place(prm, context);
      ConnectorDefinition connector;
      connector.name    = name;
      connector.path    = context.path;
      connector.between = get(prm, between);
      if (get(prm, geometry) == "direction")
        connector.geometry = ConnectorDefinition::Geometry::direction;
      connector.direction     = read_vector(prm, direction, context);
      connector.ground_offset = read_vector(prm, ground_offset, context);
      const double length     = connector.direction.norm();
      check_connector(connector, length);
      if (length > 0)
        connector.direction /= length;
      connector.law = find(connector_law_registry(), get(prm, law_choice()))
                        .make(prm, context);
      scene.connectors.push_back(connector);
    }

    SubsectionKind connectors_kind()
    {
      return {"Connectors",
              Form::named_groups,
              "Equal connectors between pairs of joints.",
              [](dealii::ParameterHandler &prm) {
                declare(prm, law_choice());
                declare(prm, between);
                declare(prm, geometry);
                declare(prm, direction);
                declare(prm, ground_offset);
              },
              "Law",
              variants_of(connector_law_registry()),
              read_connector,
              {Model::lattice, Model::reduced_cell}};
    }
  } // namespace



  std::vector<SubsectionKind> structure_kinds()
  {
    return {lattice_kind(),
            sets_kind(),
            sections_kind(),
            rigid_parts_kind(),
            joints_kind(),
            connectors_kind()};
  }
} // namespace auxfem
