#include <auxfem/elements/beam_shape.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/system/effects/applied_loads.h>
#include <auxfem/system/effects/beam_dispatch.h>
#include <auxfem/system/make_loads.h>

#include <algorithm>
#include <cstdio>

namespace auxfem
{
  namespace
  {
    TimeFunction constant(const double value, const SceneContext &context)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.17g", value);
      return TimeFunction(text, "constant", context);
    }

    /** Integrals of the shape functions over [-1, 1] and the nodes there. */
    struct LineRule
    {
      std::vector<double> integrals, nodes;
    };

    LineRule line_rule(const unsigned int order)
    {
      return dispatch_order(order, [](auto p) {
        const BeamShape<p> shape;
        return LineRule{{shape.integral, shape.integral + p + 1},
                        {shape.node, shape.node + p + 1}};
      });
    }

    void add_joint_loads(const Scene        &scene,
                         const Lattice      &lattice,
                         const DofNumbering &numbering,
                         AppliedLoads       &loads)
    {
      for (const JointLoadDefinition &definition : scene.joint_loads)
        {
          const std::vector<unsigned int> joints =
            select_joints(lattice,
                          definition.joints,
                          scene.context,
                          definition.path + "/Joints");
          for (unsigned int c = 0; c < 3; ++c)
            {
              if (definition.components[c].is_zero())
                continue;
              const unsigned int load =
                loads.add_load(definition.components[c]);
              for (const unsigned int joint : joints)
                {
                  if (!numbering.joint_has(joint, c))
                    throw InputError(definition.path + "/Moment: " +
                                     numbering.why_no_rotation(joint));
                  const int unknown = numbering.joint_unknown(joint, c);
                  if (unknown >= 0)
                    loads.add_weight(load, unknown, 1.);
                }
            }
        }
    }

