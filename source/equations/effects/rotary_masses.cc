#include <auxfem/equations/effects/rotary_masses.h>

namespace auxfem
{
  RotaryMasses::RotaryMasses(const DofNumbering &numbering,
                             const bool          large_rotation)
    : numbering(numbering)
    , rotations(numbering)
    , large_rotation(large_rotation)
  {}

  void RotaryMasses::add(const unsigned int rotation,
                         const SpaceTensor &inertia)
  {
    masses.push_back({rotation, inertia});
  }

  bool RotaryMasses::empty() const
  {
    return masses.empty();
  }

  bool RotaryMasses::is_linear() const
  {
    return !large_rotation;
  }

  void RotaryMasses::register_in(StateLayout &layout)
  {
    kinetic_entry   = layout.energies.enter(kinetic_energy_entry());
    numerical_entry = layout.energies.enter(numerical_energy_entry());
  }

  void RotaryMasses::register_blocks(TangentPattern &pattern)
  {
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        const std::size_t block = pattern.register_block(
          numbering.rotations()[masses[i].rotation].data(),
          3);
        if (i == 0)
          first_block = block;
      }
  }

  RotaryInertia::Motion RotaryMasses::motion(const Mass  &mass,
                                             const State &state) const
  {
    return {rotations.values(*state.velocity, mass.rotation),
            rotations.values(*state.acceleration, mass.rotation)};
  }

  SpaceVector RotaryMasses::mean_torque(const Mass       &mass,
                                        const Evaluation &step) const
  {
    const RotaryInertia::Motion start = motion(mass, step.from),
                                end   = motion(mass, step.to);
    return RotaryInertia::mean_torque(step.from.rotations[mass.rotation],
                                      step.to.rotations[mass.rotation],
                                      mass.inertia *
                                        ((start.velocity + end.velocity) / 2),
                                      mass.inertia * end.acceleration,
                                      step.dt,
                                      0.);
  }

  void RotaryMasses::add_residual(const Evaluation &evaluation,
                                  double           *residual,
                                  EffectResults * /*results*/) const
  {
    for (const Mass &mass : masses)
      {
        const RotaryInertia::Motion now      = motion(mass, evaluation.to);
        const SpaceVector           inertial = mass.inertia * now.acceleration;
        const SpaceVector           torque   = !large_rotation ? inertial
                      : evaluation.kind == Evaluation::Kind::between
                      ? mean_torque(mass, evaluation)
                      : RotaryInertia::torque(mass.inertia,
                                  evaluation.to.rotations[mass.rotation],
                                  now);
        const std::array<int, 3> &spins = numbering.rotations()[mass.rotation];
        for (unsigned int c = 0; c < 3; ++c)
          residual[spins[c]] += torque[c];
      }
  }

  SpaceTensor RotaryMasses::mean_tangent(const Mass           &mass,
                                         const Evaluation     &step,
                                         const TangentFactors &factors) const
  {
    const Quaternion &rotation = step.to.rotations[mass.rotation];
    return factors.mass *
      rotated(rotation,
              mass.inertia * rotations.increment_by_spin(step, mass.rotation)) -
      2 * factors.stiffness / step.dt *
      cross_product_tensor(
        rotated(rotation, mass.inertia * motion(mass, step.to).velocity));
  }

  void RotaryMasses::add_tangent(const Evaluation &evaluation,
                                 const EffectResults * /*results*/,
                                 const TangentFactors &factors,
                                 TangentMatrix        &matrix) const
  {
    for (unsigned int i = 0; i < masses.size(); ++i)
      {
        SpaceTensor block = factors.mass * masses[i].inertia;
        if (large_rotation)
          {
            const unsigned int rotation = masses[i].rotation;
            if (evaluation.kind == Evaluation::Kind::between)
              block = mean_tangent(masses[i], evaluation, factors);
            else
              {
                const RotaryInertia::Tangent tangent =
                  RotaryInertia::tangent(masses[i].inertia,
                                         evaluation.to.rotations[rotation],
                                         motion(masses[i], evaluation.to));
                block = factors.stiffness * tangent.by_spin +
                  (factors.damping * tangent.by_velocity +
                   factors.mass * tangent.by_acceleration) *
                    rotations.increment_by_spin(evaluation, rotation);
              }
          }
        double values[9];
        for (unsigned int r = 0; r < 3; ++r)
          for (unsigned int c = 0; c < 3; ++c)
            values[3 * r + c] = block[r][c];
        matrix.add(first_block + i, values);
      }
  }

  void RotaryMasses::raise_forces(const Evaluation &evaluation,
                                  const EffectResults * /*results*/,
                                  double *forces) const
  {
    // A body that spins freely has torques that cancel, and no others.
    for (const Mass &mass : masses)
      {
        const RotaryInertia::Motion now = motion(mass, evaluation.to);
        const double torque = (mass.inertia * now.acceleration).norm() +
          now.velocity.norm() * (mass.inertia * now.velocity).norm();
        for (const int spin : numbering.rotations()[mass.rotation])
          raise(forces, spin, torque);
      }
  }

  void RotaryMasses::account(const Evaluation & /*step*/,
                             const EffectResults * /*results*/,
                             EnergyAccount &account) const
  {
    // Gyroscopic torques do no work.
    const auto product = [&](const Vector &x, const Vector &y) {
      double sum = 0;
      for (const Mass &mass : masses)
        if (numbering.layout().is_owned(
              numbering.rotations()[mass.rotation][0]))
          sum += rotations.values(x, mass.rotation) *
            (mass.inertia * rotations.values(y, mass.rotation));
      return sum;
    };
    account.add_inertia(kinetic_entry, numerical_entry, product);
  }
} // namespace auxfem
