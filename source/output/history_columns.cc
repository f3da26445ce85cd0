#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/mean_stress.h>
#include <auxfem/output/history.h>
#include <auxfem/output/member_forces.h>

#include <algorithm>

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
  } // namespace

  History::History(const Scene     &scene,
                   const Equations &equations,
                   const MPI_Comm   communicator)
    : equations(equations)
    , communicator(communicator)
    , part_rotations(equations)
    , support_moments(scene, equations)
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
        {
          define_support(support);
          define_moved_support(scene, support);
        }
    define_plate_rates(scene);
    for (const RigidPartProbe &probe : rigid_part_probes)
      for (const Column &column : probe.columns())
        column_list.push_back(column);
    for (const Column &column : support_moments.columns())
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
    for (const StressProbeDefinition &definition : scene.figures.stresses)
      {
        stress_probes.emplace_back(definition, scene, equations);
        for (const Column &column : stress_probes.back().columns())
          column_list.push_back(column);
      }
    for (const Column &column : energy_columns(equations.layout().energies))
      column_list.push_back(column);
    n_recorded_columns = column_list.size();
    // Amplitudes are not combined by expressions.
    if (!is_linearized(scene.analysis))
      define_derived_columns(scene.output.columns);
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
    define_rates(probe, joints);
  }

  void History::define_rates(const ProbeDefinition           &probe,
                             const std::vector<unsigned int> &joints)
  {
    if (!equations.model().plan.simulated.inertia)
      return;
    const unsigned int dimension = equations.model().lattice.dimension;
    for (unsigned int c = 0; c < dimension; ++c)
      define_mean(probe,
                  joints,
                  {"v" + axis_name(c), "m/s", "velocity along " + axis_name(c)},
                  Quantity::velocity,
                  c);
    for (unsigned int c = 0; c < dimension; ++c)
      define_mean(probe,
                  joints,
                  {"a" + axis_name(c),
                   "m/s2",
                   "acceleration along " + axis_name(c)},
                  Quantity::acceleration,
                  c);
  }

  void History::define_plate_rates(const Scene &scene)
  {
    const Lattice &lattice = equations.model().lattice;
    for (const PlateDefinition &plate : scene.plates)
      {
        const auto &support = plate.support;
        bool        is_held = support.has_value();
        for (unsigned int c = 0; is_held && c < lattice.dimension; ++c)
          is_held = support->fixed[c] && support->motion[c].is_zero();
        if (!is_held)
          define_rates({plate.name, plate.name, plate.path},
                       lattice.joint_sets.at(plate.name));
      }
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

  void History::define_moved_support(const Scene &scene, const Support &support)
  {
    const auto has_name = [&support](const auto &definition) {
      return definition.name == support.name;
    };
    const std::vector<ProbeDefinition> &probes = scene.output.probes;
    if (std::any_of(probes.begin(), probes.end(), has_name) ||
        std::any_of(scene.plates.begin(), scene.plates.end(), has_name))
      return;
    const UnknownLayout &layout = equations.model().numbering.layout();
    for (unsigned int c = 0; c < equations.model().lattice.dimension; ++c)
      if (!support.motion[c].is_zero())
        {
          UnknownSum mean{Quantity::displacement, {}, 1.};
          for (const Support::PrescribedUnknown &prescribed : support.unknowns)
            if (prescribed.component == c &&
                layout.is_owned(prescribed.unknown))
              mean.unknowns.push_back(prescribed.unknown);
          const double n = layout.sum(double(mean.unknowns.size()));
          mean.factor    = n > 0 ? 1 / n : 1;
          unknown_sums.push_back(std::move(mean));
          column_list.push_back(
            {support.name + ".u" + axis_name(c),
             "m",
             "displacement of the support along " + axis_name(c)});
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

  void
  History::define_derived_columns(const std::vector<DerivedColumn> &definitions)
  {
    if (definitions.empty())
      return;
    std::vector<std::string> names;
    for (const Column &column : column_list)
      names.push_back(column.name);
    derived_values.emplace(definitions, names);
    for (const DerivedColumn &column : definitions)
      column_list.push_back({column.name, column.unit, column.expression});
  }

  void require_existing_columns(const Scene &scene, const Lattice &lattice)
  {
    if (scene.output.effective_strains)
      EffectiveStrains::check(lattice);
    for (const StressProbeDefinition &definition : scene.figures.stresses)
      StressProbe::check(definition, scene, lattice);
    MemberForces::check(scene, lattice);
    for (const ProbeDefinition &probe : scene.output.probes)
      if (RigidPartProbe::is_rigid_part_probe(probe))
        RigidPartProbe::check(probe, scene, lattice);
      else
        select_joints(lattice, probe.selection, scene.context, probe.path);
  }
} // namespace auxfem
