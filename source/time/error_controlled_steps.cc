#include <auxfem/time/divided_interval.h>
#include <auxfem/time/step_control.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    const std::string error_controlled_steps_record =
      "step control by errors: whether there is a target, target, begin, "
      "length, pieces, position, length wanted, length, mean error";

    /** @name Relative errors, of which one is what is wanted in the mean. */
    ///@{
    /** In an oscillation the error of single steps is larger than the mean. */
    constexpr double largest_of_a_step = 3;
    /** Lengths stay as they are between these, so that factorizations serve. */
    constexpr double largest_mean = 1.2, largest_of_longer_steps = 0.7;
    constexpr double aim_of_shorter_steps = 0.8;
    ///@}

    /** Of the newest step in the mean. */
    constexpr double share_of_newest = 0.25;

    /** The smallest number that is not less than @p n, of 1, 2, 3, 4, 6, 8 and
     * from there on multiples of a power of two of which 8 are twice it. */
    unsigned int number_of_pieces(const double n)
    {
      constexpr double round_off = 1e-6;
      const double     least     = n * (1 - round_off);
      unsigned int     unit      = 1;
      // Of a few pieces, five or seven could not be divided anew on the way.
      while (least > (unit == 1 ? 4 : 8) * unit)
        unit *= 2;
      return unit * std::max(1u, unsigned(std::ceil(least / unit)));
    }

    unsigned int next(const unsigned int pieces)
    {
      return number_of_pieces(pieces + 0.5);
    }

    class ErrorControlledSteps : public StepControl
    {
    public:
      ErrorControlledSteps(const double       step,
                           const double       smallest,
                           const unsigned int order)
        : step(step)
        , smallest(smallest)
        , order(order)
        , wanted(step)
      {}

      PlannedStep plan(const double time, const double target) override
      {
        if (!interval.leads_to(target))
          interval.start(
            time,
            target,
            step,
            pieces_of(DividedInterval::length_between(time, target, step),
                      wanted));
        const PlannedStep planned = interval.next();
        change_length(planned.dt);
        return planned;
      }

      void accepted(const double relative_error) override
      {
        mean += share_of_newest * (relative_error - mean);
        interval.pass();
        if (mean > largest_mean)
          wanted = dt * factor_for(aim_of_shorter_steps);
        else
          wanted = dt * std::max(1., factor_for(largest_of_longer_steps));
        if (interval.is_open())
          divide();
      }

      bool may_be_accepted(const double relative_error) const override
      {
        return relative_error <= largest_of_a_step || !may_be_shorter();
      }

      bool rejected(const double relative_error) override
      {
        if (!may_be_shorter())
          return false;
        // The step was not solved, or its error was too large.
        mean   = std::max(mean, relative_error);
        wanted = relative_error == 0
          ? dt / 2
          : dt * std::min(0.5, factor_for(aim_of_shorter_steps));
        divide();
        return true;
      }

      double shortest() const override
      {
        return smallest;
      }

      void save(Records &records) const override
      {
        std::vector<double> values = interval.values();
        values.insert(values.end(), {wanted, dt, mean});
        records.keep(error_controlled_steps_record, values);
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values =
          records.values(error_controlled_steps_record,
                         DividedInterval::n_values + 3);
        interval.restore(values);
        wanted = values[DividedInterval::n_values];
        dt     = values[DividedInterval::n_values + 1];
        mean   = values[DividedInterval::n_values + 2];
      }

    private:
      bool may_be_shorter() const
      {
        return interval.length() / (2 * interval.pieces()) >= smallest;
      }

      /** By how much longer steps have the mean error @p error. */
      double factor_for(const double error) const
      {
        return std::pow(error / std::max(mean, 1e-30), 1. / order);
      }

      unsigned int pieces_of(const double length, const double piece) const
      {
        const unsigned int wanted_pieces = number_of_pieces(length / piece);
        unsigned int       pieces        = 1;
        while (pieces < wanted_pieces && length / next(pieces) >= smallest)
          pieces = next(pieces);
        return pieces;
      }

      /** From here on in pieces of the length wanted, or as near as pieces that
       * begin here come to it. */
      void divide()
      {
        const unsigned int now  = interval.pieces(),
                           best = pieces_of(interval.length(), wanted);
        for (unsigned int pieces = best; pieces != now; pieces = next(pieces))
          if (interval.divide(pieces))
            return;
      }

      /** The mean error becomes that of steps of length @p next. */
      void change_length(const double next)
      {
        if (dt > 0)
          mean *= std::pow(next / dt, order);
        dt = next;
      }

      const double       step, smallest;
      const unsigned int order;
      DividedInterval    interval;
      /** The length that the error asks for, that of steps now, 0 before the
       * first (s). */
      double wanted, dt = 0;
      /** Of relative errors of steps as long as now. */
      double mean = 0;
    };
  } // namespace

  std::unique_ptr<StepControl>
  make_error_controlled_steps(const double       step,
                              const double       smallest,
                              const unsigned int order)
  {
    return std::make_unique<ErrorControlledSteps>(step, smallest, order);
  }
} // namespace auxfem
