#include <auxfem/equations/effects/revolute_hinges.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    SpaceVector values_at(const Vector &vector, const int *unknowns)
    {
      return unknowns[0] < 0 ? SpaceVector()
                             : vector_at(vector.data(), unknowns);
    }
  } // namespace

  RevoluteHinges::RevoluteHinges(const DofNumbering &numbering,
                                 const bool          large_rotation,
                                 const double        length)
    : numbering(numbering)
    , large_rotation(large_rotation)
    , unit(length)
  {}

  void RevoluteHinges::add(const std::array<int, 3> &base,
                           const std::array<int, 3> &end,
                           const std::array<int, 2> &multipliers,
                           const SpaceVector        &axis)
  {
    Hinge hinge;
    hinge.unknowns          = {{base[0],
                                base[1],
                                base[2],
                                end[0],
                                end[1],
                                end[2],
                                multipliers[0],
                                multipliers[1]}};
    const SpaceTensor frame = section_frame(axis, std::nullopt);
    for (unsigned int c = 0; c < 3; ++c)
      {
        hinge.axis[c]      = frame[c][0];
        hinge.across[0][c] = frame[c][1];
        hinge.across[1][c] = frame[c][2];
      }
    hinges.push_back(hinge);
  }

  bool RevoluteHinges::is_linear() const
  {
    return !large_rotation;
  }

  void RevoluteHinges::register_blocks(TangentPattern &pattern)
  {
    for (unsigned int i = 0; i < hinges.size(); ++i)
      {
        const std::size_t block =
          pattern.register_block(hinges[i].unknowns.data(), 8);
        if (i == 0)
          first_block = block;
      }
  }

  Quaternion RevoluteHinges::rotation(const Hinge       &hinge,
                                      const unsigned int which,
                                      const State       &state) const
  {
    const int spin = hinge.unknowns[3 * which];
    return large_rotation && spin >= 0
      ? state.rotations[numbering.rotations().with(spin)]
      : Quaternion();
  }

  RevoluteHinges::Axes RevoluteHinges::axes(const Hinge &hinge,
                                            const State &state) const
  {
    const Quaternion base = rotation(hinge, 0, state);
    return {rotated(rotation(hinge, 1, state), hinge.axis),
            {rotated(base, hinge.across[0]), rotated(base, hinge.across[1])}};
  }

  RevoluteHinges::Axes
  RevoluteHinges::acting_axes(const Hinge      &hinge,
                              const Evaluation &evaluation) const
  {
    Axes result = axes(hinge, evaluation.to);
    if (evaluation.kind != Evaluation::Kind::between || !large_rotation)
      return result;
    const Axes start = axes(hinge, evaluation.from);
    result.axis      = (start.axis + result.axis) / 2;
    for (unsigned int i = 0; i < 2; ++i)
      result.across[i] = (start.across[i] + result.across[i]) / 2;
    return result;
  }

  SpaceVector RevoluteHinges::spatial(const Hinge       &hinge,
                                      const unsigned int which,
                                      const State       &state,
                                      const Vector      &vector) const
  {
    return rotated(rotation(hinge, which, state),
                   values_at(vector, &hinge.unknowns[3 * which]));
  }

  double RevoluteHinges::acceleration(const Hinge       &hinge,
                                      const Axes        &axes,
                                      const unsigned int i,
                                      const State       &state) const
  {
    double result = axes.arm(i) *
      (spatial(hinge, 0, state, *state.acceleration) -
       spatial(hinge, 1, state, *state.acceleration));
    if (large_rotation)
      {
        const SpaceVector base = spatial(hinge, 0, state, *state.velocity),
                          end  = spatial(hinge, 1, state, *state.velocity);
        result += (base - end) *
          (dealii::cross_product_3d(dealii::cross_product_3d(base,
                                                             axes.across[i]),
                                    axes.axis) +
           dealii::cross_product_3d(axes.across[i],
                                    dealii::cross_product_3d(end, axes.axis)));
      }
    return unit * result;
  }

  void RevoluteHinges::add_residual(const Evaluation &evaluation,
                                    double           *residual,
                                    EffectResults * /*results*/) const
  {
    const State  &state = evaluation.to;
    const Vector &u     = state.displacement;
    for (const Hinge &hinge : hinges)
      {
        const Axes now    = axes(hinge, state),
                   acting = acting_axes(hinge, evaluation);
        for (unsigned int i = 0; i < 2; ++i)
          {
            const int         row    = hinge.unknowns[6 + i];
            const SpaceVector moment = unit * u[row] * acting.arm(i);
            for (unsigned int c = 0; c < 3; ++c)
              {
                if (hinge.unknowns[c] >= 0)
                  residual[hinge.unknowns[c]] += moment[c];
                residual[hinge.unknowns[3 + c]] -= moment[c];
              }
            if (evaluation.wants_constraint_accelerations())
              residual[row] += acceleration(hinge, now, i, state);
            else if (large_rotation)
              residual[row] += unit * (now.across[i] * now.axis);
            else
              residual[row] += unit * now.arm(i) *
                (values_at(u, &hinge.unknowns[0]) -
                 values_at(u, &hinge.unknowns[3]));
          }
      }
  }

  void RevoluteHinges::add_tangent(const Evaluation &evaluation,
                                   const EffectResults * /*results*/,
                                   const TangentFactors &factors,
                                   TangentMatrix        &matrix) const
  {
    for (unsigned int h = 0; h < hinges.size(); ++h)
      {
        const Hinge &hinge = hinges[h];
        const Axes   now   = axes(hinge, evaluation.to),
                   acting  = acting_axes(hinge, evaluation);
        // Moments (on base, end) by spins (of base, end).
        SpaceTensor stiffness[2];
        double      block[64] = {};
        for (unsigned int i = 0; i < 2; ++i)
          {
            const SpaceVector arm    = unit * now.arm(i),
                              moment = unit * acting.arm(i);
            for (unsigned int c = 0; c < 3; ++c)
              {
                block[8 * c + 6 + i]       = moment[c];
                block[8 * (3 + c) + 6 + i] = -moment[c];
                block[8 * (6 + i) + c]     = arm[c];
                block[8 * (6 + i) + 3 + c] = -arm[c];
              }
            if (!large_rotation)
              continue;
            const double force = factors.stiffness * unit *
              evaluation.to.displacement[hinge.unknowns[6 + i]];
            stiffness[0] += force *
              (cross_product_tensor(acting.axis) *
               cross_product_tensor(now.across[i]));
            stiffness[1] -= force *
              (cross_product_tensor(acting.across[i]) *
               cross_product_tensor(now.axis));
          }
        for (unsigned int r = 0; r < 6; ++r)
          for (unsigned int c = 0; c < 6; ++c)
            block[8 * r + c] =
              (r < 3 ? 1 : -1) * stiffness[c / 3][r % 3][c % 3];
        matrix.add(first_block + h, block);
      }
  }

  void RevoluteHinges::raise_forces(const Evaluation &evaluation,
                                    const EffectResults * /*results*/,
                                    double *forces) const
  {
    const double *u = evaluation.to.displacement.data();
    for (const Hinge &hinge : hinges)
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int c = 0; c < 6; ++c)
          raise(forces,
                hinge.unknowns[c],
                unit * std::abs(u[hinge.unknowns[6 + i]]));
  }

  void RevoluteHinges::find_rates(const State &state, double *rates) const
  {
    for (const Hinge &hinge : hinges)
      {
        const Axes        now      = axes(hinge, state);
        const SpaceVector relative = spatial(hinge, 0, state, *state.velocity) -
          spatial(hinge, 1, state, *state.velocity);
        for (unsigned int i = 0; i < 2; ++i)
          rates[hinge.unknowns[6 + i]] = unit * (now.arm(i) * relative);
      }
  }
} // namespace auxfem
