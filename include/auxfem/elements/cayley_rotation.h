#ifndef auxfem_elements_cayley_rotation_h
#define auxfem_elements_cayley_rotation_h

#include <auxfem/elements/rotation_operators.h>

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
  inline double sinc(const double x)
  {
    const double y = x * x;
    return y > largest_small_square ? std::sin(x) / x : sinc_series(y);
  }

  /** cos(x). */
  inline double cosine_of_small(const double x)
  {
    const double y = x * x;
    return y > largest_small_square ? std::cos(x) : cosine_series(y);
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
  inline SpaceVector cayley_rotation(const Quaternion &rotation)
  {
    return 2 / rotation.scalar * rotation.vector;
  }

  /** c of a rotation vector shorter than pi. */
  inline SpaceVector cayley_rotation(const SpaceVector &rotation_vector)
  {
    return cayley_rotation(exponential(rotation_vector));
  }

  /** The mean of @p v and what the rotation with @p c makes of it:
   * (I - [c]x / 2)^-1 v. */
  inline SpaceVector mean_over_rotation(const SpaceVector &c,
                                        const SpaceVector &v)
  {
    const SpaceVector half = c / 2;
    return (v + dealii::cross_product_3d(half, v) + (half * v) * half) /
      (1 + half.norm_square());
  }

  /**
   * The derivative of @p c by a spin theta that follows it in axes that turn
   * along, C <- C exp(theta): I + [c]x / 2 + c c^T / 4. In fixed axes, of
   * exp(theta) C, it is that of -c.
   */
  inline SpaceTensor cayley_change_by_spin(const SpaceVector &c)
  {
    return plus_identity(0.5 * cross_product_tensor(c) + 0.25 * dyad(c, c), 1.);
  }
} // namespace auxfem

#endif
