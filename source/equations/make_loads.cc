#include <auxfem/equations/effects/applied_loads.h>
#include <auxfem/equations/effects/follower_loads.h>
#include <auxfem/equations/make_loads.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/line_rule.h>
#include <auxfem/model/proportional_loads.h>
#include <auxfem/model/unknown_names.h>
#include <auxfem/parameters/errors.h>

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

    /** Entry of the energy ledger for the work of the load @p name. */
    EnergyEntry work_of(const std::string &name)
    {
      return {EnergyKind::work,
              name + ".load_work",
              "work of the load since the start"};
    }

    void add_dead_load(const JointLoadDefinition &definition,
                       const Lattice             &lattice,
                       const DofNumbering        &numbering,
                       const Scene               &scene,
                       AppliedLoads              &loads)
    {
      const std::vector<unsigned int> joints =
        select_joints(lattice,
                      definition.joints,
                      scene.context,
                      definition.path + "/Joints");
      for (const unsigned int c : numbering.components())
        {
          if (definition.components[c].is_zero())
            continue;
          const unsigned int load =
            loads.add_load(proportional(definition.components[c], scene),
                           work_of(definition.name));
          for (const unsigned int joint : joints)
            {
              if (!numbering.joint_has(joint, c))
                throw InputError(definition.path + "/Moment " +
                                 "xyz"[c - first_rotation] + ": " +
                                 why_no_rotation(numbering, joint));
              const int unknown = numbering.joint_unknown(joint, c);
              if (unknown >= 0)
                loads.add_weight(load, unknown, 1.);
            }
        }
    }

    void add_follower_load(const JointLoadDefinition &definition,
                           const Lattice             &lattice,
                           const DofNumbering        &numbering,
                           const Scene               &scene,
                           FollowerLoads             &loads)
    {
      auto components = definition.components;
      for (TimeFunction &component : components)
        component = proportional(component, scene);
      const unsigned int load =
        loads.add_load(components, work_of(definition.name));
      for (const unsigned int joint :
           select_joints(lattice,
                         definition.joints,
                         scene.context,
                         definition.path + "/Joints"))
        {
          if (!numbering.joint_has(joint, rotation_z))
            throw InputError(definition.path +
                             "/Direction = follows the joint: " +
                             why_no_rotation(numbering, joint));
          if (numbering.joint_unknown(joint, rotation_z) >= 0)
            loads.add_joint(load, joint);
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
      const unsigned int n = numbering.n_components();
      for (const DofNumbering::Group &group : numbering.groups())
        {
          const LineRule rule(group.order);
          for (unsigned int e = group.begin; e < group.end; ++e)
            {
              const StrutMesh::Interval &interval =
                numbering.elements()[e].interval;
              if (!chosen[interval.strut])
                continue;
              const Strut &strut = lattice.struts[interval.strut];
              const double force = per_length(strut) * lattice.length(strut) *
                (interval.end - interval.begin) / 2;
              for (unsigned int a = 0; a < rule.integrals.size(); ++a)
                loads.add_weight(load,
                                 numbering.element_unknowns(e)[n * a + c],
                                 force * rule.integrals[a]);
            }
        }
    }

    /** Adds @p force, by its @p shares. */
    void add_shares(const unsigned int load,
                    const ForceShares &shares,
                    const double       force,
                    AppliedLoads      &loads)
    {
      for (const auto &[unknown, share] : shares)
        loads.add_weight(load, unknown, force * share);
    }

    /** Calls @p action for the rigid parts of all kinds. */
    template <class Action>
    void for_each_body(const RigidBodies &bodies, const Action &action)
    {
      std::for_each(bodies.in_plane.begin(), bodies.in_plane.end(), action);
      std::for_each(bodies.bars.begin(), bodies.bars.end(), action);
      std::for_each(bodies.rotating.begin(), bodies.rotating.end(), action);
    }

    /** Adds a unit force per length along component @p c of the chosen rigid struts. */
    void add_along_rigid_struts(const unsigned int       load,
                                const unsigned int       c,
                                const std::vector<bool> &chosen,
                                const Lattice           &lattice,
                                const DofNumbering      &numbering,
                                const RigidBodies       &bodies,
                                AppliedLoads            &loads)
    {
      for_each_body(bodies, [&](const auto &body) {
        for (const unsigned int number : lattice.rigid_parts[body.part].struts)
          if (const Strut &strut = lattice.struts[number]; chosen[number])
            add_shares(load,
                       force_shares(body,
                                    lattice,
                                    numbering,
                                    lattice.centroid(strut),
                                    c),
                       lattice.length(strut),
                       loads);
      });
    }

    void add_line_loads(const Scene        &scene,
                        const Lattice      &lattice,
                        const DofNumbering &numbering,
                        const RigidBodies  &bodies,
                        AppliedLoads       &loads)
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
          for (const RigidPart &part : lattice.rigid_parts)
            for (const unsigned int strut : part.struts)
              if (chosen[strut])
                refuse_point_beside(part,
                                    lattice,
                                    lattice.centroid(lattice.struts[strut]));
          for (unsigned int c = 0; c < lattice.dimension; ++c)
            {
              if (definition.components[c].is_zero())
                continue;
              const unsigned int load =
                loads.add_load(proportional(definition.components[c], scene),
                               work_of(definition.name));
              add_along_struts(
                load,
                c,
                chosen,
                lattice,
                numbering,
                [](const Strut &) { return 1.; },
                loads);
              add_along_rigid_struts(load,
                                     c,
                                     chosen,
                                     lattice,
                                     numbering,
                                     bodies,
                                     loads);
            }
        }
    }

    void add_gravity(const Scene                &scene,
                     const Lattice              &lattice,
                     const DofNumbering         &numbering,
                     const std::vector<Section> &sections,
                     const RigidBodies          &bodies,
                     AppliedLoads               &loads)
    {
      const std::vector<bool> all(lattice.struts.size(), true);
      for (unsigned int c = 0; c < lattice.dimension; ++c)
        {
          if (scene.gravity[c] == 0)
            continue;
          const unsigned int load = loads.add_load(
            proportional(constant(scene.gravity[c], scene.context), scene),
            {EnergyKind::work,
             "gravity_work",
             "work of the weight since the start"});
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
          for_each_body(bodies, [&](const auto &body) {
            const RigidPart &part = lattice.rigid_parts[body.part];
            add_shares(
              load,
              force_shares(body, lattice, numbering, part.centre_of_mass, c),
              part.mass,
              loads);
          });
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

  std::vector<std::unique_ptr<Effect>>
  make_loads(const Scene                &scene,
             const Lattice              &lattice,
             const DofNumbering         &numbering,
             const std::vector<Section> &sections,
             const RigidBodies          &bodies,
             const SimulatedEffects     &simulated)
  {
    const bool raised_from_zero =
      !scene.time.scheme->is_dynamic() && !scene.time.static_start;
    auto dead = std::make_unique<AppliedLoads>(numbering, raised_from_zero);
    auto follower_loads =
      std::make_unique<FollowerLoads>(lattice, numbering, raised_from_zero);
    for (const JointLoadDefinition &load : scene.joint_loads)
      // Without large rotations nothing turns.
      if (load.follows_joint && simulated.large_rotation)
        add_follower_load(load, lattice, numbering, scene, *follower_loads);
      else
        add_dead_load(load, lattice, numbering, scene, *dead);
    add_line_loads(scene, lattice, numbering, bodies, *dead);
    if (simulated.gravity)
      add_gravity(scene, lattice, numbering, sections, bodies, *dead);
    std::vector<std::unique_ptr<Effect>> effects;
    if (!dead->empty())
      effects.push_back(std::move(dead));
    if (!follower_loads->empty())
      effects.push_back(std::move(follower_loads));
    return effects;
  }
} // namespace auxfem
