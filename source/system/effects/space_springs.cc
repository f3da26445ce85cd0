#include <auxfem/system/effects/space_springs.h>

#include <algorithm>

namespace auxfem
{
  SpaceSprings::SpaceSprings(const DofNumbering &numbering,
                             const StateLayout  &layout)
    : numbering(numbering)
    , first_history(layout.n_history)
  {}

  void SpaceSprings::add(const int    first,
                         const int    second,
                         const double stiffness,
                         StateLayout &layout)
  {
    Spring spring;
    spring.unknowns  = {{-1, -1, -1, -1, -1, -1}};
    spring.first     = first;
    spring.second    = second;
    spring.stiffness = stiffness;
    for (unsigned int c = 0; c < 3; ++c)
      {
        if (first >= 0)
          spring.unknowns[c] = numbering.spatial_rotations()[first][c];
        spring.unknowns[3 + c] = numbering.spatial_rotations()[second][c];
      }
    springs.push_back(spring);
    layout.n_history += 3;
  }

  bool SpaceSprings::is_linear() const
  {
    return false;
  }

  void SpaceSprings::register_blocks(TangentMatrix &matrix)
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        const std::size_t block =
          matrix.register_block(springs[i].unknowns.data(), 6);
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
                                           const Step        &step) const
  {
    const Spring &spring = springs[i];
    const double *before = &step.from.history[first_history + 3 * i];
    return rotation_vector_near(conjugate(base_rotation(spring, step.to)) *
                                  step.to.rotations[spring.second],
                                SpaceVector({before[0], before[1], before[2]}));
  }

  void SpaceSprings::add_residual(const Step &step, double *residual)
  {
    for (unsigned int i = 0; i < springs.size(); ++i)
      {
        Spring           &spring = springs[i];
        const SpaceVector turned = material_angle(i, step);
        spring.angle = rotated(base_rotation(spring, step.to), turned);
        for (unsigned int c = 0; c < 3; ++c)
          {
            step.to.history[first_history + 3 * i + c] = turned[c];
            const double moment = spring.stiffness * spring.angle[c];
            if (spring.first >= 0)
              residual[spring.unknowns[c]] -= moment;
            residual[spring.unknowns[3 + c]] += moment;
          }
      }
  }

  void SpaceSprings::add_tangent(const Step           &step,
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
          inverse_tangent_operator(-1. * spring.angle);
        const Quaternion relative = step.to.rotations[spring.second] *
          conjugate(base_rotation(spring, step.to));
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

  void SpaceSprings::add_energies(const State & /*state*/,
                                  Energies &energies) const
  {
    for (const Spring &spring : springs)
      if (numbering.is_owned(spring.unknowns[3]))
        energies.strain += spring.stiffness / 2 * spring.angle.norm_square();
  }

  double SpaceSprings::round_off_scale(const double /*largest_displacement*/,
                                       const double largest_rotation) const
  {
    double stiffest = 0;
    for (const Spring &spring : springs)
      stiffest = std::max(stiffest, spring.stiffness);
    return stiffest * largest_rotation;
  }
} // namespace auxfem
