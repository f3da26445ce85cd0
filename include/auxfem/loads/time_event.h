#ifndef auxfem_loads_time_event_h
#define auxfem_loads_time_event_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  /** Value, first and second derivative of a function of time. */
  struct Jet
  {
    double value  = 0;
    double first  = 0;
    double second = 0;
  };

  /** A time at which a function of time or a derivative of it jumps. */
  struct TimeEvent
  {
    enum class Kind
    {
      bend, ///< value and first derivative are continuous, the second is not
      kink, ///< the value is continuous, its first derivative is not
      jump  ///< the value jumps
    };

    double time; ///< s
    Kind   kind;
  };

  /** Side of a time from which a limit is taken. */
  enum class TimeSide
  {
    before,
    after
  };

  /** A time (s) and the side from which it is approached. */
  struct TimeLimit
  {
    double   time;
    TimeSide side;
  };

  /**
   * Distance (s) below which times around @p t are one, 1e-12 of t or of 1 s:
   * some thousand units of round-off, because the operands of expressions like
   * (0.01 * t - 3) carry less digits than the time.
   */
  inline double time_resolution(const double t)
  {
    return 4096 * std::numeric_limits<double>::epsilon() *
      std::max(std::abs(t), 1.);
  }
} // namespace auxfem

#endif
