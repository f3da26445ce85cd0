#ifndef auxfem_tests_equations_effects_mean_step_h
#define auxfem_tests_equations_effects_mean_step_h

#include <auxfem/equations/node_rotations.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <random>

namespace auxfem
{
  namespace testing_support
  {
    /** A scene in the plane with irregular states at the start and the end of a
     * step, for Kind::discrete_gradient. */
    struct MeanStep
    {
      explicit MeanStep(const std::string &text,
                        const unsigned int seed           = 1,
                        const bool         large_rotation = true)
        : setup(text,
                {"Time/Scheme=energy-momentum",
                 std::string("Effects/Large rotation=") +
                   (large_rotation ? "on" : "off")},
                MPI_COMM_SELF)
        , n(setup.dofs().layout().n_local())
        , from(setup.equations.initial_state())
        , to(from)
      {
        std::mt19937 generator(seed);
        const auto   number = [&](const double size) {
          return size * (2. * generator() / generator.max() - 1);
        };
        from.time = 0.2;
        to.time   = 0.2 + dt;
        for (unsigned int i = 0; i < n; ++i)
          {
            from.displacement[i] = number(0.4);
            (*from.velocity)[i]  = number(0.5);
            to.displacement[i]   = from.displacement[i] + number(0.5);
          }
        for (double &value : from.history)
          value = number(0.3);
        find_rates();
      }

      /** Registers the state of @p effect alone. */
      void make_room_for(Effect &effect)
      {
        StateLayout layout;
        effect.register_in(layout);
        make_room(layout, from);
        make_room(layout, to);
        for (double &value : from.history)
          value = 0.3;
      }

      /** Sets the rates of `to` as the scheme does. */
      void find_rates()
      {
        const Evaluation step = evaluation();
        const StepTravel travel(step, setup.dofs());
        for (unsigned int i = 0; i < n; ++i)
          {
            (*to.velocity)[i] = 2 * travel.of(i) / dt - (*from.velocity)[i];
            (*to.acceleration)[i] =
              ((*to.velocity)[i] - (*from.velocity)[i]) / dt;
          }
      }

      Evaluation evaluation()
      {
        return Evaluation::discrete_gradient(from, to, dt);
      }

      /** Energies at the start, stored in its state. */
      Energies at_start(const Effect &effect)
      {
        const State before = from;
        return EvaluatedAlone(effect,
                              Evaluation::consistent_rates(before, from))
          .accept();
      }

      /** Work of the forces in the step. */
      double work(const double *forces)
      {
        const Evaluation step = evaluation();
        const StepTravel travel(step, setup.dofs());
        double           sum = 0;
        for (unsigned int i = 0; i < n; ++i)
          if (setup.dofs().unknowns().kinds[i] != UnknownKind::multiplier)
            sum += forces[i] * travel.of(i);
        return sum;
      }

      /** Resultant force, and moment about the mean positions of the step. */
      std::array<double, 3> resultants(const double *forces) const
      {
        const std::vector<NamedUnknown>     names = name_unknowns(setup.model);
        std::map<UnknownName, unsigned int> unknowns;
        for (unsigned int i = 0; i < n; ++i)
          unknowns[names[i].name] = i;
        std::array<double, 3> sums = {{0, 0, 0}};
        for (const auto &[name, i] : unknowns)
          {
            if (setup.dofs().unknowns().kinds[i] == UnknownKind::multiplier)
              continue;
            auto               partner   = name;
            const unsigned int component = std::get<3>(name);
            if (component >= first_rotation)
              {
                sums[2] += forces[i];
                continue;
              }
            sums[component] += forces[i];
            std::get<3>(partner)        = 1 - component;
            const unsigned int other    = unknowns.at(partner);
            const double       position = names[i].position[1 - component] +
              (from.displacement[other] + to.displacement[other]) / 2;
            sums[2] += (component == 1 ? 1 : -1) * position * forces[i];
          }
        return sums;
      }

      void expect_no_resultants(const double *forces) const
      {
        for (const double sum : resultants(forces))
          EXPECT_NEAR(sum, 0, 1e-12);
      }

      /** Largest difference between the tangent of @p effect and finite
       * differences. */
      double error_of_tangent(Effect &effect)
      {
        TangentAlone tangent(effect, setup.dofs());
        tangent.fill(EvaluatedAlone(effect, evaluation()),
                     {0.5, 1 / dt, 2 / (dt * dt)});
        double error = 0;
        for (unsigned int k = 0; k < n; ++k)
          {
            const double        h = 1e-5;
            std::vector<double> unit(n, 0.);
            unit[k]                           = 1;
            const std::vector<double> column  = tangent.times(unit);
            const auto                rows_at = [&](const double change) {
              const State kept = to;
              to.displacement[k] += change;
              const auto rows = EvaluatedAlone(effect, evaluation()).residual;
              to              = kept;
              return rows;
            };
            const auto plus = rows_at(h), minus = rows_at(-h);
            for (unsigned int i = 0; i < n; ++i)
              error =
                std::max(error,
                         std::abs((plus[i] - minus[i]) / (2 * h) - column[i]));
          }
        return error;
      }

      static constexpr double dt = 0.7;
      EquationsOnRanks        setup;
      const unsigned int      n;
      State                   from, to;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
