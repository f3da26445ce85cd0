#ifndef auxfem_loads_interval_h
#define auxfem_loads_interval_h

#include <boost/numeric/interval.hpp>

#include <cmath>

namespace auxfem
{
  namespace detail
  {
    namespace interval_lib = boost::numeric::interval_lib;

    /** No directed rounding: bounds are good to round-off. */
    using IntervalPolicies = interval_lib::policies<
      interval_lib::save_state_nothing<interval_lib::rounded_transc_exact<
        double,
        interval_lib::rounded_arith_exact<double>>>,
      interval_lib::checking_base<double>>;
  } // namespace detail

  /**
   * All values an expression may take while its variable runs through an
   * interval (interval arithmetic; Boost.Interval). Where an expression is
   * undefined throughout, the bounds are NaN.
   */
  using Interval = boost::numeric::interval<double, detail::IntervalPolicies>;

  /** Whether @p number may be @p x. */
  inline bool contains(const Interval &number, const double x)
  {
    return number.lower() <= x && x <= number.upper();
  }

  /** Whether @p number cannot be @p x; not known where it is undefined. */
  inline bool excludes(const Interval &number, const double x)
  {
    return x < number.lower() || number.upper() < x;
  }

  /** x^p for a fixed exponent; real powers are those of x >= 0. */
  inline Interval power(const Interval &x, const double p)
  {
    if (p < 0)
      return 1. / power(x, -p);
    if (p == std::floor(p) && p < 1e6)
      return boost::numeric::pow(x, static_cast<int>(p));
    if (!(x.upper() >= 0))
      return Interval(std::nan(""));
    return Interval(x.lower() <= 0 ? 0 : std::pow(x.lower(), p),
                    std::pow(x.upper(), p));
  }

  inline double power(const double x, const double p)
  {
    return std::pow(x, p);
  }
} // namespace auxfem

#endif
