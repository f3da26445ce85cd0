#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/output/vtu_writer.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

namespace auxfem
{
  namespace
  {
    void append(std::vector<float> &values, const dealii::Tensor<1, 3> &vector)
    {
      for (unsigned int d = 0; d < 3; ++d)
        values.push_back(vector[d]);
    }

    /** Force of the joint at @p point on a rigid part; zero between joints. */
    dealii::Tensor<1, 3> force_at(const Lattice          &lattice,
                                  const RigidPart        &part,
                                  const RigidPartReport  &report,
                                  const dealii::Point<3> &point)
    {
      dealii::Tensor<1, 3> force;
      for (unsigned int k = 0; k < part.joints.size(); ++k)
        if (point == lattice.joints[part.joints[k]])
          force = report.forces[k];
      return force;
    }

    const std::vector<GraphicsField> section_force_fields_in_plane = {
      {"rotation", 1, "rad"},
      {"axial_force", 1, "N"},
      {"shear_force", 1, "N"},
      {"bending_moment", 1, "N m"}};

    const std::vector<GraphicsField> section_force_fields_in_space = {
      {"rotation", 3, "rad"},
      {"d1", 3, ""},
      {"d2", 3, ""},
      {"d3", 3, ""},
      {"axial_force", 1, "N"},
      {"shear_force_2", 1, "N"},
      {"shear_force_3", 1, "N"},
      {"torque", 1, "N m"},
      {"bending_moment_2", 1, "N m"},
      {"bending_moment_3", 1, "N m"}};

    /** Values of section_force_fields_in_plane. */
    void append_in_plane(std::vector<float> &values, const StrutPoint &point)
    {
      for (const double value :
           {point.rotation[2], point.force[0], point.force[1], point.moment[2]})
        values.push_back(value);
    }

    /** Values of section_force_fields_in_space. */
    void append_in_space(std::vector<float> &values, const StrutPoint &point)
    {
      append(values, point.rotation);
      const SpaceTensor rows_are_axes = transpose(point.axes);
      for (unsigned int i = 0; i < 3; ++i)
        append(values, rows_are_axes[i]);
      append(values, point.force);
      append(values, point.moment);
    }

    const std::vector<GraphicsField> connector_fields = {
      {"displacement", 3, "m"},
      {"force", 1, "N"},
      {"extension", 1, "m"},
      {"dissipated_energy", 1, "J"},
      {"group", 1, ""},
      {"cell", 1, ""}};
  } // namespace

  VtuWriter::VtuWriter(const Scene       &scene,
                       const Equations   &equations,
                       const std::string &folder,
                       const MPI_Comm     communicator,
                       const std::string &prefix)
    : equations(equations)
    , n_segments(scene.output.segments)
  {
    if (scene.output.stresses)
      {
        stresses.emplace(equations.model());
        if (!stresses->exist())
          stresses.reset();
      }
    const Lattice &lattice = equations.model().lattice;
    for (const SetDefinition &definition : scene.sets)
      {
        const auto set = lattice.strut_sets.find(definition.name);
        if (set == lattice.strut_sets.end())
          continue;
        SetMembers members(lattice.struts.size(), false);
        for (const unsigned int strut : set->second)
          members[strut] = true;
        set_names.push_back(definition.name);
        sets.push_back(std::move(members));
      }

    if (!equations.reporting().struts.empty())
      strut_series.emplace(folder, prefix + "solution", communicator);
    if (equations.reporting().rigid_parts)
      rigid_part_series.emplace(folder, prefix + "rigid_parts", communicator);
    if (!equations.reporting().connectors.empty())
      connector_series.emplace(folder, prefix + "connectors", communicator);
    if (equations.reporting().plates || equations.reporting().strut_contact)
      contacts.emplace(equations, folder, prefix);
  }

  std::vector<std::string> VtuWriter::series() const
  {
    std::vector<std::string> names;
    for (const auto *series :
         {&strut_series, &rigid_part_series, &connector_series})
      if (*series)
        names.push_back((*series)->series_name());
    if (contacts)
      for (const std::string &name : contacts->series())
        names.push_back(name);
    return names;
  }

  std::vector<GraphicsField> VtuWriter::law_fields() const
  {
    const SimulatedEffects    &simulated = equations.model().plan.simulated;
    std::vector<GraphicsField> fields;
    if (simulated.strut_relaxation || simulated.plasticity)
      fields.push_back({"dissipated_energy_density", 1, "J/m"});
    if (simulated.plasticity)
      {
        fields.push_back({"plastic_strain", 1, ""});
        fields.push_back({"utilisation", 1, ""});
      }
    if (equations.model().struts_may_fail())
      fields.push_back({"intactness", 1, ""});
    return fields;
  }

