#include <auxfem/time/divided_interval.h>
#include <auxfem/time/step_control.h>

namespace auxfem
{
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
