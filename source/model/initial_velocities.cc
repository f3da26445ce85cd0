#include <auxfem/elements/rotation.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/initial_velocities.h>
#include <auxfem/model/line_rule.h>

#include <algorithm>
#include <set>

namespace auxfem
{
  namespace
  {
    using Velocity = std::array<double, n_motion_components>;

    /** Of a point of a body that moves with @p velocity at @p centre. */
    Velocity velocity_at(const dealii::Point<3> &point,
                         const dealii::Point<3> &centre,
                         const Velocity         &velocity)
    {
      const SpaceVector turning =
        dealii::cross_product_3d(SpaceVector(
                                   {velocity[3], velocity[4], velocity[5]}),
                                 point - centre);
      Velocity result = velocity;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] += turning[c];
      return result;
    }
  } // namespace

  std::vector<std::pair<int, double>>
  initial_velocities(const Scene        &scene,
                     const Lattice      &lattice,
                     const DofNumbering &numbering)
  {
    const LineRule                      rule(numbering.order());
    const std::vector<unsigned int>    &components = numbering.components();
    const unsigned int                  n          = numbering.n_components();
    std::vector<std::pair<int, double>> velocities;
    // A rigid part turns with a set only if all of it does.
    std::set<int> of_rigid_parts;
    for (const unsigned int p : numbering.constraints().rigid_parts())
      if (lattice.rigid_parts[p].has_rotation)
        for (const unsigned int c : components)
          of_rigid_parts.insert(numbering.constraints().motion(p, c));
    const auto is_of_rigid_part = [&](const int unknown) {
      return of_rigid_parts.count(unknown) > 0;
    };
    for (const InitialVelocityDefinition &definition : scene.initial_velocities)
      {
        const std::vector<unsigned int> joints =
          select_joints(lattice,
                        definition.joints,
                        scene.context,
                        definition.path + "/Joints");
        dealii::Point<3>  centre;
        std::vector<bool> chosen(lattice.joints.size(), false);
        for (const unsigned int joint : joints)
          {
            chosen[joint] = true;
            centre += lattice.joints[joint] / double(joints.size());
          }
        for (const unsigned int joint : joints)
          {
            const Velocity velocity =
              velocity_at(lattice.joints[joint], centre, definition.velocity);
            for (const unsigned int c : components)
              if (numbering.joint_unknown(joint, c) >= 0 &&
                  !is_of_rigid_part(numbering.joint_unknown(joint, c)))
                velocities.emplace_back(numbering.joint_unknown(joint, c),
                                        velocity[c]);
          }
        for (const unsigned int p : numbering.constraints().rigid_parts())
          {
            const RigidPart &part = lattice.rigid_parts[p];
            if (!part.has_rotation ||
                !std::all_of(part.joints.begin(),
                             part.joints.end(),
                             [&](const auto joint) { return chosen[joint]; }))
              continue;
            const Velocity velocity =
              velocity_at(part.centre_of_mass, centre, definition.velocity);
            for (const unsigned int c : components)
              velocities.emplace_back(numbering.constraints().motion(p, c),
                                      velocity[c]);
          }
        for (unsigned int e = 0; e < numbering.elements().size(); ++e)
          {
            const StrutMesh::Place &place = numbering.elements()[e].place;
            const Strut            &strut = lattice.struts[place.strut];
            if (!chosen[strut.joints[0]] || !chosen[strut.joints[1]])
              continue;
            for (unsigned int a = 0; a < rule.nodes.size(); ++a)
              {
                dealii::Point<3>     position;
                dealii::Tensor<1, 3> tangent;
                lattice.axis(strut, place.at(rule.nodes[a]), position, tangent);
                const Velocity velocity =
                  velocity_at(position, centre, definition.velocity);
                for (unsigned int i = 0; i < n; ++i)
                  if (const int unknown =
                        numbering.element_unknowns(e)[n * a + i];
                      !is_of_rigid_part(unknown))
                    velocities.emplace_back(unknown, velocity[components[i]]);
              }
          }
      }
    return velocities;
  }
} // namespace auxfem
