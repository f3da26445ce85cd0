#ifndef auxfem_elements_small_angle_h
#define auxfem_elements_small_angle_h

/**
 * @file
 * Series of trigonometric functions by the square of the angle, exact to the
 * last digit up to largest_small_square. They cost a fraction of the library's
 * functions.
 */
namespace auxfem
{
  /** Up to which square of the angle (rad^2) the series may be used. */
  constexpr double largest_small_square = 0.1;

  /** sin(x) / x with x^2 = @p y. */
  template <class Number>
  inline Number sinc_series(const Number &y)
  {
    return 1 -
      y * (1. / 6) *
      (1 -
       y * (1. / 20) *
         (1 -
          y * (1. / 42) *
            (1 - y * (1. / 72) * (1 - y * (1. / 110) * (1 - y * (1. / 156))))));
  }

  /** cos(x) with x^2 = @p y. */
  template <class Number>
  inline Number cosine_series(const Number &y)
  {
    return 1 -
      y * (1. / 2) *
      (1 -
       y * (1. / 12) *
         (1 -
          y * (1. / 30) *
            (1 - y * (1. / 56) * (1 - y * (1. / 90) * (1 - y * (1. / 132))))));
  }
} // namespace auxfem

#endif
