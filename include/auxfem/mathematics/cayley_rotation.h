#ifndef auxfem_mathematics_cayley_rotation_h
#define auxfem_mathematics_cayley_rotation_h

#include <auxfem/mathematics/rotation_operators.h>

#include <cmath>

/**
 * @file
 * Rotation increments in Cayley's parametrization. In the plane, a rotation by
 * the angle a takes a vector r_0 to r_1 with
 * @code
 * r_1 - r_0 = 2 tan(a/2) J (r_0 + r_1) / 2
 * @endcode
 * where J rotates by a right angle. A virtual rotation, which acts on the mean
 * position, gives finite increments exactly if and only if the rotation is
 * measured by 2 tan(a/2). In space the measure is a vector c of this length
 * along the axis, r_1 - r_0 = c x (r_0 + r_1) / 2.
 */
namespace auxfem
{
  /** 2 tan(a/2) of a rotation by the angle a = @p angle (rad), |a| < pi. */
  inline double cayley_rotation(const double angle)
  {
    return 2 * std::tan(angle / 2);
  }

  /**
   * @name Functions of half the rotation increment of a step, a small angle.
   */
  ///@{
  /** sin(x) / x. */
  template <class Number>
  inline Number sinc(const Number &x)
  {
    using std::sin;
    const Number y      = x * x;
    Number       result = sinc_series(y);
    const auto   large  = y > largest_small_square;
    if (any_of(large))
      where(large, result) = sin(x) / x;
    return result;
  }

  /** cos(x). */
  template <class Number>
  inline Number small_angle_cosine(const Number &x)
  {
    using std::cos;
    const Number y      = x * x;
    Number       result = cosine_series(y);
    const auto   large  = y > largest_small_square;
    if (any_of(large))
      where(large, result) = cos(x);
    return result;
  }
  ///@}

  /**
   * a / (2 tan(a/2)) for the angle a = @p angle (rad): converts a moment
   * conjugate to a into one conjugate to 2 tan(a/2).
   */
  inline double angle_per_cayley_rotation(const double angle)
  {
    return angle == 0 ? 1. : angle / cayley_rotation(angle);
  }

  /** Vector c of a rotation by less than half a turn. */
  template <class Number>
  inline VectorOf<Number> cayley_rotation(const QuaternionOf<Number> &rotation)
  {
    return 2 / rotation.scalar * rotation.vector;
  }

  /** Vector c of a rotation vector shorter than pi. */
  template <class Number>
  inline VectorOf<Number>
  cayley_rotation(const VectorOf<Number> &rotation_vector)
  {
    return cayley_rotation(exponential(rotation_vector));
  }

  /**
   * Mean of @p v and its image under the rotation with @p c: (I - [c]x / 2)^-1
   * v.
   */
  template <class Number>
  inline VectorOf<Number> mean_over_rotation(const VectorOf<Number> &c,
                                             const VectorOf<Number> &v)
  {
    const VectorOf<Number> half = 0.5 * c;
    return 1 / (1 + half.norm_square()) *
      (v + dealii::cross_product_3d(half, v) + (half * v) * half);
  }

  /**
   * Derivative of @p c by a material spin theta, C <- C exp(theta): I + [c]x /
   * 2 + c c^T / 4. For a spatial spin, C <- exp(theta) C, take it at -c.
   */
  template <class Number>
  inline TensorOf<Number> cayley_spin_derivative(const VectorOf<Number> &c)
  {
    return plus_identity(0.5 * cross_product_tensor(c) + 0.25 * dyad(c, c),
                         Number(1));
  }
} // namespace auxfem

#endif
