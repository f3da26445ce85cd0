#ifndef auxfem_time_schemes_static_h
#define auxfem_time_schemes_static_h

#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * Weights (1/s) of the last two increments in the velocity at the end of a
   * step without inertia,
   *
   *     v_{n+1} = now (u_{n+1} - u_n) - before (u_n - u_{n-1}).
   *
   * This is BDF2 with variable steps (Hairer & Wanner 1996, section V.1); the
   * first step after an event uses backward Euler.
   */
  struct BackwardDifference
  {
    double now, before;

    /** Weights in a step of length @p dt (s) that begins with @p from. */
    BackwardDifference(const State &from, double dt);
  };

  /**
   * Equilibrium without inertia at every step. Viscous forces use the velocity
   * of BackwardDifference.
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
   * Search for the state that all viscous processes tend to: only
   * displacements change, and all velocities are zero. No member uses dt.
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
