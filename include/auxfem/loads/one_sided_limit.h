#ifndef auxfem_loads_one_sided_limit_h
#define auxfem_loads_one_sided_limit_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/expression.h>

#include <functional>

namespace auxfem
{
  /** A function of time (s) that also returns the branches of its formula. */
  using BranchedFunction = std::function<Expression::BranchedValue(double)>;

  /**
   * Limit of @p function at @p t (s) from one side: the value at the nearest
   * time with the branches of that side, or the value at t if both agree to
   * round-off.
   */
  double limit(const BranchedFunction &function, double t, TimeSide side);

  /** Limits of value and derivatives, with error bounds. */
  struct JetEstimate
  {
    Jet    jet;
    double first_error  = 0;
    double second_error = 0;
  };

  /**
   * Limits of @p function and its derivatives at @p t (s) from one side, by
   * seven-point differences on that side. The interval grows by factors of two
   * from time_resolution() until the estimates diverge or another branch
   * begins. Relative errors are about 1e-12 for first and 1e-9 for second
   * derivatives; derivatives that grow without bound are infinite. If another
   * branch begins nearby, but not at t, values of the other side are used.
   */
  JetEstimate
  jet_estimate(const BranchedFunction &function, double t, TimeSide side);
} // namespace auxfem

#endif
