#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/equations/effects/rotational_springs.h>

#include <cmath>

namespace auxfem
{
  RotationalSprings::RotationalSprings(const DofNumbering &numbering)
    : numbering(numbering)
  {}

  void RotationalSprings::add(const int    first,
                              const int    second,
                              const double stiffness)
  {
    springs.push_back({{first, second}, stiffness});
  }

  double RotationalSprings::angle(const Spring &spring, const double *u)
  {
    const int base = spring.unknowns[0];
    return u[spring.unknowns[1]] - (base >= 0 ? u[base] : 0.);
  }

  bool RotationalSprings::is_linear() const
  {
    return true;
  }

  void RotationalSprings::register_in(StateLayout &layout)
  {
    strain_entry = layout.energies.enter(strain_energy_entry());
  }

  void RotationalSprings::register_blocks(TangentPattern &pattern)
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        const std::size_t block =
          pattern.register_block(springs[i].unknowns, 2);
        if (i == 0)
          first_block = block;
      }
  }

  void RotationalSprings::add_residual(const Evaluation &evaluation,
                                       double           *residual,
                                       EffectResults * /*results*/) const
  {
    const double *u = evaluation.to.displacement.data();
    if (evaluation.kind == Evaluation::Kind::between)
      {
        add_mean_moments(evaluation, residual);
        return;
      }
    for (const Spring &spring : springs)
      {
        const double moment = spring.stiffness * angle(spring, u);
        if (spring.unknowns[0] >= 0)
          residual[spring.unknowns[0]] -= moment;
        residual[spring.unknowns[1]] += moment;
      }
  }

  void RotationalSprings::add_mean_moments(const Evaluation &evaluation,
                                           double           *residual) const
  {
    const double *u0       = evaluation.from.displacement.data();
    const double *u1       = evaluation.to.displacement.data();
    const bool    is_large = !evaluation.to.plane_rotations->empty();
    for (const Spring &spring : springs)
      {
        const int base = spring.unknowns[0], end = spring.unknowns[1];
        double    moment =
          spring.stiffness * (angle(spring, u0) + angle(spring, u1)) / 2;
        // Moments do work on Cayley's measure of the increments.
        if (is_large)
          {
            const double d_base = base >= 0 ? (u1[base] - u0[base]) / 2 : 0.,
                         d_end  = (u1[end] - u0[end]) / 2;
            moment *= std::cos(d_base) * std::cos(d_end) / sinc(d_end - d_base);
          }
        if (base >= 0)
          residual[base] -= moment;
        residual[end] += moment;
      }
  }

  void RotationalSprings::add_tangent(const Evaluation & /*evaluation*/,
                                      const EffectResults * /*results*/,
                                      const TangentFactors &factors,
                                      TangentMatrix        &matrix) const
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        const double k        = factors.stiffness * springs[i].stiffness;
        const double block[4] = {k, -k, -k, k};
        matrix.add(first_block + i, block);
      }
  }

  void RotationalSprings::account(const Evaluation &step,
                                  const EffectResults * /*results*/,
                                  EnergyAccount &account) const
  {
    const double *u = step.to.displacement.data();
    for (const Spring &spring : springs)
      if (numbering.layout().is_owned(spring.unknowns[1]))
        account.add(strain_entry,
                    spring.stiffness / 2 * angle(spring, u) * angle(spring, u));
  }

  void RotationalSprings::raise_forces(const Evaluation &evaluation,
                                       const EffectResults * /*results*/,
                                       double *forces) const
  {
    const double *u = evaluation.to.displacement.data();
    for (const Spring &spring : springs)
      for (const int unknown : spring.unknowns)
        raise(forces, unknown, spring.stiffness * std::abs(angle(spring, u)));
  }

  void RotationalSprings::raise_uncertain_forces(
    const Evaluation & /*evaluation*/,
    const EffectResults * /*results*/,
    const double /*largest_displacement*/,
    const double largest_rotation,
    double      *forces) const
  {
    for (const Spring &spring : springs)
      for (const int unknown : spring.unknowns)
        raise(forces, unknown, spring.stiffness * largest_rotation);
  }
} // namespace auxfem
