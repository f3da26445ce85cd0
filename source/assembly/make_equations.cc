#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/contact/effects/contact.h>
#include <auxfem/equations/equations.h>
#include <auxfem/equations/make_effects.h>
#include <auxfem/loads/effects/point_masses.h>
#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/model/initial_velocities.h>
#include <auxfem/model/load_history.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/rigid/effects/rigid_part_group.h>
#include <auxfem/struts/effects/struts.h>

// Creates the effects of a scene.

namespace auxfem
{
  namespace
  {
    StateLayout layout_of_scheme(const LatticeModel &model)
    {
      const ImplicitScheme &scheme = model.plan.time.implicit_scheme();
      StateLayout           layout;
      layout.velocity = layout.acceleration = model.plan.simulated.inertia;
      layout.path                           = has_load_factor(model.plan);
      layout.algorithmic_acceleration = scheme.uses_algorithmic_acceleration();
      layout.compensation             = scheme.uses_discrete_gradient();
      layout.n_rotations              = model.n_large_rotations();
      if (layout.compensation && model.plan.simulated.large_rotation)
        {
          for (unsigned int i = 0; i < layout.n_rotations; ++i)
            layout.space_rotations.push_back(model.numbering.rotations()[i]);
          for (unsigned int i = 0; i < model.numbering.layout().n_local() &&
               model.lattice.dimension == 2;
               ++i)
            if (model.numbering.unknowns().is_rotation[i])
              layout.plane_rotations.push_back(i);
        }
      return layout;
    }
  } // namespace

  ConnectorReport ConnectorGroup::report(const unsigned int       i,
                                         const State             &state,
                                         const EvaluationResults &results) const
  {
    return forces->report(i, state, results.effect_caches[effect].get());
  }

  Equations::Equations(const LatticeModel                  &model,
                       std::vector<std::unique_ptr<Effect>> further)
    : structure(model)
    , state_layout(layout_of_scheme(model))
    , tangent_pattern(model.numbering.unknowns())
  {
    make_internal_forces();
    make_contact();
    make_constraints();
    std::move(further.begin(), further.end(), std::back_inserter(effects));
    n_internal = effects.size();
    if (model.plan.simulated.inertia)
      make_inertia();
    n_balanced = effects.size();
    make_loads();
    stage_terms        = implementations<StageTerms>();
    small_motion_terms = implementations<SmallMotionTerms>();
    changing_couplings = implementations<ChangingCouplings>();
    refuse_unknown_errors();
    enter_energies();
    for (const auto &effect : effects)
      effect->register_in(state_layout);
    register_blocks();
    if (model.plan.simulated.inertia)
      initial_velocities =
        auxfem::initial_velocities(model.plan, model.lattice, model.numbering);
  }

  void Equations::refuse_unknown_errors() const
  {
    const TimeParameters &time   = structure.plan.time;
    const ImplicitScheme &scheme = time.implicit_scheme();
    // Constraint effects exist even on ranks without parts.
    if (time.relative_tolerance && scheme.stages() != nullptr &&
        !reporting_effects.constraints.empty())
      throw InputError(
        "Time/Relative tolerance: Time/Scheme = " + scheme.name() +
        " has no error estimate with rigid parts or revolute hinges. Set it to "
        "none, or choose newmark, hht or generalized-alpha.");
  }

  void Equations::enter_energies()
  {
    // All ranks need the same ledger, though some may lack an effect.
    if (structure.plan.simulated.inertia)
      {
        state_layout.energies.enter(kinetic_energy_entry());
        state_layout.energies.enter(numerical_energy_entry());
      }
    if (structure.lattice.n_elastic_struts() > 0 ||
        have_rotational_springs(structure.releases))
      state_layout.energies.enter(strain_energy_entry());
  }

  void Equations::register_blocks()
  {
    const DofNumbering &numbering = structure.numbering;
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      tangent_pattern.register_block(numbering.element_unknowns(e),
                                     numbering.n_element_unknowns(e));
    for (const auto &effect : effects)
      effect->register_blocks(tangent_pattern);
  }

