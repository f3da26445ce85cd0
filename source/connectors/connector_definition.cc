#include <auxfem/connectors/connector_definition.h>

namespace auxfem
{
  namespace
  {
    Choice law_choice()
    {
      return {"Law",
              "",
              names_of(connector_law_registry()),
              "Relation between force and extension."};
    }

    const Text between = {
      "Between",
      "in-cell",
      "Pairs of joints: a pair set of the cell (in-cell, rod), numbers "
      "\"3 5; 7 9\", or \"ground: JOINTS\"."};
    const Choice geometry = {
      "Geometry",
      "line",
      {"line", "direction"},
      "Extension along the current line between the ends, or along a fixed "
      "direction."};
    const QuantityList direction = {
      "Direction",
      "0 0",
      "1",
      Range::any(),
      2,
      3,
      "Direction vector x, y and in space z, of any nonzero length; only with "
      "Geometry = direction."};
    const QuantityList ground_offset = {
      "Ground offset",
      "0 0",
      "m",
      Range::any(),
      2,
      3,
      "Vector x, y and in space z from the joint at rest to the ground point; only "
      "with Between = ground: JOINTS."};

    void check_connector(const ParameterValues     &values,
                         const ConnectorDefinition &connector,
                         const double               direction_length)
    {
      const bool along_line =
        connector.geometry == ConnectorDefinition::Geometry::line;
      const bool grounded = connector.between.compare(0, 7, "ground:") == 0;
      const bool offset   = connector.ground_offset.norm() > 0;
      if (along_line && direction_length > 0)
        values.refuse("Direction is given, but Geometry = line. Remove "
                      "Direction or set Geometry = direction");
      if (!along_line && !(direction_length > 0))
        values.refuse("Geometry = direction needs a Direction other than "
                      "zero, e.g. set Direction = 0 1");
      if (offset && !grounded)
        values.refuse("Ground offset is given, but "
                      "Between = " +
                      connector.between +
                      ". Remove it or set Between = ground: JOINTS");
      if (along_line && grounded && !offset)
        values.refuse("a line from a joint to itself has no direction. "
                      "Give a Ground offset or set Geometry = direction");
    }

    /** The model defines the position of the connector of the reduced cell. */
    void refuse_position(const ParameterValues &values)
    {
      for (const Parameter &parameter :
           Parameters{between, geometry, direction, ground_offset})
        if (!values.is_default(parameter))
          values.refuse(
            parameter,
            "with Model = reduced cell the connector stands between the "
            "upper part and the rod on the foundation. Remove " +
              parameter.name);
    }
  } // namespace

  SubsectionSchema connectors_schema()
  {
    return {"Connectors",
            SubsectionSchema::Form::named_groups,
            "Equal connectors between pairs of joints.",
            {law_choice(), between, geometry, direction, ground_offset},
            "Law",
            variants_of(connector_law_registry()),
            {Model::lattice, Model::reduced_cell}};
  }

  ConnectorDefinition read_connector(ParameterValues &values)
  {
    if (values.context.model == Model::reduced_cell)
      refuse_position(values);
    ConnectorDefinition connector;
    connector.name    = values.name();
    connector.path    = values.context.path;
    connector.between = values[between];
    if (values[geometry] == "direction")
      connector.geometry = ConnectorDefinition::Geometry::direction;
    connector.direction     = vector_of(values, direction);
    connector.ground_offset = vector_of(values, ground_offset);
    const double length     = connector.direction.norm();
    check_connector(values, connector, length);
    if (length > 0)
      connector.direction /= length;

    connector.law =
      find_entry(connector_law_registry(), values[law_choice()]).make(values);
    return connector;
  }
} // namespace auxfem
