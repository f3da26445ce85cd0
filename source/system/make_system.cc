#include <auxfem/mesh/sets.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/system/effects/rigid_part_inertia.h>
#include <auxfem/system/effects/strut_inertia.h>
#include <auxfem/system/initial_velocities.h>
#include <auxfem/system/joint_releases.h>
#include <auxfem/system/make_loads.h>
#include <auxfem/system/make_masses.h>
#include <auxfem/system/system.h>

#include <algorithm>
#include <map>

namespace auxfem
{
  namespace
  {
    double mean_strut_length(const Lattice &lattice)
    {
      double sum = 0;
      for (const Strut &strut : lattice.struts)
        sum += lattice.length(strut);
      return lattice.struts.empty() ? 1. : sum / lattice.struts.size();
    }

    /** Whether a strut comes close to the direction of @p reference anywhere. */
    bool leads_along(const Lattice              &lattice,
                     const Strut                &strut,
                     const dealii::Tensor<1, 3> &reference)
    {
      // Of a full circle every 5.6 degrees, where 10 are too close.
      const unsigned int n = strut.sagitta == 0 ? 1 : 64;
      for (unsigned int i = 0; i <= n; ++i)
        {
          dealii::Point<3>     place;
          dealii::Tensor<1, 3> tangent;
          lattice.axis(strut, double(i) / n, place, tangent);
          if (nearly_parallel(tangent, reference))
            return true;
        }
      return false;
    }

    /** A section cannot be oriented by the direction of its strut. */
    void refuse_references_along_struts(const Scene   &scene,
                                        const Lattice &lattice)
    {
      if (lattice.dimension == 2)
        return;
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        {
          const Strut &strut = lattice.struts[s];
          if (strut.is_rigid())
            continue;
          const SectionDefinition &definition = scene.sections[strut.section];
          const auto              &reference  = definition.section.reference;
          if (reference && leads_along(lattice, strut, *reference))
            throw InputError(
              definition.path + "/Reference vector: strut " +
              std::to_string(s) + " (joints " +
              std::to_string(strut.joints[0]) + " - " +
              std::to_string(strut.joints[1]) +
              ") lies along it, or within 5 degrees, so it does not orient its "
              "section. Give another vector, or struts of this direction a "
              "section of their own; auto suits all directions.");
        }
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
    refuse_references_along_struts(scene, graph);
    state_layout.velocity = state_layout.acceleration = simulated.inertia;

    std::vector<JointRelease> releases = simulated.hinges
      ? joint_releases(scene, graph)
      : std::vector<JointRelease>();
    make_numbering(scene, releases, communicator);
    make_supports(scene);
    make_effects(scene, releases);
    if (simulated.inertia)
      initial_velocities = auxfem::initial_velocities(scene, graph, *dofs);
  }

  void System::make_numbering(const Scene               &scene,
                              std::vector<JointRelease> &releases,
                              const MPI_Comm             communicator)
  {
    const StrutMesh mesh(graph, scene.discretization.refinements, communicator);
    Ties            ties;
    ties.released.assign(graph.struts.size(), {{false, false}});
    couple(releases, graph, ties);
    for (const ConnectorDefinition &definition : scene.connectors)
      {
        const std::vector<JointPair> pairs =
          select_pairs(graph,
                       definition.between,
                       scene.context,
                       definition.path + "/Between");
        ties.connected.insert(ties.connected.end(), pairs.begin(), pairs.end());
      }
    dofs           = std::make_unique<DofNumbering>(graph,
                                          mesh,
                                          scene.discretization.order,
                                          ties,
                                          communicator);
    node_rotations = std::make_unique<NodeRotations>(*dofs);
    if (simulated.large_rotation)
      state_layout.n_rotations = dofs->spatial_rotations().size();
  }

