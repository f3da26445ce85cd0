#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/output/history.h>
#include <auxfem/output/output_folder.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    const std::vector<Column> path_columns = {
      {"arc_length",
       "m",
       "sum over the points of the root mean square of nodal displacements, "
       "with rotations times the mean strut length"},
      {"load_factor", "1", "factor of the loads"},
      {"negative_eigenvalues",
       "",
       "negative eigenvalues of the stiffness: 0 in stable equilibrium; nan: "
       "unknown"},
      {"determinant",
       "",
       "sign of the determinant of the stiffness: 1 in stable equilibrium; "
       "nan: unknown"}};

    /** Column of a component of the force or moment of a support. */
    Column reaction_column(const std::string &support,
                           const unsigned int component,
                           const unsigned int dimension)
    {
      const std::string axis = axis_name(component % 3);
      if (component < first_rotation)
        return {support + ".r" + axis,
                "N",
                "force of the support on the lattice along " + axis};
      const bool is_planar = dimension == 2;
      return {support + (is_planar ? ".m" : ".m" + axis),
              "N m",
              "moment of the support " +
                (is_planar ? "" : "about " + axis + " ") +
                "on the rotations it prescribes, without moments of its "
                "forces"};
    }

    /**
     * Largest rotation (rad) of all nodes on this rank: in space an angle up to
     * half a revolution.
     */
    double largest_node_rotation(const State        &state,
                                 const DofNumbering &numbering)
    {
      double     largest        = 0;
      const auto update_largest = [&largest](const double value) {
        largest = std::max(largest, value);
      };
      if (!state.rotations.empty())
        {
          for (const Quaternion &rotation : state.rotations)
            update_largest(rotation.vector.norm_square());
          return 2 * std::asin(std::min(1., std::sqrt(largest)));
        }
      const unsigned int n_spatial_rotations = numbering.rotations().size();
      if (n_spatial_rotations > 0)
        {
          const NodeRotations node_rotations(numbering);
          for (unsigned int i = 0; i < n_spatial_rotations; ++i)
            update_largest(node_rotations.values(state.displacement, i).norm());
          return largest;
        }
      for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
        if (numbering.unknowns().is_rotation[i])
          update_largest(std::abs(state.displacement[i]));
      return largest;
    }
  } // namespace

  History::History(const Scene     &scene,
                   const Equations &equations,
                   const MPI_Comm   communicator)
    : equations(equations)
    , communicator(communicator)
    , part_rotations(equations)
    , rotation_vectors(equations.model())
  {
    if (scene.analysis == Analysis::static_path)
      column_list = path_columns;
    else
      column_list.push_back({"time", "s", "time"});
    n_position_columns = column_list.size();
    for (const ProbeDefinition &probe : scene.output.probes)
      if (RigidPartProbe::is_rigid_part_probe(probe))
        rigid_part_probes.emplace_back(probe, scene, equations);
      else
        define_probe(probe, scene.context);
    if (equations.model().lattice.periodicity)
      define_mean_deformation();
    else
      for (const Support &support : equations.model().supports)
        define_support(support);
    for (const RigidPartProbe &probe : rigid_part_probes)
      for (const Column &column : probe.columns())
        column_list.push_back(column);
    for (const ConnectorGroup &group : equations.reporting().connectors)
      define_connectors(*group.forces);
    if (scene.output.effective_strains)
      {
        strains.emplace(equations.model());
        strain_so_far = LargestStrain(
          loaded_axis(equations.model().plan, equations.model().lattice));
        for (const Column &column : strains->columns())
          column_list.push_back(column);
      }
    if (const PlateContact *plates = equations.reporting().plates)
      define_plates(*plates);
    for (const Column &column : energy_columns(equations.layout().energies))
      column_list.push_back(column);
    row.resize(column_list.size());
  }

  void History::define_probe(const ProbeDefinition &probe,
                             const SceneContext    &context)
  {
    const Lattice                  &lattice = equations.model().lattice;
    const std::vector<unsigned int> joints =
      select_joints(lattice, probe.selection, context, probe.path);
    const auto define = [&](const Column      &column,
                            const Quantity     quantity,
                            const unsigned int component) {
      define_mean(probe, joints, column, quantity, component);
    };

    for (unsigned int c = 0; c < lattice.dimension; ++c)
      define({"u" + axis_name(c), "m", "displacement along " + axis_name(c)},
             Quantity::displacement,
             c);
    if (std::all_of(joints.begin(), joints.end(), [&](const unsigned int j) {
          return equations.model().numbering.joint_has(j, rotation_z);
        }))
      {
        if (lattice.dimension == 2)
          define({"phi", "rad", "rotation"},
                 Quantity::displacement,
                 rotation_z);
        else
          for (unsigned int c = 0; c < 3; ++c)
            define({"phi_" + axis_name(c),
                    "rad",
                    "component along " + axis_name(c) +
                      " of the rotation vector"},
                   Quantity::rotation_vector,
                   first_rotation + c);
      }
    if (equations.model().plan.simulated.inertia)
      for (unsigned int c = 0; c < lattice.dimension; ++c)
        define({"v" + axis_name(c), "m/s", "velocity along " + axis_name(c)},
               Quantity::velocity,
               c);
  }

  void History::define_mean(const ProbeDefinition           &probe,
                            const std::vector<unsigned int> &joints,
                            const Column                    &column,
                            const Quantity                   quantity,
                            const unsigned int               component)
  {
    UnknownSum sum{quantity, {}, 1. / joints.size()};
    for (const unsigned int joint : joints)
      {
        const int unknown =
          equations.model().numbering.joint_unknown(joint, component);
        if (equations.model().numbering.layout().is_owned(unknown))
          {
            sum.unknowns.push_back(unknown);
            if (quantity == Quantity::rotation_vector)
              rotation_vectors.choose(unknown);
          }
      }
    unknown_sums.push_back(std::move(sum));
    column_list.push_back(
      {probe.name + "." + column.name,
       column.unit,
       "mean " + column.meaning + " of the probe's joints"});
  }

  void History::define_support(const Support &support)
  {
    const DofNumbering &numbering = equations.model().numbering;
    for (const unsigned int component : numbering.components())
      {
        UnknownSum sum{Quantity::residual, {}, 1.};
        for (const Support::PrescribedUnknown &prescribed : support.unknowns)
          if (prescribed.component == component &&
              numbering.layout().is_owned(prescribed.unknown))
            sum.unknowns.push_back(prescribed.unknown);
        unknown_sums.push_back(std::move(sum));
        column_list.push_back(
          reaction_column(support.name,
                          component,
                          equations.model().lattice.dimension));
      }
  }

  void History::define_mean_deformation()
  {
    const LatticeModel &model   = equations.model();
    const Lattice      &lattice = model.lattice;
    for (unsigned int i = 0; i < lattice.dimension; ++i)
      for (unsigned int j = 0; j < lattice.dimension; ++j)
        {
          UnknownSum strain{Quantity::displacement,
                            {},
                            1 / lattice.periodicity->length()};
          const int  unknown =
            model.numbering.joint_unknown(lattice.joint_of_axis(j), i);
          if (model.numbering.layout().is_owned(unknown))
            strain.unknowns.push_back(unknown);
          unknown_sums.push_back(std::move(strain));
          column_list.push_back({"strain_" + component_name(i, j),
                                 "1",
                                 "mean derivative of the displacement along " +
                                   axis_name(i) + " by " + axis_name(j)});
        }
    for (unsigned int i = 0; i < lattice.dimension; ++i)
      for (unsigned int j = 0; j < lattice.dimension; ++j)
        {
          UnknownSum stress{Quantity::displacement, {}, 1.};
          for (const WeightedUnknown &term : mean_stress_terms(model, i, j))
            {
              stress.unknowns.push_back(term.unknown);
              stress.weights.push_back(term.weight);
            }
          unknown_sums.push_back(std::move(stress));
          column_list.push_back(
            {"stress_" + component_name(i, j),
             "Pa",
             "mean nominal stress: force along " + axis_name(i) +
               " per area at rest with its normal along " + axis_name(j)});
        }
  }

  void History::define_connectors(const ConnectorForces &group)
  {
    column_list.push_back(
      {group.name() + ".force",
       "N",
       "sum of the connectors' forces, positive in tension"});
    column_list.push_back(
      {group.name() + ".extension", "m", "sum of the connectors' extensions"});
    if (group.may_break())
      column_list.push_back({group.name() + ".broken",
                             "1",
                             "number of connectors that have broken"});
  }

  void History::define_plates(const PlateContact &plates)
  {
    const unsigned int dimension = equations.model().lattice.dimension;
    for (unsigned int i = 0; i < plates.n_plates(); ++i)
      {
        for (unsigned int c = 0; c < dimension; ++c)
          column_list.push_back(
            {plates.name(i) + ".u" + axis_name(c),
             "m",
             "displacement of the plate along " + axis_name(c)});
        for (unsigned int c = 0; c < dimension; ++c)
          column_list.push_back(
            {plates.name(i) + ".f" + axis_name(c),
             "N",
             "force of the struts on the plate along " + axis_name(c)});
        column_list.push_back(
          {plates.name(i) + ".penetration",
           "1",
           "largest penetration of a strut into the plate over its thickness"});
      }
  }

  unsigned int History::add_unknown_sums(const State &state,
                                         unsigned int column)
  {
    for (const UnknownSum &sum : unknown_sums)
      {
        row[column++] = sum.total([&](const int unknown) {
          return value(sum.quantity, state, unknown);
        });
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

  unsigned int History::add_connector_sums(const Solution &solution,
                                           unsigned int    column)
  {
    for (const ConnectorGroup &group : equations.reporting().connectors)
      {
        const auto sum = [&group](const Solution &at,
                                  double ConnectorReport::*value) {
          double total = 0;
          for (unsigned int i = 0; i < group.forces->n_reported(); ++i)
            total += group.report(i, at.state, at.results).*value;
          return total;
        };
        const auto &within = solution.forces_within;
        row[column++]      = within
               ? within->chord(sum(*within->from, &ConnectorReport::force),
                          sum(*within->to, &ConnectorReport::force))
               : sum(solution, &ConnectorReport::force);
        row[column++]      = sum(solution, &ConnectorReport::extension);
        if (group.forces->may_break())
          row[column++] = sum(solution, &ConnectorReport::is_broken);
      }
    return column;
  }

  unsigned int History::add_plates(const Solution &solution,
                                   unsigned int    column)
  {
    const PlateContact *plates = equations.reporting().plates;
    if (plates == nullptr)
      return column;
    const unsigned int dimension = equations.model().lattice.dimension;
    const auto         reports   = [&](const Solution &at) {
      return plates->reports(equations.plate_results(at.results), at.state);
    };
    std::vector<PlateReport> now = reports(solution);
    if (const auto &within = solution.forces_within)
      {
        const std::vector<PlateReport> before = reports(*within->from),
                                       after  = reports(*within->to);
        for (unsigned int i = 0; i < now.size(); ++i)
          {
            for (unsigned int c = 0; c < dimension; ++c)
              now[i].force[c] =
                within->chord(before[i].force[c], after[i].force[c]);
            now[i].largest_penetration =
              within->chord(before[i].largest_penetration,
                            after[i].largest_penetration);
          }
      }
    for (const PlateReport &report : now)
      {
        for (unsigned int c = 0; c < dimension; ++c)
          row[column++] = report.displacement[c];
        for (unsigned int c = 0; c < dimension; ++c)
          row[column++] = report.force[c];
        row[column++] = report.largest_penetration;
      }
    return column;
  }

  unsigned int History::add_strains(const State &state, unsigned int column)
  {
    if (strains)
      for (const double strain : strains->values(state))
        row[column++] = strain;
    return column;
  }

  double History::value(const Quantity quantity,
                        const State   &state,
                        const int      unknown) const
  {
    switch (quantity)
      {
        case Quantity::displacement:
          return state.displacement[unknown];
        case Quantity::rotation_vector:
          return rotation_vectors[unknown];
        case Quantity::velocity:
          return (*state.velocity)[unknown];
        default:
          return state.residual[unknown];
      }
  }

  const std::vector<double> &History::values(const Solution &solution)
  {
    const State &state = solution.state;
    note(state);
    row[0] = state.time;
    if (state.path)
      {
        row[1] = state.path->load_factor;
        row[2] = state.path->n_negative
          ? double(*state.path->n_negative)
          : std::numeric_limits<double>::quiet_NaN();
        row[3] = state.path->determinant_sign
          ? double(*state.path->determinant_sign)
          : std::numeric_limits<double>::quiet_NaN();
      }
    unsigned int column = add_unknown_sums(state, n_position_columns);
    column              = add_rigid_part_values(state, column);
    column              = add_connector_sums(solution, column);
    column              = add_strains(state, column);
    if (equations.model().numbering.layout().n_ranks() > 1)
      MPI_Allreduce(MPI_IN_PLACE,
                    row.data() + n_position_columns,
                    column - n_position_columns,
                    MPI_DOUBLE,
                    MPI_SUM,
                    communicator);

    if (strains)
      strain_so_far.add(state.time,
                        strains->axes(),
                        &row[column - strains->axes().size()]);
    column = add_plates(solution, column);
    for (const double energy : energy_values(record))
      row[column++] = energy;
    AssertDimension(column, row.size());

    rotation_so_far =
      std::max(rotation_so_far,
               largest_node_rotation(state, equations.model().numbering));
    return row;
  }

  std::vector<Column> History::sum_columns() const
  {
    std::vector<Column> columns;
    for (unsigned int i = 0; i < unknown_sums.size(); ++i)
      if (unknown_sums[i].quantity != Quantity::velocity)
        columns.push_back(column_list[n_position_columns + i]);
    return columns;
  }

  std::vector<double> History::sums(const Vector &displacements,
                                    const Vector &reactions) const
  {
    std::vector<double> values;
    for (const UnknownSum &sum : unknown_sums)
      {
        if (sum.quantity == Quantity::velocity)
          continue;
        const Vector &unknown_values =
          sum.quantity == Quantity::residual ? reactions : displacements;
        values.push_back(sum.total(
          [&](const int unknown) { return unknown_values[unknown]; }));
      }
    return equations.model().numbering.layout().sum(values);
  }

  void History::note(const State &state)
  {
    record.add(state.energies);
    part_rotations.follow(state);
    for (const SpaceVector &rotation : part_rotations.values())
      rotation_so_far = std::max(rotation_so_far, rotation.norm());
    rotation_vectors.follow(state);
    rotation_so_far = std::max(rotation_so_far, rotation_vectors.largest());
  }

  void History::serialize(const State &state, CheckpointArchive &archive)
  {
    record.serialize(state.energies, archive);
    part_rotations.serialize(archive);
    rotation_vectors.serialize(state, archive);
    strain_so_far.serialize(archive);
    rotation_so_far =
      dealii::Utilities::MPI::max(rotation_so_far, communicator);
    archive.values("output: largest rotation", rotation_so_far);
  }

  void require_existing_columns(const Scene &scene, const Lattice &lattice)
  {
    if (scene.output.effective_strains)
      EffectiveStrains::check(lattice);
    for (const ProbeDefinition &probe : scene.output.probes)
      if (RigidPartProbe::is_rigid_part_probe(probe))
        RigidPartProbe::check(probe, scene, lattice);
      else
        select_joints(lattice, probe.selection, scene.context, probe.path);
  }
} // namespace auxfem
