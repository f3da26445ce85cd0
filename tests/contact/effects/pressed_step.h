#ifndef auxfem_tests_equations_effects_pressed_step_h
#define auxfem_tests_equations_effects_pressed_step_h

#include <auxfem/contact/effects/contact.h>
#include <auxfem/time/schemes/static.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

namespace auxfem
{
  namespace testing_support
  {
    constexpr double contact_step = 0.3; ///< s

    struct ContactCase
    {
      std::string  name;
      unsigned int dimension;
      std::string  plate; ///< its shape and where it is, just below the lattice
    };

    /** A beam and a post on it, half a thickness of 0.1 m (in space 0.05 m),
     * above a plate that is free. */
    inline SceneText above_plate(const ContactCase &contact_case,
                                 const double       friction)
    {
      SceneText text;
      text.frame("0 0; 1 0; 0.3 1", "0 1; 1 2")
        .rectangle("bar", 0.1, 0.2, {30, 5, 0.3})
        .mesh(3, 1)
        .time(1, contact_step, "newmark")
        .add("Plates/plate",
             contact_case.plate +
               " | Displacement x = free | Displacement y = free | Mass = 2")
        .add("Contact",
             "Slip velocity = 0.4 | Smoothing = 0.2 | Friction coefficient = " +
               testing_support::text(friction));
      if (contact_case.dimension == 3)
        text.dimension(3)
          .set("Lattice/Joints", "0 0 0; 1 0 0; 0.3 1 0.4")
          .set("Plates/plate/Displacement z", "free");
      return text;
    }

    /** A step in which the beam presses on the plate and slides. */
    struct PressedStep
    {
      PressedStep(const std::string &text,
                  const bool         is_between,
                  const MPI_Comm     communicator = MPI_COMM_SELF)
        : setup(text,
                {is_between ? "Time/Scheme=energy-momentum"
                            : "Time/Scheme=newmark"},
                communicator)
        , contact(*setup.equations.reporting().plates)
        , before(setup.equations.initial_state())
        , from(before)
        , to(before)
      {
        setup.equations.update_couplings(before);
        for (State *state : {&before, &from, &to})
          state->extend_ghosts(layout());
        n = to.displacement.size();
        fill(0.01, before.displacement);
        fill(0.02, from.displacement);
        fill(0.015, to.displacement);
        fill(0.5, *from.velocity);
        fill(0.7, *to.velocity);
        set_plate(0, 0.03, from.displacement);
        set_plate(1, 0.03, from.displacement);
        set_plate(0, 0.045, to.displacement);
        set_plate(1, 0.045, to.displacement);
        set_plate(0, 0.8, *from.velocity);
        set_plate(0, 0.8, *to.velocity);
        from.before = State::Before{-contact_step,
                                    contact_step,
                                    before.displacement,
                                    before.residual};
        to.time     = contact_step;
      }

      const UnknownLayout &layout() const
      {
        return setup.equations.unknowns().layout;
      }

      void fill(const double size, Vector &values) const
      {
        fill_by_position(setup.model, size, values);
        layout().update_ghosts(values.data());
      }

      /** Unknown of a motion component of the plate. */
      void set_plate(const unsigned int component,
                     const double       value,
                     Vector            &values) const
      {
        const unsigned int plate = setup.lattice.joint_of_plate(0);
        if (const int unknown =
              layout().local(setup.dofs().global().joints[plate][component]);
            unknown >= 0)
          values[unknown] = value;
      }

      Evaluation evaluation(const Evaluation::Kind kind)
      {
        switch (kind)
          {
            case Evaluation::Kind::discrete_gradient:
              return Evaluation::discrete_gradient(from, to, contact_step);
            case Evaluation::Kind::static_step:
              return Evaluation::static_step(from, to, contact_step);
            case Evaluation::Kind::equilibrium:
              return Evaluation::equilibrium(from, to);
            default:
              return Evaluation::step(from, to, contact_step);
          }
      }

      EquationsOnRanks    setup;
      const PlateContact &contact;
      State               before, from, to;
      unsigned int        n = 0;
    };

    /** Derivative of the end velocity with respect to the displacement. */
    inline double velocity_factor(PressedStep           &step,
                                  const Evaluation::Kind kind)
    {
      return kind == Evaluation::Kind::static_step
        ? BackwardDifference(step.from, contact_step).now
        : 2 / contact_step;
    }

    /** Largest error of a column of the tangent, relative to its largest
     * entry. */
    inline double error_of_tangent(PressedStep           &step,
                                   const Evaluation::Kind kind)
    {
      const double         velocity_weight = velocity_factor(step, kind);
      const Evaluation     evaluation      = step.evaluation(kind);
      const EvaluatedAlone evaluated(step.contact, evaluation);
      TangentMatrix        matrix(step.setup.equations.pattern());
      step.contact.add_tangent(evaluation,
                               evaluated.results.get(),
                               {1., velocity_weight, 0.},
                               matrix);
      const double h     = 1e-6;
      double       error = 0, largest = 0;
      for (unsigned int k = 0; k < step.n; ++k)
        {
          std::vector<double> unit(step.n, 0.), column(step.n);
          unit[k] = 1;
          matrix.multiply(unit.data(), column.data());
          const auto rows_at = [&](const double change) {
            const State kept = step.to;
            step.to.displacement[k] += change;
            (*step.to.velocity)[k] += change * velocity_weight;
            const auto rows = EvaluatedAlone(step.contact, evaluation).residual;
            step.to         = kept;
            return rows;
          };
          const auto plus = rows_at(h), minus = rows_at(-h);
          for (unsigned int i = 0; i < step.n; ++i)
            {
              largest = std::max(largest, std::abs(column[i]));
              error =
                std::max(error,
                         std::abs((plus[i] - minus[i]) / (2 * h) - column[i]));
            }
        }
      EXPECT_GT(largest, 0);
      return error / largest;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
