#ifndef auxfem_mathematics_rotation_h
#define auxfem_mathematics_rotation_h

#include <auxfem/mathematics/lanes.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <optional>

/**
 * @file
 * Series of trigonometric functions in the square of the angle, accurate to
 * round-off up to largest_small_square and cheaper than the library's
 * functions.
 */
namespace auxfem
{
  /** Largest square of the angle (rad^2) for the series. */
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

  /** Sine and cosine of @p x (rad), by series for small angles. */
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

/**
 * @file
 * Rotations in space as unit quaternions. The beam kernel differentiates twice
 * by the four numbers of a quaternion and therefore needs a plain struct;
 * Boost's quaternions lack logarithm, rotation of vectors or vector algebra.
 */
namespace auxfem
{
  /**
   * Components along x, y, z. @p Number is double, or Lanes for a batch of
   * elements.
   */
  template <class Number>
  using VectorOf    = dealii::Tensor<1, 3, Number>;
  using SpaceVector = VectorOf<double>;

  /** Square matrix; a frame has its axes as columns. */
  template <class Number>
  using TensorOf    = dealii::Tensor<2, 3, Number>;
  using SpaceTensor = TensorOf<double>;

  /**
   * A quaternion. With unit norm, (cos(a/2), sin(a/2) n) and its negative are
   * the rotation by the angle a about the unit vector n.
   */
  template <class Number>
  struct QuaternionOf
  {
    Number           scalar = 1;
    VectorOf<Number> vector;

    friend QuaternionOf operator+(const QuaternionOf &p, const QuaternionOf &q)
    {
      return {p.scalar + q.scalar, p.vector + q.vector};
    }

    friend QuaternionOf operator*(const Number &factor, const QuaternionOf &q)
    {
      return {factor * q.scalar, factor * q.vector};
    }

    /** Hamilton's product; for rotations, @p q acts first, then @p p. */
    friend QuaternionOf operator*(const QuaternionOf &p, const QuaternionOf &q)
    {
      return {p.scalar * q.scalar - p.vector * q.vector,
              p.scalar * q.vector + q.scalar * p.vector +
                dealii::cross_product_3d(p.vector, q.vector)};
    }
  };
  using Quaternion = QuaternionOf<double>;

  /** Conjugate; the inverse of a rotation. */
  template <class Number>
  inline QuaternionOf<Number> conjugate(const QuaternionOf<Number> &q)
  {
    return {q.scalar, -q.vector};
  }

  /** Scalar product of the four numbers. */
  template <class Number>
  inline Number dot(const QuaternionOf<Number> &p,
                    const QuaternionOf<Number> &q)
  {
    return p.scalar * q.scalar + p.vector * q.vector;
  }

  /** @p q scaled to unit norm; it must not be zero. */
  template <class Number>
  inline QuaternionOf<Number> normalized(const QuaternionOf<Number> &q)
  {
    using std::sqrt;
    return 1 / sqrt(dot(q, q)) * q;
  }

  /**
   * The rotation by |@p rotation_vector| (rad, any size) about its direction:
   * R = exp([rotation_vector]x).
   */
  template <class Number>
  inline QuaternionOf<Number>
  exponential(const VectorOf<Number> &rotation_vector)
  {
    using std::cos, std::sin, std::sqrt;
    const Number square = rotation_vector.norm_square() / 4;
    Number       cosine = cosine_series(square), sinc = sinc_series(square);
    const auto   large = square >= largest_small_square;
    if (any_of(large))
      {
        const Number half_angle = sqrt(square);
        where(large, cosine)    = cos(half_angle);
        where(large, sinc)      = sin(half_angle) / half_angle;
      }
    return {cosine, sinc / 2 * rotation_vector};
  }

  /**
   * The inverse of exponential(): angle (rad, at most pi) times axis. Accurate
   * to round-off for all angles; at pi itself one of the two axes.
   */
  template <class Number>
  inline VectorOf<Number> rotation_vector(const QuaternionOf<Number> &rotation)
  {
    using std::atan2, std::sqrt;
    Number sign                      = 1;
    where(rotation.scalar < 0, sign) = -1;
    // Square of the sine of half the angle.
    const Number y = rotation.vector.norm_square();
    // Relative rotations in an element are small: the series of asin(x) / x
    // then is accurate to round-off and much cheaper.
    Number half_angle_per_sine = 1 +
      y * (1. / 6) *
        (1 +
         y * (9. / 20) *
           (1 +
            y * (25. / 42) *
              (1 +
               y * (49. / 72) *
                 (1 +
                  y * (81. / 110) *
                    (1 + y * (121. / 156) * (1 + y * (169. / 210)))))));
    const auto large = y >= 0.01;
    if (any_of(large))
      {
        const Number sine = sqrt(y);
        where(large, half_angle_per_sine) =
          atan2(sine, Number(sign * rotation.scalar)) / sine;
      }
    return sign * 2 * half_angle_per_sine * rotation.vector;
  }

