#include <auxfem/time/step_control.h>
#include <auxfem/time/time_parameters.h>

namespace auxfem
{
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
} // namespace auxfem
