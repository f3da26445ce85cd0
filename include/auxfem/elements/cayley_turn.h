#ifndef auxfem_elements_cayley_turn_h
#define auxfem_elements_cayley_turn_h

#include <cmath>

/**
 * @file
 * Turns in the plane over a step as Cayley's transform measures them. A turn by
 * the angle a takes a vector r_0 to r_1 such that
 * @code
 * r_1 - r_0 = 2 tan(a/2) J (r_0 + r_1) / 2
 * @endcode
 * with J the turn by a right angle. So the vector product with the mean
 * position, which is what a virtual rotation makes, gives finite increments
 * exactly if the rotation is measured by 2 tan(a/2), and by nothing else.
 */
namespace auxfem
{
  /** 2 tan(a/2) of a turn by the angle a = @p angle (rad), |a| < pi. */
  inline double cayley_turn(const double angle)
  {
    return 2 * std::tan(angle / 2);
  }

  /** The angle (rad) of the turn whose Cayley measure is @p turn. */
  inline double angle_of_cayley_turn(const double turn)
  {
    return 2 * std::atan(turn / 2);
  }

  /** sin(x) / x. */
  inline double sinc(const double x)
  {
    // Turns of neighbours are nearly equal: their differences are small, where
    // six terms of the series are exact to the last digit and cost a fraction.
    const double y = x * x;
    if (y < 0.1)
      return 1 -
        y / 6 *
        (1 -
         y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110 * (1 - y / 156)))));
    return std::sin(x) / x;
  }

  /**
   * a / (2 tan(a/2)): a moment times this does on 2 tan(a/2) the work that the
   * moment does on the angle a = @p angle (rad).
   */
  inline double angle_per_cayley_turn(const double angle)
  {
    return angle == 0 ? 1. : angle / cayley_turn(angle);
  }
} // namespace auxfem

#endif
