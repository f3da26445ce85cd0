#ifndef auxfem_time_quasi_static_h
#define auxfem_time_quasi_static_h

#include <auxfem/time/time_integrator.h>

namespace auxfem
{
  /**
   * Equilibrium without inertia. Where viscosity needs a velocity it is the
   * backward difference (u_{n+1} - u_n) / dt (first order); with dt = infinity
   * it is zero: the state all viscous processes tend to.
   */
  class QuasiStatic : public TimeIntegrator
  {
  public:
    void           predict(const Step &step) const override;
    TangentFactors factors(double dt) const override;
    void
    correct(const Vector &increment, double dt, State &trial) const override;
    bool is_dynamic() const override;
  };
} // namespace auxfem

#endif
