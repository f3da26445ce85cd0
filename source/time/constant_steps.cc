#include <auxfem/time/step_control.h>

#include <cmath>
#include <optional>

namespace auxfem
{
  namespace
  {
    const std::string constant_steps_record =
      "step control: begin, length, target, level and position";

    class ConstantSteps : public StepControl
    {
    public:
      ConstantSteps(const double step, const double smallest)
        : step(step)
        , smallest(smallest)
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

      void accepted() override
      {
        ++position;
        if (position == (1u << level))
          target.reset();
        else if (level > 0 && position % 2 == 0)
          {
            --level;
            position /= 2;
          }
      }

      bool rejected() override
      {
        if (length / (2u << level) < smallest)
          return false;
        ++level;
        position *= 2;
        return true;
      }

      double shortest() const override
      {
        return smallest;
      }

      void save(Records &records) const override
      {
        if (target)
          records.keep(
            constant_steps_record,
            {begin, length, *target, double(level), double(position)});
        else
          records.keep(constant_steps_record, /*items=*/{}, 5, {});
      }

      void resume(const Records &records) override
      {
        target.reset();
        if (records.items(constant_steps_record).empty())
          return;
        const std::vector<double> values =
          records.values(constant_steps_record, 5);
        begin    = values[0];
        length   = values[1];
        target   = values[2];
        level    = values[3];
        position = values[4];
      }

    private:
      void begin_interval(const double time, const double next_target)
      {
        target = next_target;
        begin  = time;
        // Equal steps must have exactly equal lengths to share a factorization.
        length = std::abs(next_target - time - step) < 1e-6 * step
          ? step
          : next_target - time;
        level = position = 0;
      }

      const double step, smallest;
      /** The interval from `begin` to here is covered by pieces of 1/2^level,
       * number `position` next; none: the next plan begins one. */
      std::optional<double> target;
      double                begin = 0, length = 0;
      unsigned int          level = 0, position = 0;
    };
  } // namespace

  std::unique_ptr<StepControl> make_constant_steps(const double step,
                                                   const double smallest)
  {
    return std::make_unique<ConstantSteps>(step, smallest);
  }
} // namespace auxfem
