#ifndef auxfem_elements_rotation_h
#define auxfem_elements_rotation_h

#include <auxfem/elements/small_angle.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <optional>

/**
 * @file
 * Rotations in space as unit quaternions. The algebra needed is short, and the
 * beam kernel differentiates it twice by the four numbers of a quaternion: a
 * plain struct shows these, while Boost's quaternions lack logarithm, rotation
 * of vectors (Boost.Math) or vector algebra (QVM).
 */
namespace auxfem
{
  /** Components along x, y, z. */
  using SpaceVector = dealii::Tensor<1, 3>;

  /** Square matrix; as a frame of axes it has them as columns. */
  using SpaceTensor = dealii::Tensor<2, 3>;

  /**
   * A quaternion; with unit norm, the rotation by the angle a about the unit
   * vector n is (cos(a/2), sin(a/2) n), as is its negative.
   */
  struct Quaternion
  {
    double      scalar = 1;
    SpaceVector vector;
  };

  inline Quaternion operator+(const Quaternion &p, const Quaternion &q)
  {
    return {p.scalar + q.scalar, p.vector + q.vector};
  }

  inline Quaternion operator*(const double factor, const Quaternion &q)
  {
    return {factor * q.scalar, factor * q.vector};
  }

  /** Hamilton's product; of rotations, first @p q, then @p p. */
  inline Quaternion operator*(const Quaternion &p, const Quaternion &q)
  {
    return {p.scalar * q.scalar - p.vector * q.vector,
            p.scalar * q.vector + q.scalar * p.vector +
              dealii::cross_product_3d(p.vector, q.vector)};
  }

  /** Of a rotation, its inverse. */
  inline Quaternion conjugate(const Quaternion &q)
  {
    return {q.scalar, -q.vector};
  }

  /** Scalar product of the four numbers. */
  inline double dot(const Quaternion &p, const Quaternion &q)
  {
    return p.scalar * q.scalar + p.vector * q.vector;
  }

  /** @p q with unit norm; it must not be zero. */
  inline Quaternion normalized(const Quaternion &q)
  {
    return 1 / std::sqrt(dot(q, q)) * q;
  }

  /**
   * The rotation by |@p rotation_vector| (rad, any size) about its direction:
   * R = exp([rotation_vector]x).
   */
  inline Quaternion exponential(const SpaceVector &rotation_vector)
  {
    const double square = rotation_vector.norm_square() / 4;
    if (square < largest_small_square)
      return {cosine_series(square), sinc_series(square) / 2 * rotation_vector};
    const double half_angle = std::sqrt(square);
    return {std::cos(half_angle),
            std::sin(half_angle) / half_angle / 2 * rotation_vector};
  }

  /**
   * The inverse of exponential(): angle (rad, at most pi) times axis. Accurate
   * to round-off for all angles; at pi itself one of the two axes.
   */
  inline SpaceVector rotation_vector(const Quaternion &rotation)
  {
    const double sign = rotation.scalar < 0 ? -1 : 1;
    const double y    = rotation.vector.norm_square(); // sine of half the angle
    // Relative rotations in an element are small; there the series of
    // 2 asin(x) / x is exact to the last digit, and the library's function
    // slow.
    if (y < 0.01)
      return sign * 2 *
        (1 +
         y * (1. / 6) *
           (1 +
            y * (9. / 20) *
              (1 +
               y * (25. / 42) *
                 (1 +
                  y * (49. / 72) *
                    (1 +
                     y * (81. / 110) *
                       (1 + y * (121. / 156) * (1 + y * (169. / 210)))))))) *
        rotation.vector;
    const double sine       = std::sqrt(y);
    const double half_angle = std::atan2(sine, sign * rotation.scalar);
    return sign * 2 * half_angle / sine * rotation.vector;
  }

  /** R @p v - @p v, without the cancellation of the difference. */
  inline SpaceVector rotation_change(const Quaternion  &rotation,
                                     const SpaceVector &v)
  {
    const SpaceVector twice = 2. * dealii::cross_product_3d(rotation.vector, v);
    return rotation.scalar * twice +
      dealii::cross_product_3d(rotation.vector, twice);
  }

  /** R @p v. */
  inline SpaceVector rotated(const Quaternion &rotation, const SpaceVector &v)
  {
    return v + rotation_change(rotation, v);
  }

  /** R @p matrix: its columns, such as the axes of a frame, rotated. */
  inline SpaceTensor rotated(const Quaternion  &rotation,
                             const SpaceTensor &matrix)
  {
    SpaceTensor result;
    for (int j = 0; j < 3; ++j)
      {
        const SpaceVector column =
          rotated(rotation,
                  SpaceVector({matrix[0][j], matrix[1][j], matrix[2][j]}));
        for (int i = 0; i < 3; ++i)
          result[i][j] = column[i];
      }
    return result;
  }

  /** [v]x, the matrix with [v]x w = v x w. */
  SpaceTensor cross_product_tensor(const SpaceVector &v);

  /** The symmetric tensor with the principal @p values along the axes of @p frame. */
  SpaceTensor with_principal_values(const SpaceTensor &frame,
                                    const SpaceVector &values);

  /**
   * Whether two directions (or opposite ones) are within five degrees, too
   * close for section_frame().
   */
  bool nearly_parallel(const SpaceVector &a, const SpaceVector &b);

  /**
   * The reference vector of a strut that was given none: the z axis, so that
   * struts in the x-y plane bend in it about axis 3; for struts within five
   * degrees of z the x axis.
   */
  SpaceVector default_reference(const SpaceVector &tangent);

  /**
   * Section axes of a strut, as columns: 1 along @p tangent, 3 as near to
   * @p reference as can be, 2 = 3 x 1. Neither vector needs unit length; they
   * must not be parallel (nearly_parallel() is what to refuse).
   */
  SpaceTensor section_frame(const SpaceVector &tangent,
                            const SpaceVector &reference);

  /** The same; without a @p reference with default_reference(). */
  SpaceTensor section_frame(const SpaceVector                &tangent,
                            const std::optional<SpaceVector> &reference);
} // namespace auxfem

#endif