  void System::make_supports(const Scene &scene)
  {
    struct Holder
    {
      const SupportDefinition *support;
      bool                     at_rest;
    };
    // Joints of one rigid part may share a rotation.
    std::map<int, Holder> holders;
    for (const SupportDefinition &definition : scene.supports)
      {
        Support support{definition.name, {}, {}, definition.motion};
        for (const unsigned int joint :
             select_joints(graph,
                           definition.joints,
                           scene.context,
                           definition.path + "/Joints"))
          for (const unsigned int c : dofs->components())
            {
              if (!definition.fixed[c])
                continue;
              const bool at_rest = definition.motion[c].is_zero();
              if (!dofs->joint_has(joint, c))
                {
                  // A hinge may be clamped: then its rotation is not there.
                  if (at_rest && !dofs->is_rigid_joint(joint))
                    continue;
                  throw InputError(definition.path + "/Rotation " +
                                   "xyz"[c - first_rotation] + ": " +
                                   dofs->why_no_rotation(joint) +
                                   " Type = pin holds displacements only.");
                }
              const auto [holder, is_new] = holders.insert(
                {dofs->global_number(joint, c), {&definition, at_rest}});
              if (!is_new)
                {
                  // Two supports may both hold an unknown at rest, as at a
                  // corner.
                  if ((at_rest && holder->second.at_rest) ||
                      holder->second.support == &definition)
                    continue;
                  throw InputError(
                    definition.path + ": the " +
                    motion_in_words(c, graph.dimension) + " of joint " +
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
        if (state_layout.n_rotations > 0)
          group_rotations(support);
        support_list.push_back(support);
      }
    rows = dofs->owned_rows();
  }

  void System::group_rotations(Support &support) const
  {
    for (const Support::PrescribedUnknown &prescribed : support.unknowns)
      {
        if (prescribed.component < first_rotation)
          continue;
        const unsigned int rotation =
          dofs->spatial_rotation(prescribed.unknown);
        if (support.rotations.empty() ||
            support.rotations.back().rotation != rotation)
          support.rotations.push_back({rotation, {{false, false, false}}});
        support.rotations.back().fixed[prescribed.component - first_rotation] =
          true;
      }
  }

  void System::make_conditions(const Scene                     &scene,
                               const std::vector<JointRelease> &releases,
                               const RigidBodies               &bodies)
  {
    if (!graph.rigid_parts.empty())
      {
        auto of_parts =
          std::make_unique<RigidPartConditions>(bodies,
                                                graph,
                                                *dofs,
                                                simulated.large_rotation,
                                                simulated.gravity
                                                  ? scene.gravity
                                                  : dealii::Tensor<1, 3>());
        parts = of_parts.get();
        conditions.push_back(parts);
        effects.push_back(std::move(of_parts));
      }
    if (auto hinges = make_revolute_hinges(releases,
                                           *dofs,
                                           simulated.large_rotation,
                                           mean_length))
      {
        conditions.push_back(hinges.get());
        effects.push_back(std::move(hinges));
      }
  }

  void System::make_effects(const Scene                     &scene,
                            const std::vector<JointRelease> &releases)
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
    const bool is_elastic = graph.n_elastic_struts() > 0;
    if (is_elastic)
      {
        auto struts  = StrutForces::make(graph, *dofs, section_list, model);
        strut_forces = struts.get();
        effects.push_back(std::move(struts));
      }
    if (auto springs = make_rotational_springs(releases, *dofs, state_layout))
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
    const RigidBodies bodies = rigid_bodies(graph, *dofs);
    make_conditions(scene, releases, bodies);
    n_internal = effects.size();

    if (simulated.inertia)
      {
        if (!bodies.in_plane.empty() || !bodies.bars.empty())
          effects.push_back(std::make_unique<RigidPartInertia>(bodies));
        if (is_elastic)
          effects.push_back(make_strut_inertia(
            graph,
            *dofs,
            section_list,
            {simulated.large_rotation,
             simulated.rotary_inertia,
             simulated.strut_damping &&
               any_section(&Section::mass_proportional_damping)}));
        for (auto &masses : make_masses(scene,
                                        graph,
                                        *dofs,
                                        bodies,
                                        simulated.large_rotation,
                                        mean_length))
          effects.push_back(std::move(masses));
      }
    n_balanced = effects.size();
    for (auto &loads :
         make_loads(scene, graph, *dofs, section_list, bodies, simulated))
      effects.push_back(std::move(loads));
  }
} // namespace auxfem
