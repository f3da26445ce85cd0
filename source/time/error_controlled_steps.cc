#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/divided_interval.h>
#include <auxfem/time/step_control.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Relative error above which a step is repeated.
     * @tuned judgement: errors of single steps exceed their mean in an
     * oscillation
     */
    constexpr double largest_error = 3;

    /**
     * Ratio of the wanted length to the present one, or its inverse, up to
     * which steps keep their length.
     * @tuned judgement: a new length costs a factorization
     */
    constexpr double least_change = 1.25;

    unsigned int more_pieces(const unsigned int pieces)
    {
      if (pieces == 1)
        return 2;
      return pieces % 3 == 0 ? pieces / 3 * 4 : pieces / 2 * 3;
    }

    unsigned int fewer_pieces(const unsigned int pieces)
    {
      if (pieces == 2)
        return 1;
      return pieces % 3 == 0 ? pieces / 3 * 2 : pieces / 4 * 3;
    }

    /**
     * Weight of the newest error in the mean.
     * @tuned judgement
     */
    constexpr double share_of_newest = 0.25;

    /** Takes the length from a moving mean of errors: their sum counts, and
     * single ones go up and down in an oscillation and where struts hit each
     * other. */
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
            pieces_of(DividedInterval::length_between(time, target, step)));
        const PlannedStep planned = interval.next();
        if (dt > 0)
          mean *= std::pow(planned.dt / dt, order);
        dt = planned.dt;
        return planned;
      }

      void accepted(const double relative_error) override
      {
        mean += share_of_newest * (relative_error - mean);
        const double factor =
          std::pow(std::max(mean, least_error) / safety_of_steps, -1. / order);
        const bool is_kept = factor > 1 / least_change && factor < least_change;
        wanted             = piece() * (is_kept ? 1 : factor);
        interval.pass();
        if (interval.is_open())
          divide();
      }

      bool may_be_accepted(const double relative_error) const override
      {
        return relative_error <= largest_error || !may_be_shorter();
      }

      bool rejected(const double relative_error) override
      {
        if (!may_be_shorter())
          return false;
        const double factor =
          relative_error > 0 ? std::pow(relative_error, -1. / order) : 0.5;
        wanted = piece() * std::min(0.5, factor);
        mean   = std::max(mean, relative_error);
        divide();
        return true;
      }

      double shortest() const override
      {
        return smallest;
      }

      void serialize(CheckpointArchive &archive) override
      {
        archive.values("step-size controller", wanted, mean, dt);
      }

    private:
      /** Smaller errors are taken for this one, so that no step is more than
       * about three times as long as the one before. */
      static constexpr double least_error = 0.01;

      double piece() const
      {
        return interval.length() / interval.pieces();
      }

      bool may_be_shorter() const
      {
        return piece() / 2 >= smallest;
      }

      /** A number of the form 2^k or 3 2^k. */
      unsigned int pieces_of(const double length) const
      {
        unsigned int pieces = 1;
        while (length / pieces > (1 + given_digits) * wanted)
          pieces = more_pieces(pieces);
        while (pieces > 1 && length / pieces < smallest)
          pieces = fewer_pieces(pieces);
        return pieces;
      }

      /** Divides the rest of the interval into pieces of the wanted length, or
       * the nearest one that a piece can begin with here. */
      void divide()
      {
        const unsigned int now = interval.pieces();
        for (unsigned int pieces = pieces_of(interval.length()); pieces != now;
             pieces              = more_pieces(pieces))
          if (interval.divide(pieces))
            return;
      }

      const double       step, smallest;
      const unsigned int order;
      DividedInterval    interval;
      double             wanted; ///< length of steps (s)
      /** Mean relative error for the present length. */
      double mean = 0;
      double dt   = 0; ///< present length, 0 before the first step (s)
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
