#ifndef auxfem_time_largest_in_time_h
#define auxfem_time_largest_in_time_h

#include <auxfem/algebra/unknown_layout.h>

#include <cmath>

namespace auxfem
{
  /** The largest value so far, zero at least, and when it was met (s). */
  struct LargestInTime
  {
    void add(const double candidate, const double now)
    {
      // What is no number stays.
      if (value >= candidate || std::isnan(value))
        return;
      value = candidate;
      time  = now;
    }

    /** The largest of all ranks; @p layout knows them. Collective. */
    LargestInTime of_all_ranks(const UnknownLayout &layout) const
    {
      const double largest = layout.largest(value);
      return {largest, layout.largest(largest == value ? time : 0.)};
    }

    double value = 0, time = 0;
  };
} // namespace auxfem

#endif
