#include <auxfem/mesh/rigid_parts.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/output/rigid_part_probe.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    const std::string prefix = "rigid:";

    struct Selection
    {
      std::vector<unsigned int> parts;
      std::vector<unsigned int> joints; ///< empty: no forces wanted
    };

    Selection select(const ProbeDefinition &definition,
                     const SceneContext    &context,
                     const Lattice         &lattice)
    {
      const std::string text = definition.selection.substr(prefix.size());
      const std::size_t at   = text.find('@');
      Selection         selection;
      selection.parts = rigid_parts_of(
        lattice,
        select_struts(lattice, text.substr(0, at), context, definition.path));
      if (selection.parts.empty())
        throw InputError(definition.path + ": none of the struts \"" +
                         text.substr(0, at) +
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
        throw InputError(
          definition.path + ": none of the joints \"" + text.substr(at + 1) +
          "\" belongs to the rigid parts \"" + text.substr(0, at) + "\".");
      return selection;
    }
  } // namespace

  bool RigidPartProbe::is_one(const ProbeDefinition &definition)
  {
    return definition.selection.compare(0, prefix.size(), prefix) == 0;
  }

  void RigidPartProbe::check(const ProbeDefinition &definition,
                             const SceneContext    &context,
                             const Lattice         &lattice)
  {
    select(definition, context, lattice);
  }

  RigidPartProbe::RigidPartProbe(const ProbeDefinition &definition,
                                 const SceneContext    &context,
                                 const System          &system)
    : name(definition.name)
    , system(system)
  {
    const Lattice  &lattice        = system.lattice();
    const Selection selection      = select(definition, context, lattice);
    has_forces                     = !selection.joints.empty();
    n_parts                        = selection.parts.size();
    const RigidPartConditions &all = *system.rigid_parts();
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
    std::vector<Column> result = {
      {name + ".phi", "rad", "mean rotation of the probe's rigid parts"}};
    if (has_forces)
      for (const char *direction : {"x", "y"})
        result.push_back(
          {name + ".f" + direction,
           "N",
           "sum of the forces of the probe's joints on its rigid "
           "parts along " +
             std::string(direction)});
    return result;
  }

  void RigidPartProbe::follow(const State &state)
  {
    const double turn = 2 * dealii::numbers::PI;
    for (Part &part : parts)
      {
        const double rotation =
          system.rigid_parts()->rotation(part.report, state);
        part.rotation =
          rotation + turn * std::round((part.rotation - rotation) / turn);
      }
  }

  std::vector<double> RigidPartProbe::values(const State &state) const
  {
    std::vector<double> result(has_forces ? 3 : 1, 0.);
    for (const Part &part : parts)
      {
        result[0] += part.rotation / n_parts;
        if (!has_forces)
          continue;
        const RigidPartReport report =
          system.rigid_parts()->report(part.report, state);
        for (const unsigned int joint : part.joints)
          for (unsigned int c = 0; c < 2; ++c)
            result[1 + c] += report.forces[joint][c];
      }
    return result;
  }
} // namespace auxfem
