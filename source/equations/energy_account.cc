#include <auxfem/equations/energy_account.h>
#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/parameters/numerical_limits.h>

#include <cmath>
#include <cstdint>

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

    /** Difference quotient over @p dt. */
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
    if (step.to.compensation)
      add_multiple(1.,
                   rate_of(*step.from.compensation, *step.to.compensation, dt),
                   rate);
    for (const int i : *step.to.plane_rotations)
      rate[i] = cayley_rotation(dt * rate[i]) / dt;
    for (const std::array<int, 3> &at : *step.to.space_rotations)
      {
        const SpaceVector turn =
          cayley_rotation(dt * vector_at(rate.data(), at.data()));
        for (unsigned int c = 0; c < 3; ++c)
          rate[at[c]] = turn[c] / dt;
      }
    if (!step.to.velocity)
      return;
    velocity    = mean(*step.from.velocity, *step.to.velocity);
    excess_rate = difference(rate, velocity);
    if (!step.to.acceleration)
      return;
    acceleration = rate_of(*step.from.velocity, *step.to.velocity, dt);
    excess_acceleration =
      difference(step.kind == Evaluation::Kind::discrete_gradient
                   ? *step.to.acceleration
                   : mean(*step.from.acceleration, *step.to.acceleration),
                 acceleration);
  }

  bool may_have_excess(const Evaluation &step)
  {
    // Discrete gradients use mean rates, and the Cayley measure of rotations in
    // the plane.
    if (step.kind == Evaluation::Kind::discrete_gradient)
      return true;
    const double  per_dt = 1 / step.dt;
    const double *u0     = step.from.displacement.data(),
                 *u1     = step.to.displacement.data(),
                 *v0     = step.from.velocity->data(),
                 *v1     = step.to.velocity->data(),
                 *a0     = step.from.acceleration->data(),
                 *a1     = step.to.acceleration->data();
    std::uint64_t n      = 0;
    for (std::size_t i = 0; i < step.to.displacement.size(); ++i)
      {
        const double v = (v0[i] + v1[i]) / 2, a = (a0[i] + a1[i]) / 2;
        n += std::abs((u1[i] - u0[i]) * per_dt - v) >
            round_off * (std::abs(u1[i]) * per_dt + std::abs(v))
          ? 1
          : 0;
        n += std::abs((v1[i] - v0[i]) * per_dt - a) >
            round_off * (std::abs(v1[i]) * per_dt + std::abs(a))
          ? 1
          : 0;
      }
    return n > 0;
  }

  EnergyAccount::EnergyAccount(const Evaluation &step)
    : step(step)
    , amounts(step.from.energy_sums.size(), 0.)
    , sums(step.from.energy_sums)
  {}

  const StepMotion &EnergyAccount::motion()
  {
    if (!motion_of_step)
      motion_of_step.emplace(step);
    return *motion_of_step;
  }

  bool EnergyAccount::has_excess()
  {
    if (!step_has_excess)
      step_has_excess = may_have_excess(step);
    return *step_has_excess;
  }

  std::vector<double> EnergyAccount::close()
  {
    for (unsigned int i = 0; i < sums.size(); ++i)
      amounts[i] += sums[i];
    step.to.energy_sums = sums;
    return amounts;
  }
} // namespace auxfem
