#ifndef auxfem_time_static_h
#define auxfem_time_static_h

#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  /**
   * Equilibrium without inertia at every step. Where viscosity needs a velocity
   * it is the backward difference (u_{n+1} - u_n) / dt (first order).
   */
  class QuasiStatic : public ImplicitScheme
  {
  public:
    QuasiStatic();

    void predict(const State &from, double dt, State &to) const override;
    TangentFactors factors(double dt) const override;
    void           correct(const State  &from,
                           const Vector &increment,
                           double        dt,
                           State        &trial) const override;
    bool           is_dynamic() const override;
  };

  /**
   * The search for the state that all viscous processes tend to: only
   * displacements change, whatever has a velocity is at rest. There is no step,
   * so that no member looks at dt.
   */
  class Equilibrium : public ImplicitScheme
  {
  public:
    Equilibrium();

    void predict(const State &from, double dt, State &to) const override;
    TangentFactors factors(double dt) const override;
    void           correct(const State  &from,
                           const Vector &increment,
                           double        dt,
                           State        &trial) const override;
    bool           is_dynamic() const override;
  };
} // namespace auxfem

#endif
