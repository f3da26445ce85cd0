#ifndef auxfem_loads_one_sided_limit_h
#define auxfem_loads_one_sided_limit_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/expression.h>

#include <functional>

namespace auxfem
{
  /** A function of time (s) with the branches that its formula takes. */
  using BranchedFunction = std::function<Expression::BranchedValue(double)>;

  /**
   * Limit of @p function at @p t (s) from one side: the value at the nearest
   * time with the branches of that side, and the value at t where both agree to
   * round-off.
   */
  double limit(const BranchedFunction &function, double t, TimeSide side);

  /** Limits of value and derivatives, with bounds for what they are off. */
  struct JetEstimate
  {
    Jet    jet;
    double first_error  = 0;
    double second_error = 0;
  };

  /**
   * Limits of @p function and its derivatives at @p t (s) from one side, by
   * differences of seven values on that side. Their interval is doubled from
   * time_resolution() on as long as the estimates approach each other; it ends
   * where other branches begin. First derivatives are good to about 1e-12 of
   * their size, second ones to 1e-9; both are infinite where differences grow
   * without bound. If another branch begins nearby on that side, but not at t,
   * the other side may serve.
   */
  JetEstimate
  jet_estimate(const BranchedFunction &function, double t, TimeSide side);
} // namespace auxfem

#endif