    /** Adds a force per length of @p per_length(strut) along component @p c on all chosen struts. */
    template <class PerLength>
    void add_along_struts(const unsigned int       load,
                          const unsigned int       c,
                          const std::vector<bool> &chosen,
                          const Lattice           &lattice,
                          const DofNumbering      &numbering,
                          const PerLength         &per_length,
                          AppliedLoads            &loads)
    {
      const LineRule     rule = line_rule(numbering.order());
      const unsigned int n    = DofNumbering::n_components;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const StrutMesh::Place &place = numbering.elements()[e].place;
          if (!chosen[place.strut])
            continue;
          const Strut &strut = lattice.struts[place.strut];
          const double force = per_length(strut) * lattice.length(strut) *
            (place.end - place.begin) / 2;
          for (unsigned int a = 0; a < rule.integrals.size(); ++a)
            loads.add_weight(load,
                             numbering.element_unknowns(e)[n * a + c],
                             force * rule.integrals[a]);
        }
    }

    /** Adds a force on a point of a rigid body along component @p c. */
    void add_on_body(const unsigned int  load,
                     const unsigned int  c,
                     const RigidBody    &body,
                     const NaturalPlace &place,
                     const double        force,
                     AppliedLoads       &loads)
    {
      const std::array<double, 4> shares = shape(place, c);
      for (unsigned int i = 0; i < 4; ++i)
        loads.add_weight(load, body.base[i], force * shares[i]);
    }

    /** Adds a unit force per length along component @p c of the chosen rigid struts. */
    void add_along_rigid_struts(const unsigned int            load,
                                const unsigned int            c,
                                const std::vector<bool>      &chosen,
                                const Lattice                &lattice,
                                const std::vector<RigidBody> &bodies,
                                AppliedLoads                 &loads)
    {
      for (const RigidBody &body : bodies)
        {
          const RigidPart &part = lattice.rigid_parts[body.part];
          for (const unsigned int number : part.struts)
            if (chosen[number])
              add_on_body(load,
                          c,
                          body,
                          place_in(part,
                                   lattice,
                                   lattice.centroid(lattice.struts[number])),
                          lattice.length(lattice.struts[number]),
                          loads);
        }
    }

    void add_line_loads(const Scene                  &scene,
                        const Lattice                &lattice,
                        const DofNumbering           &numbering,
                        const std::vector<RigidBody> &bodies,
                        AppliedLoads                 &loads)
    {
      for (const LineLoadDefinition &definition : scene.line_loads)
        {
          std::vector<bool> chosen(lattice.struts.size(), false);
          for (const unsigned int strut :
               select_struts(lattice,
                             definition.struts,
                             scene.context,
                             definition.path + "/Struts"))
            chosen[strut] = true;
          for (unsigned int c = 0; c < 2; ++c)
            {
              if (definition.components[c].is_zero())
                continue;
              const unsigned int load =
                loads.add_load(definition.components[c]);
              add_along_struts(
                load,
                c,
                chosen,
                lattice,
                numbering,
                [](const Strut &) { return 1.; },
                loads);
              add_along_rigid_struts(load, c, chosen, lattice, bodies, loads);
            }
        }
    }

    void add_gravity(const Scene                  &scene,
                     const Lattice                &lattice,
                     const DofNumbering           &numbering,
                     const std::vector<Section>   &sections,
                     const std::vector<RigidBody> &bodies,
                     AppliedLoads                 &loads)
    {
      const std::vector<bool> all(lattice.struts.size(), true);
      for (unsigned int c = 0; c < 2; ++c)
        {
          if (scene.gravity[c] == 0)
            continue;
          const unsigned int load =
            loads.add_load(constant(scene.gravity[c], scene.context));
          add_along_struts(
            load,
            c,
            all,
            lattice,
            numbering,
            [&](const Strut &strut) {
              return sections[strut.section].mass_per_length();
            },
            loads);
          for (const RigidBody &body : bodies)
            add_on_body(load,
                        c,
                        body,
                        body.centre,
                        lattice.rigid_parts[body.part].mass,
                        loads);
          for (const MassDefinition &mass : scene.masses)
            for (const unsigned int joint :
                 select_joints(lattice,
                               mass.joints,
                               scene.context,
                               mass.path + "/Joints"))
              if (numbering.joint_unknown(joint, c) >= 0)
                loads.add_weight(load,
                                 numbering.joint_unknown(joint, c),
                                 mass.mass);
        }
    }
  } // namespace

  std::vector<UnknownMass> point_masses(const Scene        &scene,
                                        const Lattice      &lattice,
                                        const DofNumbering &numbering)
  {
    std::vector<UnknownMass> masses;
    for (const MassDefinition &definition : scene.masses)
      for (const unsigned int joint :
           select_joints(lattice,
                         definition.joints,
                         scene.context,
                         definition.path + "/Joints"))
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double mass =
              c < 2 ? definition.mass : definition.rotary_inertia;
            if (mass > 0 && !numbering.joint_has(joint, c))
              throw InputError(definition.path + "/Rotary inertia: " +
                               numbering.why_no_rotation(joint));
            const int unknown = numbering.joint_unknown(joint, c);
            if (mass > 0 && unknown >= 0)
              masses.emplace_back(unknown, mass);
          }
    return masses;
  }

  std::unique_ptr<Effect> make_loads(const Scene                  &scene,
                                     const Lattice                &lattice,
                                     const DofNumbering           &numbering,
                                     const std::vector<Section>   &sections,
                                     const std::vector<RigidBody> &bodies,
                                     const bool                    gravity)
  {
    if (scene.joint_loads.empty() && scene.line_loads.empty() && !gravity)
      return nullptr;
    auto loads = std::make_unique<AppliedLoads>(numbering,
                                                scene.time.scheme == "static" &&
                                                  !scene.time.static_start);
    add_joint_loads(scene, lattice, numbering, *loads);
    add_line_loads(scene, lattice, numbering, bodies, *loads);
    if (gravity)
      add_gravity(scene, lattice, numbering, sections, bodies, *loads);
    return loads;
  }

  std::vector<std::pair<int, double>>
  initial_velocities(const Scene        &scene,
                     const Lattice      &lattice,
                     const DofNumbering &numbering)
  {
    const LineRule                      rule = line_rule(numbering.order());
    const unsigned int                  n    = DofNumbering::n_components;
    std::vector<std::pair<int, double>> velocities;
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
        const auto &v        = definition.velocity;
        const auto  at_place = [&](const dealii::Point<3> &x,
                                  const unsigned int      c) {
          if (c == 2)
            return v[2];
          return c == 0 ? v[0] - v[2] * (x[1] - centre[1])
                         : v[1] + v[2] * (x[0] - centre[0]);
        };
        for (const unsigned int joint : joints)
          for (unsigned int c = 0; c < n; ++c)
            if (numbering.joint_unknown(joint, c) >= 0)
              velocities.emplace_back(numbering.joint_unknown(joint, c),
                                      at_place(lattice.joints[joint], c));
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
                lattice.axis(strut,
                             place.begin +
                               (place.end - place.begin) * (1 + rule.nodes[a]) /
                                 2,
                             position,
                             tangent);
                for (unsigned int c = 0; c < n; ++c)
                  velocities.emplace_back(numbering.element_unknowns(
                                            e)[n * a + c],
                                          at_place(position, c));
              }
          }
      }
    return velocities;
  }
} // namespace auxfem