  /** R @p v - @p v, without the cancellation of the difference. */
  template <class Number>
  inline VectorOf<Number> rotation_change(const QuaternionOf<Number> &rotation,
                                          const VectorOf<Number>     &v)
  {
    const VectorOf<Number> twice =
      2. * dealii::cross_product_3d(rotation.vector, v);
    return rotation.scalar * twice +
      dealii::cross_product_3d(rotation.vector, twice);
  }

  /** R @p v. */
  template <class Number>
  inline VectorOf<Number> rotated(const QuaternionOf<Number> &rotation,
                                  const VectorOf<Number>     &v)
  {
    return v + rotation_change(rotation, v);
  }

  /** R @p matrix: rotates the columns, e.g. the axes of a frame. */
  template <class Number>
  inline TensorOf<Number> rotated(const QuaternionOf<Number> &rotation,
                                  const TensorOf<Number>     &matrix)
  {
    TensorOf<Number> result;
    for (int j = 0; j < 3; ++j)
      {
        const VectorOf<Number> column =
          rotated(rotation,
                  VectorOf<Number>({matrix[0][j], matrix[1][j], matrix[2][j]}));
        for (int i = 0; i < 3; ++i)
          result[i][j] = column[i];
      }
    return result;
  }

  /** [v]x, the matrix with [v]x w = v x w. */
  template <class Number>
  inline TensorOf<Number> cross_product_tensor(const VectorOf<Number> &v)
  {
    TensorOf<Number> result;
    for (int i = 0; i < 3; ++i)
      {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        result[j][i] = v[k];
        result[i][j] = -v[k];
      }
    return result;
  }

  /** The symmetric tensor with the principal @p values along the axes of @p frame. */
  template <class Number>
  inline TensorOf<Number> with_principal_values(const TensorOf<Number> &frame,
                                                const VectorOf<Number> &values)
  {
    TensorOf<Number> result;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          result[i][j] += frame[i][k] * values[k] * frame[j][k];
    return result;
  }

  /**
   * Whether two directions (or opposite ones) are within five degrees, too
   * close for section_frame().
   */
  bool nearly_parallel(const SpaceVector &a, const SpaceVector &b);

  /**
   * Default reference vector of a strut: the z axis, so that struts in the x-y
   * plane bend in it about axis 3; the x axis for struts within five degrees of
   * z.
   */
  SpaceVector default_reference(const SpaceVector &tangent);

  /**
   * Section axes of a strut, as columns: 1 along @p tangent, 3 as near as
   * possible to @p reference, 2 = 3 x 1. The vectors need no unit length;
   * reject parallel ones with nearly_parallel() before.
   */
  SpaceTensor section_frame(const SpaceVector &tangent,
                            const SpaceVector &reference);

  /** Directions of axes 2 and 3 of a section at rest. */
  struct SectionOrientation
  {
    /** Vector whose projection normal to the strut gives the drawn axis 3;
     * empty: default_reference(). */
    std::optional<SpaceVector> reference;
    /** Angle about axis 1 from the drawn axes to the principal ones (rad). */
    double principal_angle = 0;
  };

  /** As section_frame() of the reference, turned about the tangent by the
   * principal angle. */
  SpaceTensor section_frame(const SpaceVector        &tangent,
                            const SectionOrientation &orientation);

  /**
   * Material angular velocity W (rad/s), P' = P [W]x, and angular acceleration
   * W' (rad/s2).
   */
  struct AngularMotion
  {
    SpaceVector velocity, acceleration;
  };

  /**
   * T(Theta)^-1, which maps a material spin to the change of the rotation
   * vector: d exp(Theta) = exp(Theta) [T dTheta]x. Singular at |Theta| = 2 pi.
   */
  SpaceTensor inverse_tangent_operator(const SpaceVector &rotation_vector);

  /**
   * Angular motion of P = exp(phi(t)): W = T phi', W' = T phi'' + T' phi'.
   * @param rotation_vector phi (rad)
   * @param first, second phi' (rad/s), phi'' (rad/s2)
   */
  AngularMotion angular_motion(const SpaceVector &rotation_vector,
                               const SpaceVector &first,
                               const SpaceVector &second);

  /**
   * Rotation vector of @p rotation nearest to @p guess (rad), among those of
   * any number of turns.
   */
  SpaceVector rotation_vector_near(const Quaternion  &rotation,
                                   const SpaceVector &guess);
} // namespace auxfem

#endif
