#include <auxfem/contact/effects/contact_effect.h>
#include <auxfem/model/effect_decisions.h>

#include <algorithm>

namespace auxfem
{
  void FrictionAccount::register_in(StateLayout &layout)
  {
    friction_entry = layout.energies.enter(friction_energy_entry());
    if (layout.acceleration)
      numerical_entry = layout.energies.enter(numerical_energy_entry());
  }

  void FrictionAccount::add_step(const Evaluation           &step,
                                 const std::vector<Sliding> &at_end,
                                 const std::vector<Sliding> &at_start,
                                 EnergyAccount              &account) const
  {
    const bool has_power = step.kind == Evaluation::Kind::step;
    const auto add       = [&](const Sliding &sliding) {
      const double work = -(sliding.friction.force * sliding.displacement);
      if (!has_power)
        {
          account.add_in_step(friction_entry, work);
          return;
        }
      const double loss = step.dt * sliding.friction.lost_power();
      account.add_in_step(friction_entry, loss / 2);
      account.add_in_step(numerical_entry, (work - loss) / 2);
    };
    std::for_each(at_end.begin(), at_end.end(), add);
    std::for_each(at_start.begin(), at_start.end(), add);
  }

  void FrictionAccount::add_power(const FrictionForce &friction,
                                  EnergyAccount       &account) const
  {
    account.add_power(friction_entry, friction.lost_power());
  }

  namespace
  {
    bool is_thick(const SectionDefinition &definition)
    {
      const auto &halves = definition.section.half_thicknesses;
      return std::max(halves[0], halves[1]) > 0;
    }

    /** Whether the analysis follows contact from state to state. */
    bool follows_contact(const Analysis analysis)
    {
      return analysis != Analysis::static_path &&
        analysis != Analysis::buckling;
    }

    EffectCause cause_of_contact(const RunPlan &plan)
    {
      if (!plan.scene.plates.empty())
        return {true, "plates are given"};
      if (plan.scene.lattice.struts_may_cross)
        return {false, "Lattice/Struts may cross = true"};
      if (plan.effects.large_rotation == Switch::off)
        return {false, struts_hardly_move};
      if (std::none_of(plan.scene.sections.begin(),
                       plan.scene.sections.end(),
                       is_thick))
        return {false, "no section has a thickness"};
      if (plan.effects.contact == Switch::automatic &&
          !follows_contact(plan.analysis))
        return {false, "touching struts are reported"};
      return {true, "struts may touch: forces where they are near"};
    }
  } // namespace

  EffectDefinition contact_effect()
  {
    return {"contact",
            &EffectSwitches::contact,
            &SimulatedEffects::contact,
            cause_of_contact};
  }
} // namespace auxfem
