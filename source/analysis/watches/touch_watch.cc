#include <auxfem/analysis/touch_watch.h>

namespace auxfem
{
  void TouchWatch::step(const Evaluation &step,
                        const EvaluationResults & /*results*/,
                        TangentSolver & /*solver*/)
  {
    if (first)
      return;
    if (const auto struts = lookout->first_to_touch(step.from, step.to))
      first = FirstTouch{*struts, step.to.time};
  }
} // namespace auxfem
