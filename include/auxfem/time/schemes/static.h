#ifndef auxfem_time_schemes_static_h
#define auxfem_time_schemes_static_h

#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * Weights (1/s) of the increments of this step and of the one before in the
   * velocity at the end of a step without inertia,
   *
   *   v_{n+1} = now (u_{n+1} - u_n) - before (u_n - u_{n-1}):
   *
   * the derivative of the parabola through the three (BDF2, e.g. Hairer &
   * Wanner 1996, section V.1, of second order for steps of any lengths); of the
   * line through two where none came before, in the first step after an event.
   */
  struct BackwardDifference
  {
    double now, before;

    /** Of a step of length @p dt (s) that begins with @p from. */
    BackwardDifference(const State &from, double dt);
  };

  /**
   * Equilibrium without inertia at every step. Where viscosity needs a velocity
   * it is the BackwardDifference.
   */
  class QuasiStatic : public ImplicitScheme
  {
  public:
    QuasiStatic();

    void predict(const State &from, double dt, State &to) const override;
    TangentFactors factors(const State &from, double dt) const override;
    void           correct(const State  &from,
                           const Vector &increment,
                           double        dt,
                           State        &trial) const override;

    bool is_dynamic() const override
    {
      return false;
    }
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

    TangentFactors factors(const State & /*from*/,
                           const double /*dt*/) const override
    {
      return {1., 0., 0.};
    }

    void correct(const State  &from,
                 const Vector &increment,
                 double        dt,
                 State        &trial) const override;

    bool is_dynamic() const override
    {
      return false;
    }
  };
} // namespace auxfem

#endif
