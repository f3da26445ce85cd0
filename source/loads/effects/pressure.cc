#include <auxfem/equations/load_work.h>
#include <auxfem/loads/effects/pressure.h>

#include <utility>

namespace auxfem
{
  namespace
  {
    class Pressures : public Effect, public StageTerms
    {
    public:
      Pressures(const DofNumbering       &numbering,
                const bool                large_rotation,
                const bool                raised_from_zero,
                std::vector<PressureLoad> given)
        : numbering(numbering)
        , follows(large_rotation)
        , raised_from_zero(raised_from_zero)
      {
        for (PressureLoad &load : given)
          loads.push_back({std::move(load)});
      }

      bool is_linear() const override
      {
        return !follows;
      }

      void register_in(StateLayout &layout) override
      {
        for (Load &load : loads)
          load.work_entry = layout.energies.enter(load.load.work);
      }

      void add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectCache * /*results*/) const override
      {
        const bool is_mean =
          evaluation.kind == Evaluation::Kind::discrete_gradient;
        for (const Load &load : loads)
          add_forces(load,
                     -pressure(load, evaluation),
                     is_mean ? &evaluation.from.displacement : nullptr,
                     evaluation.to.displacement,
                     residual);
      }

      void add_tangent(const Evaluation &evaluation,
                       const EffectCache * /*results*/,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override
      {
        if (!follows || factors.stiffness == 0)
          return;
        for (const Load &load : loads)
          {
            const double p = factors.stiffness * pressure(load, evaluation);
            for (const PressureLoad::Element &element : load.load.elements)
              {
                const unsigned int n_nodes = element.positions.size() / 2,
                                   n       = n_components * n_nodes;
                std::vector<double> block(n * n, 0.);
                for (unsigned int a = 0; a < n_nodes; ++a)
                  for (unsigned int b = 0; b < n_nodes; ++b)
                    {
                      const double force =
                        p * element.integrals[a * n_nodes + b];
                      const unsigned int row    = n_components * a,
                                         column = n_components * b;
                      block[row * n + column + 1] += force;
                      block[(row + 1) * n + column] -= force;
                    }
                matrix.add(element.number, block.data());
              }
          }
      }

      void add_load_derivative(const Evaluation &evaluation,
                               double           *derivative) const override
      {
        for (const Load &load : loads)
          add_forces(load,
                     -load.load.history.jet(time_of_loads(evaluation.to))[1],
                     nullptr,
                     evaluation.to.displacement,
                     derivative);
      }

      void account_step(const Evaluation &step,
                        const EffectCache * /*results*/,
                        EnergyAccount &account) const override
      {
        const Vector &before = step.from.displacement,
                     &now    = step.to.displacement;
        for (const Load &load : loads)
          {
            const double p_before = value_before(load, step),
                         p_now    = value_at_end(load.load.history, step);
            double work;
            if (step.kind == Evaluation::Kind::discrete_gradient)
              work = (p_before + p_now) / 2 *
                (area_swept(load, mean(before, now), now) -
                 area_swept(load, mean(before, now), before));
            else
              work = (p_before *
                        (area_swept(load, before, now) -
                         area_swept(load, before, before)) +
                      p_now *
                        (area_swept(load, now, now) -
                         area_swept(load, now, before))) /
                2;
            account.add_in_step(load.work_entry, work);
          }
      }

      void account_stage(const Evaluation &stage,
                         const EffectCache * /*results*/,
                         EnergyAccount &account) const override
      {
        for (const Load &load : loads)
          account.add_power(load.work_entry,
                            value_at_end(load.load.history, stage) *
                              area_swept(load,
                                         stage.to.displacement,
                                         *stage.to.velocity));
      }

    private:
      static constexpr unsigned int n_components = 3;

      struct Load
      {
        PressureLoad load;
        unsigned int work_entry = 0; ///< in the energy ledger
      };

      double value_before(const Load &load, const Evaluation &step) const
      {
        return raised_from_zero && step.from.time == 0
          ? 0.
          : value_at_start(load.load.history, step);
      }

      /** Pressure in an evaluation: the mean in steps of mean forces. */
      double pressure(const Load &load, const Evaluation &evaluation) const
      {
        const double now = value_at_end(load.load.history, evaluation);
        return evaluation.kind == Evaluation::Kind::discrete_gradient
          ? (value_before(load, evaluation) + now) / 2
          : now;
      }

      static Vector mean(const Vector &one, const Vector &other)
      {
        Vector result = one;
        for (std::size_t i = 0; i < result.size(); ++i)
          result[i] = (one[i] + other[i]) / 2;
        return result;
      }

      /** Calls @p act with local unknowns and the force of unit pressure on
       * them, at displacements u(unknown). */
      template <class Displacement, class Action>
      void for_each_force(const PressureLoad::Element &element,
                          const Displacement          &u,
                          const Action                &act) const
      {
        const int *unknowns        = numbering.element_unknowns(element.number);
        const unsigned int n_nodes = element.positions.size() / 2;
        const auto position = [&](const unsigned int b, const unsigned int c) {
          const double rest = element.positions[2 * b + c];
          return follows ? rest + u(unknowns[n_components * b + c]) : rest;
        };
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            double x = 0, y = 0;
            for (unsigned int b = 0; b < n_nodes; ++b)
              {
                const double integral = element.integrals[a * n_nodes + b];
                x += integral * position(b, 0);
                y += integral * position(b, 1);
              }
            act(unknowns[n_components * a], -y);
            act(unknowns[n_components * a + 1], x);
          }
      }

      /** Adds @p factor times the forces of unit pressure, at the mean of two
       * displacements unless @p before is nullptr. */
      void add_forces(const Load   &load,
                      const double  factor,
                      const Vector *before,
                      const Vector &now,
                      double       *forces) const
      {
        for (const PressureLoad::Element &element : load.load.elements)
          for_each_force(
            element,
            [&](const int i) {
              return before == nullptr ? now[i] : ((*before)[i] + now[i]) / 2;
            },
            [&](const int unknown, const double force) {
              forces[unknown] += factor * force;
            });
      }

      /** Work of unit pressure at the displacements @p u along @p way, over the
       * elements owned by this rank. */
      double
      area_swept(const Load &load, const Vector &u, const Vector &way) const
      {
        double sum = 0;
        for (const PressureLoad::Element &element : load.load.elements)
          if (numbering.elements()[element.number].is_owned)
            for_each_force(
              element,
              [&](const int i) { return u[i]; },
              [&](const int unknown, const double force) {
                sum += force * way[unknown];
              });
        return sum;
      }

      const DofNumbering &numbering;
      const bool          follows, raised_from_zero;
      std::vector<Load>   loads;
    };
  } // namespace

  std::unique_ptr<Effect> make_pressures(const DofNumbering &numbering,
                                         const bool          large_rotation,
                                         const bool          raised_from_zero,
                                         std::vector<PressureLoad> loads)
  {
    return std::make_unique<Pressures>(numbering,
                                       large_rotation,
                                       raised_from_zero,
                                       std::move(loads));
  }
} // namespace auxfem
