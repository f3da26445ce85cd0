#include <auxfem/mesh/sets.h>
#include <auxfem/output/effective_strains.h>
#include <auxfem/output/member_forces.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/scene/step_ends.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    const std::string member_table_length =
      "output: length of member_forces.csv";

    std::vector<unsigned int> chosen_struts(const Scene   &scene,
                                            const Lattice &lattice)
    {
      return select_struts(lattice,
                           scene.figures.member_forces->struts,
                           scene.context,
                           scene.figures.member_forces->path);
    }

    void append(const dealii::Tensor<1, 3> &vector,
                const unsigned int          n,
                std::vector<double>        &row)
    {
      for (unsigned int d = 0; d < n; ++d)
        row.push_back(vector[d]);
    }
  } // namespace

  MemberForces::MemberForces(const Scene                &scene,
                             const Equations            &equations,
                             const MPI_Comm              communicator,
                             const CheckpointData *const checkpoint)
    : definition(*scene.figures.member_forces)
    , equations(equations)
    , communicator(communicator)
    , nearness(step_end_tolerance(scene.time))
    , stresses(equations.model())
    , is_chosen(equations.model().lattice.struts.size(), false)
  {
    for (const unsigned int strut :
         chosen_struts(scene, equations.model().lattice))
      is_chosen[strut] = true;
    on_first_rank(communicator, [&]() {
      const std::string path = scene.output.directory + "/" + table_name;
      if (checkpoint != nullptr)
        table.emplace(path + ".csv",
                      columns(),
                      checkpoint->values(member_table_length, 1)[0]);
      else
        table.emplace(path + ".csv", columns());
      write_column_reference(path + ".units.csv", columns());
    });
  }

  void MemberForces::check(const Scene &scene, const Lattice &lattice)
  {
    if (scene.figures.member_forces)
      chosen_struts(scene, lattice);
  }

  std::optional<double> MemberForces::after(const double time) const
  {
    for (const double candidate : definition.times)
      if (candidate > time + nearness)
        return candidate;
    return std::nullopt;
  }

  bool MemberForces::has(const double time) const
  {
    return std::any_of(definition.times.begin(),
                       definition.times.end(),
                       [&](const double candidate) {
                         return std::abs(candidate - time) <= 2 * nearness;
                       });
  }

  std::vector<Column> MemberForces::columns() const
  {
    const bool          planar = equations.model().lattice.dimension == 2;
    std::vector<Column> result = {{"time", "s", "time, or position on a path"},
                                  {"strut", "", "number of the strut"},
                                  {"position",
                                   "1",
                                   "place along it, from 0 to 1"}};
    for (unsigned int d = 0; d < (planar ? 2 : 3); ++d)
      result.push_back(
        {axis_name(d), "m", "coordinate at rest along " + axis_name(d)});
    for (unsigned int d = 0; d < (planar ? 2 : 3); ++d)
      result.push_back(
        {"u" + axis_name(d), "m", "displacement along " + axis_name(d)});
    result.push_back({"axial_force", "N", "positive in tension"});
    if (planar)
      {
        result.push_back({"shear_force", "N", "along axis 2"});
        result.push_back({"bending_moment", "N m", "about axis 3"});
      }
    else
      {
        result.push_back({"shear_force_2", "N", "along axis 2"});
        result.push_back({"shear_force_3", "N", "along axis 3"});
        result.push_back({"torque", "N m", "about the axis"});
        result.push_back({"bending_moment_2", "N m", "about axis 2"});
        result.push_back({"bending_moment_3", "N m", "about axis 3"});
      }
    result.push_back({"von_mises_stress",
                      "Pa",
                      "largest of the section; nan: its shape is not known"});
    return result;
  }

  std::vector<double> MemberForces::own_rows(const State &state) const
  {
    const DofNumbering &numbering = equations.model().numbering;
    const unsigned int  dimension = equations.model().lattice.dimension;
    std::vector<double> rows;
    for (const StrutGroup &group : equations.reporting().struts)
      for (unsigned int e = group.forces->elements().begin;
           e < group.forces->elements().end;
           ++e)
        {
          const DofNumbering::Element &element = numbering.elements()[e];
          if (!element.is_owned || !is_chosen[element.interval.strut])
            continue;
          const unsigned int n    = definition.points;
          unsigned int       next = 0;
          for (const StrutPoint &point : group.forces->sample(state, e, n))
            {
              const double part =
                element.interval.at(-1 + 2. * next++ / (n - 1));
              rows.push_back(state.time);
              rows.push_back(element.interval.strut);
              rows.push_back(part);
              append(point.position, dimension, rows);
              append(point.displacement, dimension, rows);
              rows.push_back(point.force[0]);
              rows.push_back(point.force[1]);
              if (dimension == 3)
                {
                  rows.push_back(point.force[2]);
                  append(point.moment, 3, rows);
                }
              else
                rows.push_back(point.moment[2]);
              rows.push_back(
                stresses.at(point, element.interval.strut, part).von_mises);
            }
        }
    return rows;
  }

  void MemberForces::write(const State &state)
  {
    if (last_time && *last_time == state.time)
      return;
    last_time = state.time;
    const auto all =
      dealii::Utilities::MPI::gather(communicator, own_rows(state));
    const std::size_t n = columns().size();
    on_first_rank(communicator, [&]() {
      std::vector<std::vector<double>> rows;
      for (const std::vector<double> &numbers : all)
        for (std::size_t i = 0; i < numbers.size(); i += n)
          rows.emplace_back(numbers.begin() + i, numbers.begin() + i + n);
      std::sort(rows.begin(), rows.end(), [](const auto &a, const auto &b) {
        return a[1] < b[1] || (a[1] == b[1] && a[2] < b[2]);
      });
      for (const std::vector<double> &row : rows)
        table->append(row);
    });
  }

  void MemberForces::serialize(CheckpointArchive &archive)
  {
    double length = table ? table->length() : 0;
    archive.values(member_table_length, length);
  }
} // namespace auxfem
