#include <auxfem/time/divided_interval.h>

#include <cmath>

namespace auxfem
{
  void DividedInterval::start(const double       time,
                              const double       next_target,
                              const double       step,
                              const unsigned int pieces)
  {
    target           = next_target;
    begin            = time;
    whole            = length_between(time, next_target, step);
    number_of_pieces = pieces;
    number           = 0;
  }

  double DividedInterval::length_between(const double time,
                                         const double target,
                                         const double step)
  {
    return std::abs(target - time - step) < 1e-6 * step ? step : target - time;
  }

  PlannedStep DividedInterval::next() const
  {
    const double piece = whole / number_of_pieces;
    return {number + 1 == number_of_pieces ? *target
                                           : begin + piece * (number + 1),
            piece};
  }

  void DividedInterval::pass()
  {
    ++number;
    if (number == number_of_pieces)
      target.reset();
  }

  bool DividedInterval::divide(const unsigned int pieces)
  {
    const unsigned long ahead = static_cast<unsigned long>(number) * pieces;
    if (ahead % number_of_pieces != 0)
      return false;
    number           = ahead / number_of_pieces;
    number_of_pieces = pieces;
    return true;
  }

} // namespace auxfem
