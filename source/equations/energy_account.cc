#include <auxfem/elements/cayley_turn.h>
#include <auxfem/equations/energy_account.h>

namespace auxfem
{
  namespace
  {
    Vector mean(const Vector &first, const Vector &second)
    {
      Vector result(first);
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = (result[i] + second[i]) / 2;
      return result;
    }

    /** Increment over @p dt. */
    Vector rate_of(const Vector &before, const Vector &now, const double dt)
    {
      Vector result(now);
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = (result[i] - before[i]) / dt;
      return result;
    }

    Vector difference(Vector first, const Vector &second)
    {
      add_multiple(-1., second, first);
      return first;
    }
  } // namespace

  StepMotion::StepMotion(const Evaluation &step)
    : dt(step.dt)
    , rate(rate_of(step.from.displacement, step.to.displacement, dt))
  {
    for (const int i : *step.to.plane_rotations)
      rate[i] = cayley_turn(dt * rate[i]) / dt;
    if (!step.to.velocity)
      return;
    velocity    = mean(*step.from.velocity, *step.to.velocity);
    excess_rate = difference(rate, velocity);
    if (!step.to.acceleration)
      return;
    acceleration = rate_of(*step.from.velocity, *step.to.velocity, dt);
    excess_acceleration =
      difference(step.kind == Evaluation::Kind::between
                   ? *step.to.acceleration
                   : mean(*step.from.acceleration, *step.to.acceleration),
                 acceleration);
  }

  EnergyAccount::EnergyAccount(const Evaluation &step)
    : step(step)
    , amounts(step.from.energy_sums.size(), 0.)
    , sums(step.from.energy_sums)
  {}

  void EnergyAccount::add(const unsigned int entry, const double energy)
  {
    amounts[entry] += energy;
  }

  void EnergyAccount::add_in_step(const unsigned int entry, const double energy)
  {
    sums[entry] += energy;
  }

  bool EnergyAccount::takes_time() const
  {
    return step.dt > 0;
  }

  const StepMotion &EnergyAccount::motion()
  {
    if (!motion_of_step)
      motion_of_step.emplace(step);
    return *motion_of_step;
  }

  std::vector<double> EnergyAccount::close()
  {
    for (unsigned int i = 0; i < sums.size(); ++i)
      amounts[i] += sums[i];
    step.to.energy_sums = sums;
    return amounts;
  }
} // namespace auxfem
