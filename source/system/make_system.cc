#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/system/effects/point_masses.h>
#include <auxfem/system/effects/rotational_springs.h>
#include <auxfem/system/make_loads.h>
#include <auxfem/system/system.h>

#include <algorithm>
#include <map>

namespace auxfem
{
  namespace
  {
    /** The struts whose ends a `Joints/NAME` releases, by joint. */
    struct Release
    {
      const JointDefinition *definition;
      std::vector<
        std::pair<unsigned, std::vector<std::pair<unsigned, unsigned>>>>
        ends_at_joint; ///< joint, then (strut, end)
    };

    std::vector<Release> collect_releases(const Scene   &scene,
                                          const Lattice &lattice)
    {
      std::vector<std::vector<std::pair<unsigned, unsigned>>> ends_at(
        lattice.joints.size());
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        for (unsigned int end = 0; end < 2; ++end)
          ends_at[lattice.struts[s].joints[end]].emplace_back(s, end);

      std::vector<Release> releases;
      for (const JointDefinition &definition : scene.joints)
        {
          std::vector<bool> chosen(lattice.struts.size(), false);
          for (const unsigned int s :
               select_struts(lattice,
                             definition.struts,
                             scene.context,
                             definition.path + "/Struts"))
            chosen[s] = true;
          Release release{&definition, {}};
          for (const unsigned int joint :
               select_joints(lattice,
                             definition.joints,
                             scene.context,
                             definition.path + "/Joints"))
            {
              std::vector<std::pair<unsigned, unsigned>> ends;
              for (const auto &end : ends_at[joint])
                if (chosen[end.first])
                  ends.push_back(end);
              if (ends.empty())
                throw InputError(definition.path + ": no strut of '" +
                                 definition.struts + "' ends at joint " +
                                 std::to_string(joint) +
                                 ". Name struts that end at all these joints.");
              release.ends_at_joint.emplace_back(joint, ends);
            }
          releases.push_back(release);
        }
      return releases;
    }

    /** What a released strut end turns against. */
    struct SpringBase
    {
      /** -1 without `is_ground`: not on this rank. */
      int  unknown   = -1;
      bool is_ground = false;
    };

    /**
     * The rotation springs at a joint act against: that of the joint if a strut
     * is rigid there, else that of the first of several released struts, else,
     * for a strut alone, the ground.
     */
    SpringBase
    spring_base(const unsigned int                                joint,
                const std::vector<std::pair<unsigned, unsigned>> &ends,
                const DofNumbering                               &numbering)
    {
      if (numbering.joint_has(joint, 2))
        return {numbering.joint_unknown(joint, 2), false};
      if (ends.size() == 1)
        return {-1, true};
      return {numbering.end_rotation(ends[0].first, ends[0].second), false};
    }

    std::unique_ptr<RotationalSprings>
    make_rotational_springs(const std::vector<Release> &releases,
                            const DofNumbering         &numbering)
    {
      auto springs = std::make_unique<RotationalSprings>(numbering);
      bool is_used = false;
      for (const Release &release : releases)
        if (release.definition->type ==
            JointDefinition::Type::rotational_spring)
          for (const auto &[joint, ends] : release.ends_at_joint)
            {
              const SpringBase base = spring_base(joint, ends, numbering);
              for (const auto &[strut, end] : ends)
                {
                  const int rotation = numbering.end_rotation(strut, end);
                  if (rotation < 0 || rotation == base.unknown ||
                      (base.unknown < 0 && !base.is_ground))
                    continue;
                  springs->add(base.unknown,
                               rotation,
                               release.definition->stiffness);
                  is_used = true;
                }
            }
      return is_used ? std::move(springs) : nullptr;
    }

    double mean_strut_length(const Lattice &lattice)
    {
      double sum = 0;
      for (const Strut &strut : lattice.struts)
        sum += lattice.length(strut);
      return lattice.struts.empty() ? 1. : sum / lattice.struts.size();
    }
  } // namespace

  System::System(const Scene   &scene,
                 const Lattice &lattice,
                 const MPI_Comm communicator)
    : graph(lattice)
    , simulated(decide_effects(scene))
    , mean_length(mean_strut_length(lattice))
  {
    for (const SectionDefinition &definition : scene.sections)
      section_list.push_back(definition.section);
    state_layout.velocity = state_layout.acceleration = simulated.inertia;

    make_numbering(scene, communicator);
    make_supports(scene);
    make_effects(scene);
    if (simulated.inertia)
      initial_velocities = auxfem::initial_velocities(scene, graph, *dofs);
  }

