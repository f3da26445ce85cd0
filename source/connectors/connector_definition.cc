#include <auxfem/connectors/connector_definition.h>

#include <cmath>

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
      "\"3 5; 7 9\", or \"ground: JOINTS\"; maybe followed by a condition on their "
      "middle, e.g. \"in-cell where y < ymax / 2\"."};
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

    const Quantity free_length = {
      "Free length",
      "at rest",
      "m",
      Range::positive(),
      "Length without force, from which extensions count; at rest: that in the "
      "lattice at rest.",
      {"at rest"}};
    const Quantity preload = {
      "Preload",
      "0 N",
      "N",
      Range::any(),
      "Force in the lattice at rest, positive in tension; the free length "
      "follows."};
    const Quantity failure_force = {
      "Failure force",
      "none",
      "N",
      Range::positive(),
      "Force, in tension or compression, beyond which a connector breaks for "
      "good, at the end of a step; none: never.",
      {"none"}};
    const Quantity failure_extension = {
      "Failure extension",
      "none",
      "m",
      Range::positive(),
      "Extension beyond which a connector breaks for good, at the end of a "
      "step; none: never.",
      {"none"}};

    /** Extension (m) at which @p law, relaxed, has the force @p force (N);
     * empty if there is none up to some kilometres. */
    std::optional<double> extension_at(const ConnectorLaw &law,
                                       const double        force)
    {
      constexpr double shortest = 1e-9, longest = 1e4;
      const double     at_rest = law.relaxed(0).force;
      const double     sign    = force > at_rest ? 1 : -1;
      const auto       reaches = [&](const double u) {
        return sign * (law.relaxed(sign * u).force - force) >= 0;
      };
      if (force == at_rest)
        return 0;
      double low = 0, high = shortest;
      for (; !reaches(high); high *= 2)
        {
          if (high > longest)
            return std::nullopt;
          low = high;
        }
      while (true)
        {
          const double middle = low + (high - low) / 2;
          if (!(middle > low && middle < high))
            return sign * high;
          (reaches(middle) ? high : low) = middle;
        }
    }

    std::optional<double> limit_of(const ParameterValues &values,
                                   const Quantity        &limit)
    {
      if (values.is_word(limit))
        return std::nullopt;
      return values[limit];
    }

    /** Reads what every law may have: free length or preload, and limits. */
    void read_prestress_and_limits(const ParameterValues &values,
                                   ConnectorDefinition   &connector)
    {
      connector.limits   = {limit_of(values, failure_force),
                            limit_of(values, failure_extension)};
      const double force = values[preload];
      if (!values.is_word(free_length))
        {
          if (force != 0)
            values.refuse("Free length and Preload are given, but each follows "
                          "from the other. Remove one of them");
          if (connector.geometry == ConnectorDefinition::Geometry::direction)
            values.refuse(free_length,
                          "a connector along a fixed direction has no length. "
                          "Give the force at rest as Preload");
          connector.free_length = values[free_length];
        }
      if (force == 0)
        return;
      const std::optional<double> extension =
        extension_at(*connector.law, force);
      if (!extension)
        values.refuse(preload,
                      "a law without such a force at any lasting extension "
                      "cannot have this preload. Choose a Law with a spring "
                      "that carries it, or remove it");
      connector.preload_extension = *extension;
    }

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

    /** The reduced cell defines the position of its connector. */
    void refuse_for_reduced_cell(const ParameterValues &values)
    {
      for (const Parameter &parameter :
           Parameters{between, geometry, direction, ground_offset})
        if (!values.is_default(parameter))
          values.refuse(
            parameter,
            "with Model = reduced cell the connector stands between the "
            "upper part and the rod on the foundation. Remove " +
              parameter.name);
      for (const Parameter &parameter :
           Parameters{free_length, preload, failure_force, failure_extension})
        if (!values.is_default(parameter))
          values.refuse(parameter,
                        "with Model = reduced cell the connector has no force "
                        "at rest and does not break. Remove " +
                          parameter.name + " or choose Model = lattice");
    }
  } // namespace

  SubsectionSchema connectors_schema()
  {
    return {"Connectors",
            SubsectionSchema::Form::named_groups,
            "Equal connectors between pairs of joints.",
            {law_choice(),
             between,
             geometry,
             direction,
             ground_offset,
             free_length,
             preload,
             failure_force,
             failure_extension},
            "Law",
            variants_of(connector_law_registry()),
            {Model::lattice, Model::reduced_cell}};
  }

  ConnectorDefinition read_connector(ParameterValues &values)
  {
    if (values.context.model == Model::reduced_cell)
      refuse_for_reduced_cell(values);
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
    read_prestress_and_limits(values, connector);
    return connector;
  }
} // namespace auxfem
