#include <auxfem/equations/node_rotations.h>
#include <auxfem/joints/effects/revolute_hinges.h>

#include <algorithm>
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

    /**
     * Revolute hinges in space: a rotation P_2 turns against a rotation P_1, or
     * the ground, about one axis a (given at rest). With b_1, b_2 perpendicular
     * to a and a length l,
     * @code
     * g_i = l (P_1 b_i) . (P_2 a) = 0, i = 1, 2
     * @endcode
     * The moments between both are l lambda_i (P_1 b_i) x (P_2 a). With small
     * rotations the constraints are linearized about rest.
     */
    class RevoluteHinges : public Constraints
    {
    public:
      RevoluteHinges(const DofNumbering               &numbering,
                     const bool                        large_rotation,
                     const double                      length,
                     const std::vector<RevoluteHinge> &definitions)
        : numbering(numbering)
        , large_rotation(large_rotation)
        , unit(length)
      {
        for (const auto &[base, end, multipliers, axis] : definitions)
          {
            Hinge hinge;
            std::copy_n(base.begin(), 3, hinge.unknowns.begin());
            std::copy_n(end.begin(), 3, hinge.unknowns.begin() + 3);
            std::copy_n(multipliers.begin(), 2, hinge.unknowns.begin() + 6);
            const SpaceTensor frame =
              section_frame(axis, default_reference(axis));
            for (unsigned int c = 0; c < 3; ++c)
              {
                hinge.axis[c]      = frame[c][0];
                hinge.across[0][c] = frame[c][1];
                hinge.across[1][c] = frame[c][2];
              }
            hinges.push_back(hinge);
          }
      }

      bool is_linear() const override
      {
        return !large_rotation;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block = pattern.register_blocks(hinges, &Hinge::unknowns);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
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
                if (evaluation.has_constraint_accelerations())
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

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        for (unsigned int h = 0; h < hinges.size(); ++h)
          {
            const Hinge &hinge = hinges[h];
            const Axes   now   = axes(hinge, evaluation.to),
                       acting  = acting_axes(hinge, evaluation);
            // Derivatives of the base's moment by spins of base and end.
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

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        const double *u = evaluation.to.displacement.data();
        for (const Hinge &hinge : hinges)
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int c = 0; c < 6; ++c)
              raise_bound(forces,
                          hinge.unknowns[c],
                          unit * std::abs(u[hinge.unknowns[6 + i]]));
      }

      void find_rates(const State &state, double *rates) const override
      {
        for (const Hinge &hinge : hinges)
          {
            const Axes        now = axes(hinge, state);
            const SpaceVector relative =
              spatial(hinge, 0, state, *state.velocity) -
              spatial(hinge, 1, state, *state.velocity);
            for (unsigned int i = 0; i < 2; ++i)
              rates[hinge.unknowns[6 + i]] = unit * (now.arm(i) * relative);
          }
      }

    private:
      struct Hinge
      {
        std::array<int, 8> unknowns; ///< base, end, multipliers
        SpaceVector        axis;
        SpaceVector        across[2];
      };

      /** Rotated axes of a hinge: a of the end, and b_i of the base. */
      struct Axes
      {
        SpaceVector axis, across[2];

        /** dg_i = arm_i . (theta_1 - theta_2) / l. */
        SpaceVector arm(const unsigned int i) const
        {
          return dealii::cross_product_3d(across[i], axis);
        }
      };

      /** Axes of @p hinge in @p state. */
      Axes axes(const Hinge &hinge, const State &state) const
      {
        const Quaternion base = rotation(hinge, 0, state);
        return {rotated(rotation(hinge, 1, state), hinge.axis),
                {rotated(base, hinge.across[0]),
                 rotated(base, hinge.across[1])}};
      }

      /** Axes that define the moments. In a discrete-gradient step they are the
       * means over the step, with which the moments do no work. */
      Axes acting_axes(const Hinge &hinge, const Evaluation &evaluation) const
      {
        Axes result = axes(hinge, evaluation.to);
        if (evaluation.kind != Evaluation::Kind::discrete_gradient ||
            !large_rotation)
          return result;
        const Axes start = axes(hinge, evaluation.from);
        result.axis      = (start.axis + result.axis) / 2;
        for (unsigned int i = 0; i < 2; ++i)
          result.across[i] = (start.across[i] + result.across[i]) / 2;
        return result;
      }

      /** Rotation of the base (@p side 0) or the end (1); the identity for the
       * ground and for small rotations. */
      Quaternion rotation(const Hinge       &hinge,
                          const unsigned int side,
                          const State       &state) const
      {
        const int spin = hinge.unknowns[3 * side];
        return large_rotation && spin >= 0
          ? state.rotations[numbering.rotations().with(spin)]
          : Quaternion();
      }

      /** Spatial values of @p vector at the base (@p side 0) or the end (1). */
      SpaceVector spatial(const Hinge       &hinge,
                          const unsigned int side,
                          const State       &state,
                          const Vector      &vector) const
      {
        return rotated(rotation(hinge, side, state),
                       values_at(vector, &hinge.unknowns[3 * side]));
      }

      double acceleration(const Hinge       &hinge,
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
              (dealii::cross_product_3d(
                 dealii::cross_product_3d(base, axes.across[i]),
                 axes.axis) +
               dealii::cross_product_3d(axes.across[i],
                                        dealii::cross_product_3d(end,
                                                                 axes.axis)));
          }
        return unit * result;
      }

      const DofNumbering &numbering;
      const bool          large_rotation;
      const double        unit; ///< l
      std::vector<Hinge>  hinges;
      std::size_t         first_block = 0;
    };
  } // namespace

  std::unique_ptr<Constraints>
  make_revolute_hinges(const DofNumbering               &numbering,
                       const bool                        large_rotation,
                       const double                      length,
                       const std::vector<RevoluteHinge> &hinges)
  {
    return std::make_unique<RevoluteHinges>(numbering,
                                            large_rotation,
                                            length,
                                            hinges);
  }
} // namespace auxfem
