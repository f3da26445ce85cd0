#include <auxfem/equations/node_rotations.h>
#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/numbering.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/output/probes.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Largest accepted change (rad) of a rotation vector; beyond, the output
     * would jump.
     */
    constexpr double max_change = 1;

    /**
     * Rotation vector of @p rotation nearest to @p expected. After several
     * turns about an axis that has tilted since, all equivalent vectors are far
     * away. Then @p expected is kept, which counts the turns.
     */
    SpaceVector continued_rotation_vector(const Quaternion  &rotation,
                                          const SpaceVector &expected)
    {
      const SpaceVector nearest = rotation_vector_near(rotation, expected);
      return (nearest - expected).norm() < max_change ? nearest : expected;
    }

    /** Position of the rotation with @p index, or of its insertion. */
    template <class Rotations>
    auto find_rotation(Rotations &rotations, const unsigned int index)
    {
      return std::lower_bound(rotations.begin(),
                              rotations.end(),
                              index,
                              [](const auto &rotation, const unsigned int i) {
                                return rotation.index < i;
                              });
    }
  } // namespace

  RotationVectors::RotationVectors(const LatticeModel &model) : model(model)
  {}

  void RotationVectors::choose(const int unknown)
  {
    const unsigned int index = model.numbering.rotations().with(unknown);
    const auto         next  = find_rotation(rotations, index);
    if (next == rotations.end() || next->index != index)
      rotations.insert(next, {index, {}, {}});
  }

  void RotationVectors::follow(const State &state)
  {
    const NodeRotations node_rotations(model.numbering);
    for (Rotation &rotation : rotations)
      {
        const SpaceVector entries =
          node_rotations.values(state.displacement, rotation.index);
        if (state.rotations.empty())
          rotation.vector = entries;
        else
          {
            const Quaternion &now = state.rotations[rotation.index];
            rotation.vector       = continued_rotation_vector(
              now,
              rotation.vector + rotated(now, entries - rotation.entries));
          }
        rotation.entries = entries;
      }
  }

  std::vector<unsigned int> RotationVectors::numbers() const
  {
    const std::vector<unsigned int> serial_numbers =
      rotation_numbers(model.lattice, model.numbering);
    std::vector<unsigned int> chosen;
    for (const Rotation &rotation : rotations)
      chosen.push_back(serial_numbers[rotation.index]);
    return chosen;
  }

  void RotationVectors::serialize(const State       &state,
                                  CheckpointArchive &archive)
  {
    std::vector<double> vectors;
    for (const Rotation &rotation : rotations)
      vectors.insert(vectors.end(),
                     rotation.vector.begin_raw(),
                     rotation.vector.end_raw());
    archive.items("output: rotation vectors", numbers(), 3, vectors);
    for (unsigned int i = 0; i < rotations.size(); ++i)
      {
        std::copy_n(vectors.begin() + 3 * i,
                    3,
                    rotations[i].vector.begin_raw());
        rotations[i].entries =
          NodeRotations(model.numbering)
            .values(state.displacement, rotations[i].index);
      }
  }

  double RotationVectors::operator[](const int unknown) const
  {
    const SpatialRotations &all   = model.numbering.rotations();
    const unsigned int      index = all.with(unknown);
    const auto              found = find_rotation(rotations, index);
    Assert(found != rotations.end() && found->index == index,
           dealii::ExcMessage("the rotation was not chosen"));
    return found->vector[all.axis(unknown)];
  }

  double RotationVectors::largest() const
  {
    double angle = 0;
    for (const Rotation &rotation : rotations)
      angle = std::max(angle, rotation.vector.norm());
    return angle;
  }

  namespace
  {
    const std::string prefix = "rigid:";

    struct Selection
    {
      std::vector<unsigned int> parts;
      std::vector<unsigned int> joints; ///< empty: no forces requested
    };

    /** Parts of the definition @p name; empty if it does not exist. */
    std::vector<unsigned int> parts_named(const std::string &name,
                                          const Scene       &scene,
                                          const Lattice     &lattice)
    {
      std::vector<unsigned int> parts;
      for (unsigned int p = 0; p < lattice.rigid_parts.size(); ++p)
        if (scene.rigid_parts[lattice.rigid_parts[p].definition].name == name)
          parts.push_back(p);
      return parts;
    }

    Selection select(const ProbeDefinition &definition,
                     const Scene           &scene,
                     const Lattice         &lattice)
    {
      const SceneContext &context = scene.context;
      const std::string   text    = definition.selection.substr(prefix.size());
      const std::size_t   at      = text.find('@');
      const std::string   name    = dealii::Utilities::trim(text.substr(0, at));
      Selection           selection;
      selection.parts = parts_named(name, scene, lattice);
      if (selection.parts.empty())
        selection.parts = rigid_parts_of(
          lattice,
          select_struts(lattice, name, context, definition.path));
      if (selection.parts.empty())
        throw InputError(definition.path + ": none of the struts \"" + name +
                         "\" is rigid. Name struts of Rigid parts.");
      if (at == std::string::npos)
        return selection;
      selection.joints =
        select_joints(lattice, text.substr(at + 1), context, definition.path);
      const auto has_chosen_joint = [&](const unsigned int part) {
        const auto &joints = lattice.rigid_parts[part].joints;
        return std::any_of(joints.begin(), joints.end(), [&](const auto joint) {
          return std::binary_search(selection.joints.begin(),
                                    selection.joints.end(),
                                    joint);
        });
      };
      if (std::none_of(selection.parts.begin(),
                       selection.parts.end(),
                       has_chosen_joint))
        throw InputError(definition.path + ": none of the joints \"" +
                         dealii::Utilities::trim(text.substr(at + 1)) +
                         "\" belongs to the rigid parts \"" + name + "\".");
      return selection;
    }
  } // namespace

  RigidPartRotations::RigidPartRotations(const Equations &equations)
    : equations(equations)
  {
    if (equations.reporting().rigid_parts)
      rotations.assign(equations.reporting().rigid_parts->n_reported(),
                       SpaceVector());
  }

  void RigidPartRotations::follow(const State &state)
  {
    const double full_circle = 2 * dealii::numbers::PI;
    for (unsigned int i = 0; i < rotations.size(); ++i)
      {
        const SpaceVector now =
          equations.reporting().rigid_parts->rotation(i, state);
        if (equations.model().lattice.dimension == 2)
          rotations[i][2] = now[2] +
            full_circle * std::round((rotations[i][2] - now[2]) / full_circle);
        else
          rotations[i] = rotation_vector_near(exponential(now), rotations[i]);
      }
  }

  std::vector<unsigned int> RigidPartRotations::parts() const
  {
    std::vector<unsigned int> numbers(rotations.size());
    for (unsigned int i = 0; i < rotations.size(); ++i)
      numbers[i] = equations.reporting().rigid_parts->part(i);
    return numbers;
  }

  void RigidPartRotations::serialize(CheckpointArchive &archive)
  {
    std::vector<double> components;
    for (const SpaceVector &rotation : rotations)
      components.insert(components.end(),
                        rotation.begin_raw(),
                        rotation.end_raw());
    archive.items("output: rotations of rigid parts", parts(), 3, components);
    for (unsigned int i = 0; i < rotations.size(); ++i)
      std::copy_n(components.begin() + 3 * i, 3, rotations[i].begin_raw());
  }

  bool RigidPartProbe::is_rigid_part_probe(const ProbeDefinition &definition)
  {
    return definition.selection.compare(0, prefix.size(), prefix) == 0;
  }

  void RigidPartProbe::check(const ProbeDefinition &definition,
                             const Scene           &scene,
                             const Lattice         &lattice)
  {
    select(definition, scene, lattice);
  }

  RigidPartProbe::RigidPartProbe(const ProbeDefinition &definition,
                                 const Scene           &scene,
                                 const Equations       &equations)
    : name(definition.name)
    , equations(equations)
  {
    const Lattice  &lattice   = equations.model().lattice;
    const Selection selection = select(definition, scene, lattice);
    n_dimensions              = lattice.dimension;
    has_forces                = !selection.joints.empty();
    n_parts                   = selection.parts.size();
    const RigidPartGroup &all = *equations.reporting().rigid_parts;
    for (unsigned int i = 0; i < all.n_reported(); ++i)
      {
        if (!std::binary_search(selection.parts.begin(),
                                selection.parts.end(),
                                all.part(i)))
          continue;
        Part        part{i, {}};
        const auto &joints = lattice.rigid_parts[all.part(i)].joints;
        for (unsigned int k = 0; k < joints.size(); ++k)
          if (std::binary_search(selection.joints.begin(),
                                 selection.joints.end(),
                                 joints[k]))
            part.joints.push_back(k);
        parts.push_back(part);
      }
  }

  std::vector<Column> RigidPartProbe::columns() const
  {
    std::vector<Column> result;
    if (n_dimensions == 2)
      result.push_back(
        {name + ".phi", "rad", "mean rotation of the probe's rigid parts"});
    else
      for (const std::string direction : {"x", "y", "z"})
        result.push_back({name + ".phi_" + direction,
                          "rad",
                          "mean rotation vector of the probe's rigid parts "
                          "along " +
                            direction});
    if (has_forces)
      for (const std::string direction : {"x", "y", "z"})
        if (direction != "z" || n_dimensions == 3)
          result.push_back(
            {name + ".f" + direction,
             "N",
             "sum of the forces of the probe's joints on its rigid "
             "parts along " +
               direction});
    return result;
  }

  std::vector<double>
  RigidPartProbe::values(const State              &state,
                         const RigidPartRotations &rotations) const
  {
    const unsigned int  n_rotations = n_dimensions == 2 ? 1 : 3;
    std::vector<double> result(n_rotations + (has_forces ? n_dimensions : 0),
                               0.);
    for (const Part &part : parts)
      {
        // In the plane only the last component exists.
        for (unsigned int c = 0; c < n_rotations; ++c)
          result[c] +=
            rotations.values()[part.report][3 - n_rotations + c] / n_parts;
        if (!has_forces)
          continue;
        const RigidPartReport report =
          equations.reporting().rigid_parts->report(part.report, state);
        for (const unsigned int joint : part.joints)
          for (unsigned int c = 0; c < n_dimensions; ++c)
            result[n_rotations + c] += report.forces[joint][c];
      }
    return result;
  }
} // namespace auxfem
