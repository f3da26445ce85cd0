#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/output/history.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
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

  unsigned int History::add_support_moments(const State &state,
                                            unsigned int column)
  {
    for (const double moment : support_moments.values(state))
      row[column++] = moment;
    return column;
  }

  unsigned int History::add_stresses(const State &state, unsigned int column)
  {
    for (const StressProbe &probe : stress_probes)
      for (const double value : probe.values(state, communicator))
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
        case Quantity::acceleration:
          return (*state.acceleration)[unknown];
        default:
          return state.residual[unknown];
      }
  }

  const std::vector<double> &History::values(const Solution &solution)
  {
    const State &state = solution.state;
    note(state);
    row.resize(n_recorded_columns);
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
    column              = add_support_moments(state, column);
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
    column = add_stresses(state, column);
    for (const double energy : energy_values(record))
      row[column++] = energy;
    AssertDimension(column, row.size());
    if (derived_values)
      derived_values->append_to(row);

    rotation_so_far =
      std::max(rotation_so_far,
               largest_node_rotation(state, equations.model().numbering));
    return row;
  }

  std::vector<Column> History::sum_columns() const
  {
    std::vector<Column> columns;
    for (unsigned int i = 0; i < unknown_sums.size(); ++i)
      if (!is_rate(unknown_sums[i].quantity))
        columns.push_back(column_list[n_position_columns + i]);
    return columns;
  }

  std::vector<double> History::sums(const Vector &displacements,
                                    const Vector &reactions) const
  {
    std::vector<double> values;
    for (const UnknownSum &sum : unknown_sums)
      {
        if (is_rate(sum.quantity))
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
} // namespace auxfem
