#include <auxfem/equations/evaluation.h>

namespace auxfem
{
  EnergyAccount::EnergyAccount(const Evaluation &step)
    : step(step)
    , amounts(step.from.energy_sums.size(), 0.)
    , sums(step.from.energy_sums)
    , powers(amounts)
  {}

  void EnergyAccount::add(const unsigned int entry, const double energy)
  {
    amounts[entry] += energy;
  }

  void EnergyAccount::add_in_step(const unsigned int entry, const double energy)
  {
    sums[entry] += energy;
  }

  void EnergyAccount::add_power(const unsigned int entry, const double power)
  {
    powers[entry] += power;
  }

  std::vector<double> EnergyAccount::close()
  {
    const bool is_between = step.kind == Evaluation::Kind::between;
    for (unsigned int i = 0; i < sums.size(); ++i)
      {
        if (!is_between)
          sums[i] += step.dt / 2 * (step.from.powers[i] + powers[i]);
        amounts[i] += sums[i];
      }
    step.to.energy_sums = sums;
    step.to.powers      = powers;
    return amounts;
  }
} // namespace auxfem
