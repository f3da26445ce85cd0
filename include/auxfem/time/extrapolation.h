#ifndef auxfem_time_extrapolation_h
#define auxfem_time_extrapolation_h

#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * How to guess a smooth function of time from its values at some @p times (s,
   * in any order): the number of each value taken with its weight. A parabola
   * through those three values that are nearest to @p time, but whose errors it
   * does not enlarge much; less where there are fewer.
   */
  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, double time);
} // namespace auxfem

#endif
