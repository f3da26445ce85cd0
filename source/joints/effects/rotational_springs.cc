#include <auxfem/equations/node_rotations.h>
#include <auxfem/joints/effects/rotational_springs.h>
#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/parameters/numerical_limits.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Linear springs between two rotations: M = K' (phi_2 - phi_1). */
    class RotationalSprings : public Effect
    {
    public:
      RotationalSprings(const DofNumbering           &numbering,
                        std::vector<RotationalSpring> springs)
        : numbering(numbering)
        , springs(std::move(springs))
      {}

      bool is_linear() const override
      {
        return true;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block =
          pattern.register_blocks(springs, &RotationalSpring::unknowns);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const double *u = evaluation.to.displacement.data();
        if (evaluation.kind == Evaluation::Kind::discrete_gradient)
          {
            add_mean_moments(evaluation, residual);
            return;
          }
        for (const RotationalSpring &spring : springs)
          {
            const double moment = spring.stiffness * angle(spring, u);
            if (spring.unknowns[0] >= 0)
              residual[spring.unknowns[0]] -= moment;
            residual[spring.unknowns[1]] += moment;
          }
      }

      void add_tangent(const Evaluation & /*evaluation*/,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const double k        = factors.stiffness * springs[i].stiffness;
            const double block[4] = {k, -k, -k, k};
            matrix.add(first_block + i, block);
          }
      }

      void register_in(StateLayout &layout) override
      {
        strain_entry = layout.energies.enter(strain_energy_entry());
      }

      void account(const Evaluation &step,
                   const EffectCache * /*results*/,
                   EnergyAccount &account) const override
      {
        const double *u = step.to.displacement.data();
        for (const RotationalSpring &spring : springs)
          if (numbering.layout().is_owned(spring.unknowns[1]))
            account.add(strain_entry,
                        spring.stiffness / 2 * angle(spring, u) *
                          angle(spring, u));
      }

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        const double *u = evaluation.to.displacement.data();
        for (const RotationalSpring &spring : springs)
          for (const int unknown : spring.unknowns)
            raise_bound(forces,
                        unknown,
                        spring.stiffness * std::abs(angle(spring, u)));
      }

      void roundoff_force_bounds(const Evaluation & /*evaluation*/,
                                 const EffectCache * /*results*/,
                                 const LargestMotion &largest,
                                 double              *forces) const override
      {
        for (const RotationalSpring &spring : springs)
          for (const int unknown : spring.unknowns)
            raise_bound(forces, unknown, spring.stiffness * largest.rotation);
      }

    private:
      /** phi_2 - phi_1 (rad). */
      static double angle(const RotationalSpring &spring, const double *u)
      {
        const int base = spring.unknowns[0];
        return u[spring.unknowns[1]] - (base >= 0 ? u[base] : 0.);
      }

      /** Adds the moments of a discrete-gradient step. */
      void add_mean_moments(const Evaluation &evaluation,
                            double           *residual) const
      {
        const double *u0 = evaluation.from.displacement.data();
        const double *u1 = evaluation.to.displacement.data();
        for (const RotationalSpring &spring : springs)
          {
            const int    base   = spring.unknowns[0];
            const double moment = spring.stiffness *
              (angle(spring, u0) + angle(spring, u1)) / 2 *
              mean_moment_factor(spring.unknowns, evaluation);
            if (base >= 0)
              residual[base] -= moment;
            residual[spring.unknowns[1]] += moment;
          }
      }

      const DofNumbering                 &numbering;
      const std::vector<RotationalSpring> springs;
      std::size_t                         first_block  = 0;
      unsigned int                        strain_entry = 0;
    };

    /**
     * Isotropic springs between two large rotations in space. The energy is
     * K' |psi|^2 / 2 with the rotation vector psi of P_2 P_1^-1, the moment on
     * the second rotation -K' psi. To count whole turns, psi is the vector
     * nearest to that at the start of the step, which State::history has as
     * P_1^-1 psi.
     */
    class SpaceSprings : public Effect
    {
    public:
      SpaceSprings(const DofNumbering             &numbering,
                   const std::vector<SpaceSpring> &definitions)
        : numbering(numbering)
      {
        for (const SpaceSpring &definition : definitions)
          {
            Spring spring{definition, {{-1, -1, -1, -1, -1, -1}}};
            for (unsigned int c = 0; c < 3; ++c)
              {
                if (spring.first >= 0)
                  spring.unknowns[c] = numbering.rotations()[spring.first][c];
                spring.unknowns[3 + c] =
                  numbering.rotations()[spring.second][c];
              }
            springs.push_back(spring);
          }
      }

      bool is_linear() const override
      {
        return false;
      }

      void register_blocks(TangentPattern &pattern) override
      {
        first_block = pattern.register_blocks(springs, &Spring::unknowns);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const Spring     &spring   = springs[i];
            const SpaceVector material = material_angle(i, evaluation),
                              moment   = evaluation.kind ==
                Evaluation::Kind::discrete_gradient
                ? mean_moment(i, material, evaluation)
                : spring.stiffness *
                rotated(base_rotation(spring, evaluation.to), material);
            for (unsigned int c = 0; c < 3; ++c)
              {
                evaluation.to.history[first_history + 3 * i + c] = material[c];
                if (spring.first >= 0)
                  residual[spring.unknowns[c]] -= moment[c];
                residual[spring.unknowns[3 + c]] += moment[c];
              }
          }
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        if (factors.stiffness == 0)
          return;
        for (unsigned int i = 0; i < springs.size(); ++i)
          {
            const Spring &spring = springs[i];
            // Spins theta change psi by T^-1(-psi) (theta_2 - R theta_1) with
            // R = P_2 P_1^-1.
            const SpaceTensor by_second = factors.stiffness * spring.stiffness *
              inverse_tangent_operator(-1. * angle(i, evaluation));
            const Quaternion relative = evaluation.to.rotations[spring.second] *
              conjugate(base_rotation(spring, evaluation.to));
            // rotated() multiplies from the left: D R = (R^T D^T)^T.
            const SpaceTensor by_first = -1. *
              transpose(rotated(conjugate(relative), transpose(by_second)));
            double block[36];
            for (unsigned int r = 0; r < 6; ++r)
              for (unsigned int c = 0; c < 6; ++c)
                block[6 * r + c] = (r < 3 ? -1 : 1) *
                  (c < 3 ? by_first : by_second)[r % 3][c % 3];
            matrix.add(first_block + i, block);
          }
      }

      void register_in(StateLayout &layout) override
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

      void account(const Evaluation &step,
                   const EffectCache * /*results*/,
                   EnergyAccount &account) const override
      {
        for (unsigned int i = 0; i < springs.size(); ++i)
          if (numbering.layout().is_owned(springs[i].unknowns[3]))
            account.add(strain_entry,
                        springs[i].stiffness / 2 *
                          material_angle(i, step).norm_square());
      }

      void row_force_bounds(const Evaluation &evaluation,
                            const EffectCache * /*results*/,
                            double *forces) const override
      {
        for (unsigned int i = 0; i < springs.size(); ++i)
          for (const int unknown : springs[i].unknowns)
            raise_bound(forces,
                        unknown,
                        springs[i].stiffness *
                          material_angle(i, evaluation).norm());
      }

      void roundoff_force_bounds(const Evaluation & /*evaluation*/,
                                 const EffectCache * /*results*/,
                                 const LargestMotion &largest,
                                 double              *forces) const override
      {
        for (const Spring &spring : springs)
          for (const int unknown : spring.unknowns)
            raise_bound(forces, unknown, spring.stiffness * largest.rotation);
      }

    private:
      struct Spring : SpaceSpring
      {
        std::array<int, 6> unknowns; ///< spins of both; -1: ground
      };

      Quaternion base_rotation(const Spring &spring, const State &state) const
      {
        return spring.first < 0 ? Quaternion() : state.rotations[spring.first];
      }

      /** Material rotation vector P_1^-1 psi (rad). */
      SpaceVector material_angle(const unsigned int i,
                                 const Evaluation  &evaluation) const
      {
        const Spring &spring = springs[i];
        const double *before = &evaluation.from.history[first_history + 3 * i];
        return rotation_vector_near(
          conjugate(base_rotation(spring, evaluation.to)) *
            evaluation.to.rotations[spring.second],
          SpaceVector({before[0], before[1], before[2]}));
      }

      /** Spatial rotation vector psi (rad). */
      SpaceVector angle(const unsigned int i,
                        const Evaluation  &evaluation) const
      {
        return rotated(base_rotation(springs[i], evaluation.to),
                       material_angle(i, evaluation));
      }

      /**
       * Moment on the second rotation in a discrete-gradient step (N m), from
       * the material rotation vector at its end: the mean, corrected along the
       * relative rotation so that its work is the change of energy (Gonzalez
       * 1996).
       */
      SpaceVector mean_moment(const unsigned int i,
                              const SpaceVector &after,
                              const Evaluation  &step) const
      {
        const Spring     &spring = springs[i];
        const double     *values = &step.from.history[first_history + 3 * i];
        const SpaceVector before({values[0], values[1], values[2]});
        const Quaternion  base_0 = base_rotation(spring, step.from),
                         base_1  = base_rotation(spring, step.to);
        const SpaceVector mean =
                            (rotated(base_0, before) + rotated(base_1, after)) /
          2,
                          turn =
                            cayley_rotation(
                              step.to.rotations[spring.second] *
                              conjugate(step.from.rotations[spring.second])) -
          cayley_rotation(base_1 * conjugate(base_0));
        const double missing_work =
          (after + before) * (after - before) / 2 - mean * turn;
        return spring.stiffness *
          (std::abs(missing_work) <= few_round_offs * mean.norm()
             ? mean
             : mean + missing_work / turn.norm_square() * turn);
      }

      const DofNumbering &numbering;
      std::vector<Spring> springs;
      std::size_t         first_history = 0, first_block = 0;
      unsigned int        strain_entry = 0;
    };
  } // namespace

  double mean_moment_factor(const std::array<int, 2> &unknowns,
                            const Evaluation         &step)
  {
    if (step.to.plane_rotations->empty())
      return 1;
    const auto half_increment = [&](const int unknown) {
      return unknown < 0
        ? 0.
        : (step.to.displacement[unknown] - step.from.displacement[unknown]) / 2;
    };
    const double base = half_increment(unknowns[0]),
                 end  = half_increment(unknowns[1]);
    return std::cos(base) * std::cos(end) / sinc(end - base);
  }

  std::unique_ptr<Effect>
  make_rotational_springs(const DofNumbering           &numbering,
                          std::vector<RotationalSpring> springs)
  {
    return std::make_unique<RotationalSprings>(numbering, std::move(springs));
  }

  std::unique_ptr<Effect>
  make_space_springs(const DofNumbering             &numbering,
                     const std::vector<SpaceSpring> &springs)
  {
    return std::make_unique<SpaceSprings>(numbering, springs);
  }
} // namespace auxfem
