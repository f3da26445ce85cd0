#include <auxfem/contact/effects/contact_effect.h>

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
} // namespace auxfem
