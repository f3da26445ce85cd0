#include <auxfem/time/quasi_static.h>

namespace auxfem
{
  void QuasiStatic::predict(const Step &step) const
  {
    step.to.displacement = step.from.displacement;
    if (step.to.velocity)
      step.to.velocity->PutScalar(0.);
    if (step.to.acceleration)
      step.to.acceleration->PutScalar(0.);
  }

  TangentFactors QuasiStatic::factors(const double dt) const
  {
    return {1., 1 / dt, 0.};
  }

  void QuasiStatic::correct(const Vector &increment,
                            const double  dt,
                            State        &trial) const
  {
    trial.displacement.Update(1., increment, 1.);
    if (trial.velocity)
      trial.velocity->Update(1 / dt, increment, 1.);
  }

  bool QuasiStatic::is_dynamic() const
  {
    return false;
  }
} // namespace auxfem