  void Equations::make_internal_forces()
  {
    const SimulatedEffects &simulated = structure.plan.simulated;
    for (auto &struts : make_strut_forces(
           structure,
           structure.lattice,
           structure.numbering,
           structure.plan.time.implicit_scheme().high_frequency_damping()))
      {
        reporting_effects.struts.push_back(
          {struts.get(), static_cast<unsigned int>(effects.size())});
        effects.push_back(std::move(struts));
      }
    if (auto springs = make_rotational_springs(structure))
      effects.push_back(std::move(springs));
    for (auto &laws : make_rotational_laws(structure))
      effects.push_back(std::move(laws));
    if (auto spin_holds = make_spin_holds(structure))
      effects.push_back(std::move(spin_holds));

    const Scene &scene = structure.plan.scene;
    for (unsigned int group = 0; group < scene.connectors.size(); ++group)
      {
        ConnectorDefinition definition = scene.connectors[group];
        if (!simulated.connector_viscosity && definition.law->is_viscous())
          definition.law = definition.law->without_viscosity();
        auto forces = make_connector_forces(definition,
                                            structure.connector_pairs[group],
                                            structure.lattice,
                                            structure.numbering,
                                            simulated.large_rotation);
        reporting_effects.connectors.push_back(
          {forces.get(), static_cast<unsigned int>(effects.size())});
        effects.push_back(std::move(forces));
      }
  }

  void Equations::make_contact()
  {
    if (!structure.plan.simulated.contact)
      return;
    const Scene &scene = structure.plan.scene;
    if (!scene.plates.empty())
      {
        auto contact                    = make_plate_contact(structure);
        reporting_effects.plates        = contact.get();
        reporting_effects.plates_effect = effects.size();
        effects.push_back(std::move(contact));
      }
    // With small rotations struts do not approach each other.
    if (structure.plan.simulated.large_rotation &&
        !scene.lattice.struts_may_cross)
      {
        auto contact                           = make_strut_contact(structure);
        reporting_effects.strut_contact        = contact.get();
        reporting_effects.strut_contact_effect = effects.size();
        effects.push_back(std::move(contact));
      }
  }

  void Equations::make_constraints()
  {
    const SimulatedEffects &simulated = structure.plan.simulated;
    if (!structure.lattice.rigid_parts.empty())
      {
        const Scene                &scene = structure.plan.scene;
        std::array<TimeFunction, 3> gravity, base;
        for (unsigned int c = 0; c < gravity.size(); ++c)
          {
            if (simulated.gravity)
              gravity[c] =
                proportional(scene.gravity.acceleration[c], structure.plan);
            base[c] =
              proportional(scene.base_motion.acceleration[c], structure.plan);
          }
        auto parts = make_rigid_part_constraints(structure.bodies,
                                                 {structure.lattice,
                                                  structure.numbering,
                                                  simulated.large_rotation,
                                                  gravity,
                                                  base});
        reporting_effects.rigid_parts = parts.get();
        reporting_effects.constraints.push_back(parts.get());
        effects.push_back(std::move(parts));
      }
    if (auto hinges = make_revolute_hinges(structure))
      {
        reporting_effects.constraints.push_back(hinges.get());
        effects.push_back(std::move(hinges));
      }
    if (auto relations = make_relation_forces(structure))
      {
        reporting_effects.constraints.push_back(relations.get());
        effects.push_back(std::move(relations));
      }
  }

  void Equations::make_inertia()
  {
    const RigidBodies &bodies = structure.bodies;
    if (!bodies.in_plane.empty() || !bodies.bars.empty())
      effects.push_back(make_rigid_part_inertia(bodies));
    for (auto &inertia :
         make_strut_inertia(structure, structure.lattice, structure.numbering))
      effects.push_back(std::move(inertia));
    for (auto &masses : make_masses(structure))
      effects.push_back(std::move(masses));
  }

  void Equations::make_loads()
  {
    for (auto &loads : auxfem::make_loads(structure))
      effects.push_back(std::move(loads));
    if (auto supports = make_support_work(structure))
      effects.push_back(std::move(supports));
  }
} // namespace auxfem
