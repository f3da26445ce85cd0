#ifndef auxfem_loads_event_search_h
#define auxfem_loads_event_search_h

#include <auxfem/loads/one_sided_limit.h>

#include <vector>

namespace auxfem
{
  /** Magnitudes of a function near a time, to distinguish kinks and jumps from
   * round-off. */
  struct FunctionSize
  {
    double value     = 0; ///< greatest absolute value
    double slope     = 0; ///< greatest absolute first derivative
    double curvature = 0; ///< greatest absolute second derivative
  };

  /** Thrown if a function jumps so often that steps cannot end at each jump. */
  struct TooManyJumps
  {
    double n; ///< estimate of the number of jumps
  };

  /**
   * The jumps of @p function and of its first @p derivatives derivatives, 1 or
   * 2, at begin < t < end (s), sorted. Times closer than time_resolution() to
   * either end count as being there.
   *
   * The search samples the branches at about a thousand times, or more if they
   * change often, and bisects each change to neighbouring numbers. It misses
   * branches between two samples, and kinks of functions without branches.
   * Throws TooManyJumps for more than ten thousand jumps.
   */
  std::vector<TimeEvent> find_events(const BranchedFunction &function,
                                     double                  begin,
                                     double                  end,
                                     unsigned int            derivatives);

  /** @name Whether both one-sided limits differ by more than round-off and
   * @p error */
  ///@{
  /** Limits of the value. */
  bool
  is_jump(double before, double after, const FunctionSize &size, double error);

  /** Limits of the first derivative. */
  bool
  is_kink(double before, double after, const FunctionSize &size, double error);

  /** Limits of the second derivative. */
  bool
  is_bend(double before, double after, const FunctionSize &size, double error);
  ///@}
} // namespace auxfem

#endif
