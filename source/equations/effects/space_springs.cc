#include <auxfem/elements/cayley_rotation.h>
#include <auxfem/equations/effects/space_springs.h>

namespace auxfem
{
  SpaceSprings::SpaceSprings(const DofNumbering &numbering)
    : numbering(numbering)
  {}

  void SpaceSprings::add(const int          first,
                         const int          second,
                         const double       stiffness,
                         const unsigned int number)
  {
    Spring spring;
    spring.unknowns  = {{-1, -1, -1, -1, -1, -1}};
    spring.first     = first;
    spring.second    = second;
    spring.stiffness = stiffness;
    spring.number    = number;
    for (unsigned int c = 0; c < 3; ++c)
      {
        if (first >= 0)
          spring.unknowns[c] = numbering.rotations()[first][c];
        spring.unknowns[3 + c] = numbering.rotations()[second][c];
      }
    springs.push_back(spring);
  }

  bool SpaceSprings::is_linear() const
  {
    return false;
  }

  void SpaceSprings::register_in(StateLayout &layout)
  {
    std::vector<unsigned int> numbers;
    numbers.reserve(springs.size());
    for (const Spring &spring : springs)
      numbers.push_back(spring.number);
    first_history =
      layout.history.keep("rotational springs: material rotation vector",
                          numbers,
                          3);
    strain_entry = layout.energies.enter(strain_energy_entry());
  }

  void SpaceSprings::register_blocks(TangentPattern &pattern)
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        const std::size_t block =
          pattern.register_block(springs[i].unknowns.data(), 6);
        if (i == 0)
          first_block = block;
      }
  }

  Quaternion SpaceSprings::base_rotation(const Spring &spring,
                                         const State  &state) const
  {
    return spring.first < 0 ? Quaternion() : state.rotations[spring.first];
  }

  SpaceVector SpaceSprings::material_angle(const unsigned int i,
                                           const Evaluation  &evaluation) const
  {
    const Spring &spring = springs[i];
    const double *before = &evaluation.from.history[first_history + 3 * i];
    return rotation_vector_near(conjugate(
                                  base_rotation(spring, evaluation.to)) *
                                  evaluation.to.rotations[spring.second],
                                SpaceVector({before[0], before[1], before[2]}));
  }

  SpaceVector SpaceSprings::angle(const unsigned int i,
                                  const Evaluation  &evaluation) const
  {
    return rotated(base_rotation(springs[i], evaluation.to),
                   material_angle(i, evaluation));
  }

  SpaceVector SpaceSprings::mean_moment(const unsigned int i,
                                        const SpaceVector &turned,
                                        const Evaluation  &step) const
  {
    const Spring     &spring = springs[i];
    const double     *values = &step.from.history[first_history + 3 * i];
    const SpaceVector before({values[0], values[1], values[2]});
    const Quaternion  base_0 = base_rotation(spring, step.from),
                     base_1  = base_rotation(spring, step.to);
    const SpaceVector mean =
                        (rotated(base_0, before) + rotated(base_1, turned)) / 2,
                      turn = cayley_rotation(
                               step.to.rotations[spring.second] *
                               conjugate(step.from.rotations[spring.second])) -
      cayley_rotation(base_1 * conjugate(base_0));
    // Along the turn, so that the work is the change of energy.
    const double missing =
      (turned + before) * (turned - before) / 2 - mean * turn;
    constexpr double round_off = 4e-15;
    return spring.stiffness *
      (std::abs(missing) <= round_off * mean.norm()
         ? mean
         : mean + missing / turn.norm_square() * turn);
  }

  void SpaceSprings::add_residual(const Evaluation &evaluation,
                                  double           *residual,
                                  EffectResults * /*results*/) const
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        const Spring     &spring = springs[i];
        const SpaceVector turned = material_angle(i, evaluation),
                          moment = evaluation.kind == Evaluation::Kind::between
          ? mean_moment(i, turned, evaluation)
          : spring.stiffness *
            rotated(base_rotation(spring, evaluation.to), turned);
        for (unsigned int c = 0; c < 3; ++c)
          {
            evaluation.to.history[first_history + 3 * i + c] = turned[c];
            if (spring.first >= 0)
              residual[spring.unknowns[c]] -= moment[c];
            residual[spring.unknowns[3 + c]] += moment[c];
          }
      }
  }

  void SpaceSprings::add_tangent(const Evaluation &evaluation,
                                 const EffectResults * /*results*/,
                                 const TangentFactors &factors,
                                 TangentMatrix        &matrix) const
  {
    if (factors.stiffness == 0)
      return;
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        const Spring &spring = springs[i];
        // Spins theta turn psi by T^-1(-psi) (theta_2 - R theta_1), R = P_2
        // P_1^-1.
        const SpaceTensor by_second = factors.stiffness * spring.stiffness *
          inverse_tangent_operator(-1. * angle(i, evaluation));
        const Quaternion relative = evaluation.to.rotations[spring.second] *
          conjugate(base_rotation(spring, evaluation.to));
        // D R is the transpose of R^T D^T.
        const SpaceTensor by_first =
          -1. * transpose(rotated(conjugate(relative), transpose(by_second)));
        double block[36];
        for (unsigned int r = 0; r < 6; ++r)
          for (unsigned int c = 0; c < 6; ++c)
            block[6 * r + c] =
              (r < 3 ? -1 : 1) * (c < 3 ? by_first : by_second)[r % 3][c % 3];
        matrix.add(first_block + i, block);
      }
  }

  void SpaceSprings::account(const Evaluation &step,
                             const EffectResults * /*results*/,
                             EnergyAccount &account) const
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      if (numbering.layout().is_owned(springs[i].unknowns[3]))
        account.add(strain_entry,
                    springs[i].stiffness / 2 *
                      material_angle(i, step).norm_square());
  }

  void SpaceSprings::raise_forces(const Evaluation &evaluation,
                                  const EffectResults * /*results*/,
                                  double *forces) const
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      for (const int unknown : springs[i].unknowns)
        raise(forces,
              unknown,
              springs[i].stiffness * material_angle(i, evaluation).norm());
  }

  void
  SpaceSprings::raise_uncertain_forces(const Evaluation & /*evaluation*/,
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
