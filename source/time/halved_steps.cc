#include <auxfem/time/step_control.h>

#include <cmath>
#include <optional>

namespace auxfem
{
  namespace
  {
    const std::string halved_steps_record =
      "step control: whether there is a target, target, begin, length, level, "
      "position, whether the error is small";

    class HalvedSteps : public StepControl
    {
    public:
      HalvedSteps(const double                      step,
                  const double                      smallest,
                  const std::optional<unsigned int> order_of_error)
        : step(step)
        , smallest(smallest)
        , order_of_error(order_of_error)
      {}

      PlannedStep plan(const double time, const double next_target) override
      {
        if (target != next_target)
          begin_interval(time, next_target);
        const double piece   = 1. / (1u << level);
        const bool   is_last = position + 1 == (1u << level);
        return {is_last ? *target : begin + length * piece * (position + 1),
                length * piece};
      }

      void accepted(const double relative_error) override
      {
        constexpr double safety = 0.8;
        is_small                = !order_of_error ||
          relative_error * std::pow(2., *order_of_error) < safety;
        ++position;
        if (position == (1u << level))
          target.reset();
        else if (level > 0 && position % 2 == 0 && is_small)
          {
            --level;
            position /= 2;
          }
      }

      bool may_be_shorter() const override
      {
        return length / (2u << level) >= smallest;
      }

      bool rejected(const double relative_error) override
      {
        if (!may_be_shorter())
          return false;
        halve();
        // As often as the error asks for.
        for (double error = relative_error; order_of_error && may_be_shorter();)
          {
            error /= std::pow(2., *order_of_error);
            if (error <= 1)
              break;
            halve();
          }
        return true;
      }

      double shortest() const override
      {
        return smallest;
      }

      void save(Records &records) const override
      {
        records.keep(halved_steps_record,
                     {double(target.has_value()),
                      target.value_or(0),
                      begin,
                      length,
                      double(level),
                      double(position),
                      double(is_small)});
      }

      void resume(const Records &records) override
      {
        const std::vector<double> values =
          records.values(halved_steps_record, 7);
        target.reset();
        if (values[0] != 0)
          target = values[1];
        begin    = values[2];
        length   = values[3];
        level    = values[4];
        position = values[5];
        is_small = values[6] != 0;
      }

    private:
      void halve()
      {
        ++level;
        position *= 2;
      }

      void begin_interval(const double time, const double next_target)
      {
        target = next_target;
        begin  = time;
        // Equal steps must have exactly equal lengths to share a factorization.
        length = std::abs(next_target - time - step) < 1e-6 * step
          ? step
          : next_target - time;
        // Where errors are watched, it goes on as it ended.
        if (!order_of_error)
          level = 0;
        else if (is_small && level > 0)
          --level;
        position = 0;
      }

      const double                      step, smallest;
      const std::optional<unsigned int> order_of_error;
      /** The error of the last step would have allowed one twice as long. */
      bool is_small = true;
      /** The interval from `begin` to here is covered by pieces of 1/2^level,
       * number `position` next; none: the next plan begins one. */
      std::optional<double> target;
      double                begin = 0, length = 0;
      unsigned int          level = 0, position = 0;
    };
  } // namespace

  std::unique_ptr<StepControl>
  make_halved_steps(const double                      step,
                    const double                      smallest,
                    const std::optional<unsigned int> order_of_error)
  {
    return std::make_unique<HalvedSteps>(step, smallest, order_of_error);
  }
} // namespace auxfem
