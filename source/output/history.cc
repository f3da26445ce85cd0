#include <auxfem/mesh/sets.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/history.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  void EnergyRecord::add(const Energies &energies)
  {
    // A run that starts from an equilibrium starts with work already done.
    if (!start)
      start = energies.balance(0);

    latest  = energies;
    balance = energies.balance(*start);
    // In this order a number that is none stays.
    largest_balance = std::max(std::abs(balance), largest_balance);
    largest_energy  = std::max({largest_energy,
                                std::abs(energies.total()),
                                std::abs(energies.dissipated),
                                std::abs(energies.external)});
  }

  double EnergyRecord::relative(const double energy) const
  {
    if (largest_energy > 0 || std::isnan(energy))
      return energy / largest_energy;
    return 0;
  }

  std::vector<Column> energy_columns(const bool has_struts)
  {
    std::vector<Column> columns = {{"kinetic", "J", "kinetic energy"}};
    if (has_struts)
      columns.push_back(
        {"strain", "J", "strain energy of struts and rotational springs"});
    columns.push_back({"stored", "J", "energy in the springs of connectors"});
    columns.push_back({"dissipated",
                       "J",
                       has_struts
                         ? "energy lost in connectors and struts since the "
                           "start"
                         : "energy lost in connectors since the start"});
    columns.push_back(
      {"external", "J", "work of loads and prescribed motion since the start"});
    columns.push_back(
      {"balance",
       "J",
       std::string(has_struts ? "kinetic + strain" : "kinetic") +
         " + stored + dissipated - external minus its value at the start: "
         "error of the time integration and loss by its numerical damping"});
    return columns;
  }

  std::vector<double> energy_values(const EnergyRecord &record,
                                    const bool          has_struts)
  {
    const Energies     &energies = record.latest;
    std::vector<double> values   = {energies.kinetic};
    if (has_struts)
      values.push_back(energies.strain);
    for (const double energy : {energies.stored,
                                energies.dissipated,
                                energies.external,
                                record.balance})
      values.push_back(energy);
    return values;
  }

  History::History(const Scene       &scene,
                   const System      &system,
                   const std::string &folder,
                   const MPI_Comm     communicator)
    : system(system)
    , communicator(communicator)
    , part_rotations(system)
  {
    columns.push_back({"time", "s", "time"});
    for (const ProbeDefinition &probe : scene.output.probes)
      if (RigidPartProbe::is_one(probe))
        rigid_part_probes.emplace_back(probe, scene, system);
      else
        define_probe(probe, scene.context);
    for (const Support &support : system.supports())
      define_support(support);
    for (const RigidPartProbe &probe : rigid_part_probes)
      for (const Column &column : probe.columns())
        columns.push_back(column);
    for (const ConnectorForces *group : system.connectors())
      define_connectors(*group);
    for (const Column &column : energy_columns(/*has_struts=*/true))
      columns.push_back(column);
    row.resize(columns.size());
    const DofNumbering &numbering = system.numbering();
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      if (numbering.is_rotation(i))
        rotations.push_back(i);

    on_first_rank(communicator, [&]() {
      table.emplace(folder + "/history.csv", columns);
      write_column_reference(folder + "/history.units.csv", columns);
    });
  }

  void History::define_probe(const ProbeDefinition &probe,
                             const SceneContext    &context)
  {
    const DofNumbering             &numbering = system.numbering();
    const std::vector<unsigned int> joints =
      select_joints(system.lattice(), probe.selection, context, probe.path);

    const auto add = [&](const std::string &suffix,
                         const std::string &unit,
                         const std::string &meaning,
                         const Quantity     quantity,
                         const unsigned int component) {
      UnknownSum sum{quantity, {}, 1. / joints.size()};
      for (const unsigned int joint : joints)
        {
          const int unknown = numbering.joint_unknown(joint, component);
          if (numbering.is_owned(unknown))
            sum.unknowns.push_back(unknown);
        }
      sums.push_back(std::move(sum));
      columns.push_back({probe.name + "." + suffix,
                         unit,
                         "mean " + meaning + " of the probe's joints"});
    };

    add("ux", "m", "displacement along x", Quantity::displacement, 0);
    add("uy", "m", "displacement along y", Quantity::displacement, 1);
    if (std::all_of(joints.begin(), joints.end(), [&](const unsigned int j) {
          return numbering.joint_has(j, rotation_z);
        }))
      add("phi", "rad", "rotation", Quantity::displacement, rotation_z);
    if (system.is_dynamic())
      {
        add("vx", "m/s", "velocity along x", Quantity::velocity, 0);
        add("vy", "m/s", "velocity along y", Quantity::velocity, 1);
      }
  }

  void History::define_support(const Support &support)
  {
    const std::array<Column, 3> reactions = {
      {{".rx", "N", "force of the support on the lattice along x"},
       {".ry", "N", "force of the support on the lattice along y"},
       {".m",
        "N m",
        "moment of the support on the rotations it prescribes, without moments "
        "of its forces"}}};
    for (unsigned int component = 0; component < reactions.size(); ++component)
      {
        UnknownSum sum{Quantity::residual, {}, 1.};
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (prescribed.component == system.numbering().components()[component] &&
              system.numbering().is_owned(prescribed.unknown))
            sum.unknowns.push_back(prescribed.unknown);
        sums.push_back(std::move(sum));

        Column column = reactions[component];
        column.name   = support.name + column.name;
        columns.push_back(column);
      }
  }

  void History::define_connectors(const ConnectorForces &group)
  {
    columns.push_back({group.name() + ".force",
                       "N",
                       "sum of the connectors' forces, positive in tension"});
    columns.push_back(
      {group.name() + ".extension", "m", "sum of the connectors' extensions"});
    columns.push_back({group.name() + ".dissipated",
                       "J",
                       "energy lost in the connectors since the start"});
  }

  unsigned int History::add_unknown_sums(const State &state,
                                         unsigned int column)
  {
    for (const UnknownSum &sum : sums)
      {
        const Vector &vector = sum.quantity == Quantity::displacement
          ? state.displacement
          : sum.quantity == Quantity::velocity ? *state.velocity
                                               : state.residual;
        double        total  = 0;
        for (const int unknown : sum.unknowns)
          total += vector[unknown];
        row[column++] = sum.factor * total;
      }
    return column;
  }

  unsigned int History::add_rigid_part_values(const State &state,
                                              unsigned int column)
  {
    for (const RigidPartProbe &probe : rigid_part_probes)
      for (const double value : probe.values(state, part_rotations))
        row[column++] = value;
    return column;
  }

  unsigned int History::add_connector_sums(const State &state,
                                           unsigned int column)
  {
    for (const ConnectorForces *group : system.connectors())
      {
        double force = 0, extension = 0, dissipated = 0;
        for (unsigned int i = 0; i < group->n_reported(); ++i)
          {
            const ConnectorReport report = group->report(i, state);
            force += report.force;
            extension += report.extension;
            dissipated += report.dissipated;
          }
        row[column++] = force;
        row[column++] = extension;
        row[column++] = dissipated;
      }
    return column;
  }

  void History::write(const State &state)
  {
    note(state);
    row[0]              = state.time;
    unsigned int column = add_unknown_sums(state, 1);
    column              = add_rigid_part_values(state, column);
    column              = add_connector_sums(state, column);
    if (system.numbering().n_ranks() > 1)
      MPI_Allreduce(MPI_IN_PLACE,
                    row.data() + 1,
                    column - 1,
                    MPI_DOUBLE,
                    MPI_SUM,
                    communicator);

    for (const double energy : energy_values(record, /*has_struts=*/true))
      row[column++] = energy;
    AssertDimension(column, row.size());

    for (const int unknown : rotations)
      rotation_so_far =
        std::max(rotation_so_far, std::abs(state.displacement[unknown]));

    on_first_rank(communicator, [&]() { table->append(row); });
  }

  void History::note(const State &state)
  {
    record.add(state.energies);
    part_rotations.follow(state);
    for (const SpaceVector &rotation : part_rotations.values())
      rotation_so_far = std::max(rotation_so_far, rotation.norm());
  }

  const EnergyRecord &History::energies() const
  {
    return record;
  }

  double History::largest_rotation() const
  {
    return rotation_so_far;
  }

  void refuse_probes_on_nothing(const Scene &scene, const Lattice &lattice)
  {
    for (const ProbeDefinition &probe : scene.output.probes)
      if (RigidPartProbe::is_one(probe))
        RigidPartProbe::check(probe, scene, lattice);
      else
        select_joints(lattice, probe.selection, scene.context, probe.path);
  }
} // namespace auxfem
