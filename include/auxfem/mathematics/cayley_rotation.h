#ifndef auxfem_mathematics_cayley_rotation_h
#define auxfem_mathematics_cayley_rotation_h

#include <auxfem/mathematics/rotation_operators.h>

#include <cmath>

/**
 * @file
 * Rotation increments as Cayley's transform measures them. In the plane a
 * rotation by the angle a takes a vector r_0 to r_1 such that
 * @code
 * r_1 - r_0 = 2 tan(a/2) J (r_0 + r_1) / 2
 * @endcode
 * with J the rotation by a right angle. So the vector product with the mean
 * position, which is what a virtual rotation makes, gives finite increments
 * exactly if the rotation is measured by 2 tan(a/2), and by nothing else. In
 * space the measure is a vector c of this length along the axis,
 * r_1 - r_0 = c x (r_0 + r_1) / 2.
 */
namespace auxfem
{
  /** 2 tan(a/2) of a rotation by the angle a = @p angle (rad), |a| < pi. */
  inline double cayley_rotation(const double angle)
  {
    return 2 * std::tan(angle / 2);
  }

  /** @name Functions of half the rotation increment of a step, which is small. */
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
  inline Number cosine_of_small(const Number &x)
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
   * a / (2 tan(a/2)): a moment times this does on 2 tan(a/2) the work that the
   * moment does on the angle a = @p angle (rad).
   */
  inline double angle_per_cayley_rotation(const double angle)
  {
    return angle == 0 ? 1. : angle / cayley_rotation(angle);
  }

  /** c of a rotation by less than half a turn. */
  template <class Number>
  inline VectorOf<Number> cayley_rotation(const QuaternionOf<Number> &rotation)
  {
    return 2 / rotation.scalar * rotation.vector;
  }

  /** c of a rotation vector shorter than pi. */
  template <class Number>
  inline VectorOf<Number>
  cayley_rotation(const VectorOf<Number> &rotation_vector)
  {
    return cayley_rotation(exponential(rotation_vector));
  }

  /** The mean of @p v and what the rotation with @p c makes of it:
   * (I - [c]x / 2)^-1 v. */
  template <class Number>
  inline VectorOf<Number> mean_over_rotation(const VectorOf<Number> &c,
                                             const VectorOf<Number> &v)
  {
    const VectorOf<Number> half = 0.5 * c;
    return 1 / (1 + half.norm_square()) *
      (v + dealii::cross_product_3d(half, v) + (half * v) * half);
  }

  /**
   * The derivative of @p c by a spin theta that follows it in axes that turn
   * along, C <- C exp(theta): I + [c]x / 2 + c c^T / 4. In fixed axes, of
   * exp(theta) C, it is that of -c.
   */
  template <class Number>
  inline TensorOf<Number> cayley_change_by_spin(const VectorOf<Number> &c)
  {
    return plus_identity(0.5 * cross_product_tensor(c) + 0.25 * dyad(c, c),
                         Number(1));
  }
} // namespace auxfem

#endif
