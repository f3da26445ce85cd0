#ifndef auxfem_loads_event_search_h
#define auxfem_loads_event_search_h

#include <auxfem/loads/expression_tree.h>
#include <auxfem/loads/time_event.h>

#include <vector>

namespace auxfem
{
  /**
   * What is known of a function next to a kink or jump, for telling these from
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
    double n; ///< jumps found before the search ended
  };

  /**
   * The jumps of @p expression and of its first @p derivatives derivatives, 1
   * or 2, at begin < t < end (s), sorted. Times closer than time_resolution()
   * to either end count as being there.
   *
   * Where no operation may switch, by bounds of its margin over a span of time
   * (interval arithmetic), there is neither. Spans are halved until each margin
   * has at most one root, or one extremum, in them by bounds of its
   * derivatives. Roots are found by bisection to neighbouring numbers, and kept
   * if value or derivatives differ between their sides by more than round-off.
   * Throws TooManyJumps for more than ten thousand jumps.
   */
  std::vector<TimeEvent> find_events(const ExpressionTree &expression,
                                     double                begin,
                                     double                end,
                                     unsigned int          derivatives);

  /**
   * Limits of value and derivatives of @p expression at @p t (s): those at t
   * with the branches taken on that side.
   */
  Jet<double> limit(const ExpressionTree &expression, double t, TimeSide side);

  /** Whether limits of a function from both sides differ by more than
   * round-off, as do values that are off by @p error anyway. */
  bool
  is_jump(double before, double after, const FunctionSize &size, double error);

  /** Whether slopes on both sides differ by more than round-off. */
  bool is_kink(double before, double after, const FunctionSize &size);

  /** Whether second derivatives on both sides differ by more than round-off. */
  bool is_bend(double before, double after, const FunctionSize &size);
} // namespace auxfem

#endif