  std::vector<GraphicsField> VtuWriter::stress_fields() const
  {
    if (!stresses)
      return {};
    std::vector<GraphicsField> fields = {{"axial_stress", 1, "Pa"},
                                         {"bending_stress", 1, "Pa"},
                                         {"fibre_stress", 1, "Pa"},
                                         {"shear_stress", 1, "Pa"}};
    if (equations.model().lattice.dimension == 3)
      fields.push_back({"torsion_stress", 1, "Pa"});
    fields.push_back({"von_mises_stress", 1, "Pa"});
    fields.push_back({"fibre_strain", 1, ""});
    return fields;
  }

  void VtuWriter::append_stresses(const PointStresses &at,
                                  std::vector<float>  &values) const
  {
    for (const double value : {at.axial, at.bending, at.fibre, at.shear})
      values.push_back(value);
    if (equations.model().lattice.dimension == 3)
      values.push_back(at.torsion);
    values.push_back(at.von_mises);
    values.push_back(at.fibre_strain);
  }

  std::vector<GraphicsField> VtuWriter::strut_fields() const
  {
    std::vector<GraphicsField> fields = {{"displacement", 3, "m"}};
    if (equations.model().plan.simulated.inertia)
      fields.push_back({"velocity", 3, "m/s"});
    for (const GraphicsField &field : equations.model().lattice.dimension == 2
           ? section_force_fields_in_plane
           : section_force_fields_in_space)
      fields.push_back(field);
    fields.push_back({"strain_energy_density", 1, "J/m"});
    for (const GraphicsField &field : law_fields())
      fields.push_back(field);
    for (const GraphicsField &field : stress_fields())
      fields.push_back(field);
    for (const GraphicsField &field :
         std::vector<GraphicsField>{{"radius", 1, "m"},
                                    {"strut", 1, ""},
                                    {"cell", 1, ""},
                                    {"section", 1, ""},
                                    {"mpi_rank", 1, ""}})
      fields.push_back(field);
    for (const std::string &name : set_names)
      fields.push_back({"set_" + field_name(name), 1, ""});
    return fields;
  }

  void VtuWriter::append_point(const StrutPoint   &point,
                               std::vector<float> &values) const
  {
    append(values, point.displacement);
    if (equations.model().plan.simulated.inertia)
      append(values, point.velocity);
    if (equations.model().lattice.dimension == 2)
      append_in_plane(values, point);
    else
      append_in_space(values, point);
    values.push_back(point.energy_density);
    const SimulatedEffects &simulated = equations.model().plan.simulated;
    if (simulated.strut_relaxation || simulated.plasticity)
      values.push_back(point.dissipated_density);
    if (simulated.plasticity)
      for (const double value : {point.plastic_strain, point.utilisation})
        values.push_back(value);
    if (equations.model().struts_may_fail())
      values.push_back(point.intactness);
  }

  void VtuWriter::add_struts(const StrutForces &struts,
                             const State       &state,
                             LineGraphics      &graphics) const
  {
    const DofNumbering &numbering = equations.model().numbering;

    std::vector<dealii::Point<3>> points;
    std::vector<float>            values;
    for (unsigned int e = struts.elements().begin; e < struts.elements().end;
         ++e)
      {
        const DofNumbering::Element &element = numbering.elements()[e];
        if (!element.is_owned)
          continue;

        const unsigned int number = element.interval.strut;
        const Strut       &strut  = equations.model().lattice.struts[number];
        const float        radius = equations.model()
                               .sections[strut.section]
                               .at(element.interval.at(0))
                               .radius;

        points.clear();
        values.clear();
        unsigned int next = 0;
        for (const StrutPoint &point : struts.sample(state, e, n_segments + 1))
          {
            points.push_back(point.position);
            append_point(point, values);
            const double xi = -1 + 2. * next++ / n_segments;
            if (stresses)
              append_stresses(stresses->at(point,
                                           number,
                                           element.interval.at(xi)),
                              values);
            values.push_back(radius);
            for (const unsigned int value :
                 {number,
                  strut.cell,
                  equations.model().plan.scene.sections[strut.section].number,
                  numbering.layout().rank()})
              values.push_back(value);
            for (const SetMembers &set : sets)
              values.push_back(set[number] ? 1 : 0);
          }
        graphics.add_line(points, values);
      }
  }

