#ifndef auxfem_elements_small_angle_h
#define auxfem_elements_small_angle_h

#include <auxfem/elements/branches.h>

#include <cmath>

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

  template <class Number>
  struct SineAndCosine
  {
    Number sine, cosine;
  };

  /** Of @p x (rad), by series where it is small. */
  template <class Number>
  inline SineAndCosine<Number> sine_and_cosine(const Number &x)
  {
    using std::cos, std::sin;
    const Number          y      = x * x;
    SineAndCosine<Number> result = {x * sinc_series(y), cosine_series(y)};
    const auto            large  = y >= largest_small_square;
    if (any_of(large))
      {
        where(large, result.sine)   = sin(x);
        where(large, result.cosine) = cos(x);
      }
    return result;
  }
} // namespace auxfem

#endif
