#ifndef auxfem_loads_event_search_h
#define auxfem_loads_event_search_h

#include <auxfem/loads/one_sided_limit.h>

#include <vector>

namespace auxfem
{
  /**
   * Magnitudes of a function next to a kink or jump, which tell these from
   * round-off.
   */
  struct FunctionSize
  {
    double value     = 0; ///< greatest absolute value
    double slope     = 0; ///< greatest absolute first derivative
    double curvature = 0; ///< greatest absolute second derivative
  };

  /** A function jumps so often that steps cannot end at each jump. */
  struct TooManyJumps
  {
    double n; ///< estimate of the number of jumps
  };

  /**
   * The jumps of @p function and of its first @p derivatives derivatives, 1 or
   * 2, at begin < t < end (s), sorted. Times closer than time_resolution() to
   * either end count as being there.
   *
   * The search compares the branches at about a thousand times, at more if the
   * branches change often, and bisects each change to neighbouring numbers. It
   * misses branches that begin and end between two of these times, and kinks of
   * functions without branches. Throws TooManyJumps for more than ten thousand
   * jumps.
   */
  std::vector<TimeEvent> find_events(const BranchedFunction &function,
                                     double                  begin,
                                     double                  end,
                                     unsigned int            derivatives);

  /** Whether limits of a function from both sides differ by more than
   * round-off and @p error. */
  bool
  is_jump(double before, double after, const FunctionSize &size, double error);

  /** Whether slopes on both sides differ by more than that. */
  bool
  is_kink(double before, double after, const FunctionSize &size, double error);

  /** Whether second derivatives on both sides differ by more than that. */
  bool
  is_bend(double before, double after, const FunctionSize &size, double error);
} // namespace auxfem

#endif