  void System::make_numbering(const Scene &scene, const MPI_Comm communicator)
  {
    mesh = std::make_unique<StrutMesh>(graph,
                                       scene.discretization.refinements,
                                       communicator);
    Ties ties;
    ties.released.assign(graph.struts.size(), {{false, false}});
    if (simulated.hinges)
      for (const Release &release : collect_releases(scene, graph))
        for (const auto &[joint, ends] : release.ends_at_joint)
          {
            for (const auto &[strut, end] : ends)
              ties.released[strut][end] = true;
            if (release.definition->type ==
                JointDefinition::Type::rotational_spring)
              ties.sprung_joints.push_back(joint);
          }
    for (const ConnectorDefinition &definition : scene.connectors)
      {
        const std::vector<JointPair> pairs =
          select_pairs(graph,
                       definition.between,
                       scene.context,
                       definition.path + "/Between");
        ties.connected.insert(ties.connected.end(), pairs.begin(), pairs.end());
      }
    dofs = std::make_unique<DofNumbering>(graph,
                                          *mesh,
                                          scene.discretization.order,
                                          ties,
                                          communicator);
  }

  void System::make_supports(const Scene &scene)
  {
    struct Holder
    {
      const SupportDefinition *support;
      bool                     at_rest;
    };
    std::map<std::pair<unsigned, unsigned>, Holder> holders;
    for (const SupportDefinition &definition : scene.supports)
      {
        Support support{definition.name, {}, definition.motion};
        for (const unsigned int joint :
             select_joints(graph,
                           definition.joints,
                           scene.context,
                           definition.path + "/Joints"))
          for (unsigned int c = 0; c < 3; ++c)
            {
              if (!definition.fixed[c])
                continue;
              const bool at_rest = definition.motion[c].is_zero();
              if (!dofs->joint_has(joint, c))
                {
                  if (at_rest)
                    continue;
                  throw InputError(
                    definition.path + "/Rotation: joint " +
                    std::to_string(joint) +
                    " has no rotation of its own, because every strut "
                    "is released there. Leave one strut unreleased.");
                }
              const auto [holder, is_new] =
                holders.insert({{joint, c}, {&definition, at_rest}});
              if (!is_new)
                {
                  // Two supports may both hold an unknown at rest, as at a
                  // corner.
                  if (at_rest && holder->second.at_rest)
                    continue;
                  const char *names[3] = {"horizontal displacement",
                                          "vertical displacement",
                                          "rotation"};
                  throw InputError(
                    definition.path + ": the " + names[c] + " of joint " +
                    std::to_string(joint) + " is already prescribed by " +
                    holder->second.support->path +
                    ". Take the joint out of one of the two sets.");
                }
              const int unknown = dofs->joint_unknown(joint, c);
              if (unknown < 0)
                continue;
              dofs->prescribe(unknown);
              support.unknowns.push_back({unknown, c});
            }
        support_list.push_back(support);
      }
    rows = dofs->owned_rows();
  }

  void System::make_effects(const Scene &scene)
  {
    StrutModel model;
    model.large_rotation    = simulated.large_rotation;
    model.shear_flexibility = simulated.shear_flexibility;
    const auto any_section  = [this](double Section::*property) {
      return std::any_of(section_list.begin(),
                         section_list.end(),
                         [&](const Section &s) { return s.*property > 0; });
    };
    model.damping = simulated.strut_damping &&
      any_section(&Section::stiffness_proportional_damping);
    state_layout.velocity = state_layout.velocity || model.damping;
    if (!graph.struts.empty())
      {
        auto struts  = StrutForces::make(graph, *dofs, section_list, model);
        strut_forces = struts.get();
        effects.push_back(std::move(struts));
      }
    if (simulated.hinges)
      if (auto springs =
            make_rotational_springs(collect_releases(scene, graph), *dofs))
        effects.push_back(std::move(springs));

    for (const ConnectorDefinition &definition : scene.connectors)
      {
        ConnectorDefinition used = definition;
        if (!simulated.connector_viscosity && definition.law->is_viscous())
          used.law = make_spring_law(definition.law->long_time_stiffness());
        auto group =
          std::make_unique<ConnectorForces>(used,
                                            select_pairs(graph,
                                                         definition.between,
                                                         scene.context,
                                                         definition.path +
                                                           "/Between"),
                                            graph,
                                            *dofs,
                                            simulated.large_rotation,
                                            state_layout);
        connector_groups.push_back(group.get());
        effects.push_back(std::move(group));
      }
    n_internal = effects.size();

    if (simulated.inertia)
      {
        if (!graph.struts.empty())
          effects.push_back(make_strut_inertia(
            graph,
            *dofs,
            section_list,
            simulated.rotary_inertia,
            simulated.strut_damping &&
              any_section(&Section::mass_proportional_damping)));
        const std::vector<UnknownMass> masses =
          point_masses(scene, graph, *dofs);
        if (!masses.empty())
          {
            auto effect = std::make_unique<PointMasses>(*dofs);
            for (const auto &[unknown, mass] : masses)
              effect->add(unknown, mass);
            effects.push_back(std::move(effect));
          }
      }
    n_balanced = effects.size();
    if (auto loads =
          make_loads(scene, graph, *dofs, section_list, simulated.gravity))
      effects.push_back(std::move(loads));
  }
} // namespace auxfem