  void VtuWriter::write_struts(const State &state)
  {
    if (!strut_series)
      return;

    LineGraphics graphics(strut_fields());
    for (const StrutGroup &group : equations.reporting().struts)
      add_struts(*group.forces, state, graphics);
    strut_series->write(graphics, state.time);
  }

  std::vector<GraphicsField> VtuWriter::rigid_part_fields() const
  {
    std::vector<GraphicsField> fields = {{"displacement", 3, "m"}};
    if (equations.model().plan.simulated.inertia)
      fields.push_back({"velocity", 3, "m/s"});
    fields.push_back({"force", 3, "N"});
    fields.push_back(
      {"rotation", equations.model().lattice.dimension == 2 ? 1u : 3u, "rad"});
    for (const char *number : {"part", "definition", "cell"})
      fields.push_back({number, 1, ""});
    return fields;
  }

  std::vector<std::vector<dealii::Point<3>>>
  VtuWriter::rigid_part_lines(const RigidPart &part) const
  {
    const Lattice &lattice = equations.model().lattice;
    std::vector<std::vector<dealii::Point<3>>> lines;
    for (const unsigned int number : part.struts)
      {
        const Strut                  &strut = lattice.struts[number];
        const unsigned int            n = strut.sagitta == 0 ? 1 : n_segments;
        std::vector<dealii::Point<3>> line(n + 1);
        dealii::Tensor<1, 3>          tangent;
        for (unsigned int i = 1; i < n; ++i)
          lattice.axis(strut, double(i) / n, line[i], tangent);
        // Forces are found by the exact positions of the joints.
        line.front() = lattice.joints[strut.joints[0]];
        line.back()  = lattice.joints[strut.joints[1]];
        lines.push_back(line);
      }
    if (part.struts.empty())
      for (unsigned int k = 1; k < part.joints.size(); ++k)
        lines.push_back(
          {lattice.joints[part.joints[0]], lattice.joints[part.joints[k]]});
    return lines;
  }

  void VtuWriter::write_rigid_parts(const State &state)
  {
    if (!rigid_part_series)
      return;

    const Lattice        &lattice = equations.model().lattice;
    const RigidPartGroup &parts   = *equations.reporting().rigid_parts;
    LineGraphics          graphics(rigid_part_fields());
    std::vector<float>    values;
    for (unsigned int i = 0; i < parts.n_reported(); ++i)
      {
        const RigidPartReport report   = parts.report(i, state);
        const RigidPart      &part     = lattice.rigid_parts[report.part];
        const SpaceVector     rotation = parts.rotation(i, state);
        for (const auto &line : rigid_part_lines(part))
          {
            values.clear();
            for (const dealii::Point<3> &point : line)
              {
                const PointMotion motion = parts.motion(i, point, state);
                append(values, motion.displacement);
                if (equations.model().plan.simulated.inertia)
                  append(values, motion.velocity);
                append(values, force_at(lattice, part, report, point));
                if (lattice.dimension == 2)
                  values.push_back(rotation[2]);
                else
                  append(values, rotation);
                for (const unsigned int number :
                     {report.part, part.definition, part.cell})
                  values.push_back(number);
              }
            graphics.add_line(line, values);
          }
      }
    rigid_part_series->write(graphics, state.time);
  }

  void VtuWriter::write_connectors(const Solution &solution)
  {
    if (!connector_series)
      return;

    LineGraphics       graphics(connector_fields);
    std::vector<float> values;
    for (unsigned int group = 0;
         group < equations.reporting().connectors.size();
         ++group)
      {
        const ConnectorGroup &connectors =
          equations.reporting().connectors[group];
        for (unsigned int i = 0; i < connectors.forces->n_reported(); ++i)
          {
            const ConnectorReport report =
              connectors.report(i, solution.state, solution.results);
            values.clear();
            for (const dealii::Tensor<1, 3> &displacement :
                 report.displacements)
              {
                append(values, displacement);
                for (const double value :
                     {report.force, report.extension, report.dissipated})
                  values.push_back(value);
                values.push_back(group);
                values.push_back(report.cell);
              }
            graphics.add_line({report.ends[0], report.ends[1]}, values);
          }
      }
    connector_series->write(graphics, solution.state.time);
  }

  void VtuWriter::write_contacts(const Solution &solution)
  {
    if (contacts)
      contacts->write(solution);
  }

  void VtuWriter::serialize(CheckpointArchive &archive)
  {
    for (auto *series : {&strut_series, &rigid_part_series, &connector_series})
      if (*series)
        (*series)->serialize(archive);
    if (contacts)
      contacts->serialize(archive);
  }
} // namespace auxfem
