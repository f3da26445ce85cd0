#ifndef auxfem_tests_equations_effects_space_effect_h
#define auxfem_tests_equations_effects_space_effect_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/model/unknown_records.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

namespace auxfem
{
  namespace testing_support
  {
    /** Circular struts of 1 m in space, with @p further parameters. */
    inline SceneText space_frame(const std::string &joints,
                                 const std::string &struts,
                                 const SceneText   &further = {})
    {
      return SceneText()
        .dimension(3)
        .frame(joints, struts)
        .circle("rod", 0.1, {1000, 2})
        .mesh(1)
        .add(further);
    }

    /** A spatial scene far from rest for tests of single effects. */
    struct SpaceEffect
    {
      explicit SpaceEffect(const std::string &text, const bool large_rotation)
        : setup(text,
                large_rotation
                  ? std::vector<std::string>()
                  : std::vector<std::string>{"Effects/Large rotation=off"},
                MPI_COMM_SELF)
        , rotations(setup.dofs())
        , from(setup.equations.initial_state())
        , to(from)
        , n(setup.dofs().layout().n_global())
      {
        to = moved(irregular(0.4), 1.5);
        for (unsigned int i = 0; i < n; ++i)
          {
            (*to.velocity)[i]     = 0.8 * std::sin(2 + 1.7 * i);
            (*to.acceleration)[i] = 1.1 * std::sin(3 + 1.1 * i);
          }
      }

      bool is_multiplier(const unsigned int i) const
      {
        return setup.dofs().unknowns().kinds[i] == UnknownKind::multiplier;
      }

      std::vector<double> irregular(const double phase) const
      {
        std::vector<double> result;
        for (unsigned int i = 0; i < n; ++i)
          result.push_back(std::sin(phase + 1.9 * i));
        return result;
      }

      /** Adds the state variables of @p effect to the states. */
      void make_room_for(Effect &effect)
      {
        StateLayout layout = setup.equations.layout();
        effect.register_in(layout);
        make_room(layout, from);
        make_room(layout, to);
      }

      /** Residual at the end of a step of one second. */
      std::vector<double> residual(const Effect &effect, const State &at) const
      {
        State state = at;
        return EvaluatedAlone(effect, Evaluation::step(from, state, 1.))
          .residual;
      }

      /** Residual of the instant `to`. */
      std::vector<double> residual_of_rates(const Effect &effect) const
      {
        State state = to;
        return EvaluatedAlone(effect, Evaluation::consistent_rates(from, state))
          .residual;
      }

      /** `to` after an increment, spins in the rows of rotations. */
      State moved(const std::vector<double> &direction,
                  const double               size,
                  const TangentFactors      &factors = {1., 0., 0.}) const
      {
        State  state = to;
        Vector increment(to.displacement);
        for (unsigned int i = 0; i < n; ++i)
          increment[i] = size * direction[i];
        rotations.rotate(Evaluation::step(from, state, 1.), increment);
        add_multiple(1., increment, state.displacement);
        add_multiple(factors.damping, increment, *state.velocity);
        add_multiple(factors.mass, increment, *state.acceleration);
        return state;
      }

      /** `to` after the time @p t with its velocities and accelerations. */
      State at_time(const double t) const
      {
        State  state = to;
        Vector turn(to.displacement.size());
        add_multiple(t, *to.velocity, turn);
        add_multiple(t * t / 2, *to.acceleration, turn);
        for (unsigned int i = 0; i < state.rotations.size(); ++i)
          state.rotations[i] =
            state.rotations[i] * exponential(rotations.values(turn, i));
        add_multiple(1., turn, state.displacement);
        return state;
      }

      /** Compares the tangent of @p effect with differences. */
      void expect_tangent(Effect &effect, const TangentFactors &factors)
      {
        TangentAlone tangent(effect, setup.dofs());
        tangent.fill(EvaluatedAlone(effect, Evaluation::step(from, to, 1.)),
                     factors);
        const std::vector<double> direction = irregular(0.9),
                                  y         = tangent.times(direction);

        const double h       = 1e-5;
        const auto   forward = residual(effect, moved(direction, h, factors)),
                   backward  = residual(effect, moved(direction, -h, factors));
        double size          = 0;
        for (unsigned int i = 0; i < n; ++i)
          size = std::max(size, std::abs(y[i]));
        EXPECT_GT(size, 0.1);
        for (unsigned int i = 0; i < n; ++i)
          // h^2 and round-off 1e-15 / h.
          EXPECT_NEAR(y[i], (forward[i] - backward[i]) / (2 * h), 1e-8 * size)
            << describe(setup.dofs(), i);
      }

      /** Expects forces of multipliers to be derivatives of the constraints. */
      void expect_forces_by_constraints(const Effect &constraints)
      {
        const std::vector<double> rows = residual(constraints, to);
        const double              h    = 1e-5;
        for (unsigned int i = 0; i < n; ++i)
          {
            if (is_multiplier(i))
              continue;
            std::vector<double> direction(n, 0.);
            direction[i]        = 1;
            const auto forward  = residual(constraints, moved(direction, h)),
                       backward = residual(constraints, moved(direction, -h));
            double work         = 0;
            for (unsigned int k = 0; k < n; ++k)
              if (is_multiplier(k))
                work += to.displacement[k] * (forward[k] - backward[k]);
            EXPECT_NEAR(rows[i], work / (2 * h), 1e-8)
              << describe(setup.dofs(), i);
          }
      }

      /** Expects first and second derivatives in time to be those of
       * differences. */
      void expect_time_derivatives(const Constraints &constraints)
      {
        const double        small = 1e-5, long_step = 1e-3;
        std::vector<double> rates(n, 0.);
        constraints.find_rates(to, rates.data());
        const auto second   = residual_of_rates(constraints),
                   here     = residual(constraints, to),
                   forward  = residual(constraints, at_time(small)),
                   backward = residual(constraints, at_time(-small)),
                   later    = residual(constraints, at_time(long_step)),
                   before   = residual(constraints, at_time(-long_step));
        for (unsigned int i = 0; i < n; ++i)
          if (is_multiplier(i))
            {
              EXPECT_NEAR(rates[i],
                          (forward[i] - backward[i]) / (2 * small),
                          1e-8);
              // Fourth derivatives of about 10: h^2; round-off 1e-15 / h^2.
              EXPECT_NEAR(second[i],
                          (later[i] - 2 * here[i] + before[i]) /
                            (long_step * long_step),
                          1e-5)
                << describe(setup.dofs(), i);
            }
          else
            EXPECT_EQ(rates[i], 0);
      }

      EquationsOnRanks    setup;
      const NodeRotations rotations;
      State               from, to;
      const unsigned int  n;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
