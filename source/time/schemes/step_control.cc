#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/schemes/step_control.h>
#include <auxfem/time/schemes/time_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /**
     * Factor by which an extrapolation may enlarge errors of its values.
     * @tuned judgement: a parabola over equal steps has 7, a cubic 15
     */
    constexpr double largest_sum_of_weights = 8;

    struct Parabola
    {
      std::array<unsigned int, 3> points  = {};
      std::array<double, 3>       weights = {}; ///< of their values (Lagrange)
      /** Proportional to its error. */
      double distance = std::numeric_limits<double>::infinity();
    };

    void find_weights(Parabola                  &parabola,
                      const std::vector<double> &times,
                      const double               time)
    {
      const auto &points = parabola.points;
      parabola.weights   = {{1, 1, 1}};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          if (j != i)
            parabola.weights[i] *=
              (time - times[points[j]]) / (times[points[i]] - times[points[j]]);
    }

    bool amplifies_errors(const Parabola &parabola)
    {
      double sum = 0;
      for (const double weight : parabola.weights)
        sum += std::abs(weight);
      // NaN if two times are equal.
      return !(sum <= largest_sum_of_weights);
    }
  } // namespace

  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, const double time)
  {
    const unsigned int n        = times.size();
    const auto         distance = [&](const unsigned int point) {
      return std::abs(time - times[point]);
    };
    Parabola   best;
    const auto try_points =
      [&](const unsigned int i, const unsigned int j, const unsigned int k) {
        Parabola parabola;
        parabola.points   = {{i, j, k}};
        parabola.distance = distance(i) * distance(j) * distance(k);
        if (!(parabola.distance < best.distance))
          return;
        find_weights(parabola, times, time);
        if (!amplifies_errors(parabola))
          best = parabola;
      };
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        for (unsigned int k = 0; k < j; ++k)
          try_points(i, j, k);

    std::vector<std::pair<unsigned int, double>> list;
    if (best.distance < std::numeric_limits<double>::infinity())
      for (unsigned int i = 0; i < 3; ++i)
        list.emplace_back(best.points[i], best.weights[i]);
    else if (n > 0)
      {
        unsigned int nearest = 0;
        for (unsigned int i = 1; i < n; ++i)
          if (distance(i) < distance(nearest))
            nearest = i;
        list.emplace_back(nearest, 1.);
      }
    return list;
  }

  std::unique_ptr<StepControl>
  make_step_control(const TimeParameters &parameters)
  {
    const double smallest = parameters.smallest_step > 0
      ? parameters.smallest_step
      : parameters.step / 1024;
    return parameters.relative_tolerance
      ? make_error_controlled_steps(parameters.step,
                                    smallest,
                                    parameters.implicit_scheme().order())
      : make_halved_steps(parameters.step, smallest);
  }

  void DividedInterval::start(const double       time,
                              const double       next_target,
                              const double       step,
                              const unsigned int pieces)
  {
    target   = next_target;
    begin    = time;
    whole    = length_between(time, next_target, step);
    n_pieces = pieces;
    number   = 0;
  }

  double DividedInterval::length_between(const double time,
                                         const double target,
                                         const double step)
  {
    return std::abs(target - time - step) < 1e-6 * step ? step : target - time;
  }

  PlannedStep DividedInterval::next() const
  {
    const double piece = whole / n_pieces;
    return {number + 1 == n_pieces ? *target : begin + piece * (number + 1),
            piece};
  }

  void DividedInterval::pass()
  {
    ++number;
    if (number == n_pieces)
      target.reset();
  }

  bool DividedInterval::divide(const unsigned int pieces)
  {
    const unsigned long ahead = static_cast<unsigned long>(number) * pieces;
    if (ahead % n_pieces != 0)
      return false;
    number   = ahead / n_pieces;
    n_pieces = pieces;
    return true;
  }


  namespace
  {
    /**
     * Relative error above which a step is repeated.
     * @tuned judgement: errors of single steps exceed their mean in an
     *   oscillation
     */
    constexpr double largest_error = 3;

    /**
     * Ratio of the desired step length to the present one, or its inverse, up
     * to which steps keep their length.
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
    constexpr double newest_weight = 0.25;

    /**
     * Step-size controller based on a moving mean of errors. Their sum counts,
     * and single ones vary in oscillations and impacts.
     */
    class ErrorControlledSteps : public StepControl
    {
    public:
      ErrorControlledSteps(const double       step,
                           const double       smallest,
                           const unsigned int order)
        : step(step)
        , smallest(smallest)
        , order(order)
        , desired_length(step)
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
        mean += newest_weight * (relative_error - mean);
        const double factor =
          std::pow(std::max(mean, least_error) / step_safety_factor,
                   -1. / order);
        const bool keeps_length =
          factor > 1 / least_change && factor < least_change;
        desired_length = piece() * (keeps_length ? 1 : factor);
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
        desired_length = piece() * std::min(0.5, factor);
        mean           = std::max(mean, relative_error);
        divide();
        return true;
      }

      double shortest() const override
      {
        return smallest;
      }

      void serialize(CheckpointArchive &archive) override
      {
        archive.values("step-size controller", desired_length, mean, dt);
      }

    private:
      /**
       * Lower bound of errors, so that a step is at most about three times as
       * long as the previous one.
       */
      static constexpr double least_error = 0.01;

      double piece() const
      {
        return interval.length() / interval.pieces();
      }

      bool may_be_shorter() const
      {
        return piece() / 2 >= smallest;
      }

      /** Number of pieces, of the form 2^k or 3 2^k. */
      unsigned int pieces_of(const double length) const
      {
        unsigned int pieces = 1;
        while (length / pieces > (1 + input_precision) * desired_length)
          pieces = more_pieces(pieces);
        while (pieces > 1 && length / pieces < smallest)
          pieces = fewer_pieces(pieces);
        return pieces;
      }

      /**
       * Divides the rest of the interval into pieces of the desired length, or
       * of the nearest one that fits here.
       */
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
      double             desired_length; ///< desired length of steps (s)
      /** Mean relative error at the present length. */
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

  namespace
  {
    class HalvedSteps : public StepControl
    {
    public:
      HalvedSteps(const double step, const double smallest)
        : step(step)
        , smallest(smallest)
      {}

      PlannedStep plan(const double time, const double target) override
      {
        if (!interval.leads_to(target))
          interval.start(time, target, step, /*pieces=*/1);
        return interval.next();
      }

      void accepted(const double /*relative_error*/) override
      {
        interval.pass();
        const unsigned int pieces = interval.pieces();
        if (interval.is_open() && pieces > 1)
          interval.divide(pieces / 2);
      }

      bool may_be_accepted(const double /*relative_error*/) const override
      {
        return true;
      }

      bool rejected(const double /*relative_error*/) override
      {
        const unsigned int pieces = 2 * interval.pieces();
        return interval.length() / pieces >= smallest &&
          interval.divide(pieces);
      }

      double shortest() const override
      {
        return smallest;
      }

    private:
      const double    step, smallest;
      DividedInterval interval;
    };
  } // namespace

  std::unique_ptr<StepControl> make_halved_steps(const double step,
                                                 const double smallest)
  {
    return std::make_unique<HalvedSteps>(step, smallest);
  }
} // namespace auxfem
