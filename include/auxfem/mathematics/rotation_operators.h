#ifndef auxfem_mathematics_rotation_operators_h
#define auxfem_mathematics_rotation_operators_h

#include <auxfem/mathematics/rotation.h>

#include <array>
#include <cmath>

/**
 * @file
 * Derivatives of exp(p) and of its inverse by the rotation vector p, with
 * t = |p|:
 * @code
 * d exp(p) = exp(p) [T dp]x = [T^T dp]x exp(p)
 * T        = I - a [p]x + b [p]x [p]x,     a = (1 - cos t) / t^2
 *                                          b = (t - sin t) / t^3
 * T^-1     = I + [p]x / 2 + c [p]x [p]x,   c = (1 - t / 2 cot(t / 2)) / t^2
 * @endcode
 * (Bruels & Cardona 2010, Journal of Computational and Nonlinear Dynamics 5,
 * 031002, and Ibrahimbegovic et al. 1995). A prime at a coefficient is its
 * derivative by t, divided by t.
 */
namespace auxfem
{
  /** v w^T. */
  template <class Number>
  inline TensorOf<Number> dyad(const VectorOf<Number> &v,
                               const VectorOf<Number> &w)
  {
    return dealii::outer_product(v, w);
  }

  /** @p matrix plus @p value times the identity. */
  template <class Number>
  inline TensorOf<Number> plus_identity(TensorOf<Number> matrix,
                                        const Number    &value)
  {
    for (int i = 0; i < 3; ++i)
      matrix[i][i] += value;
    return matrix;
  }

  /** sum terms[k] x^k. */
  template <class Number, std::size_t n>
  inline Number power_series(const std::array<double, n> &terms,
                             const Number                &x)
  {
    Number sum = 0;
    for (std::size_t k = n; k-- > 0;)
      sum = terms[k] + x * sum;
    return sum;
  }

  /** Coefficients a and b of T. */
  template <class Number>
  struct TangentCoefficientsOf
  {
    Number a, b;   ///< as in T
    Number square; ///< t^2

    /** Values are not set. */
    TangentCoefficientsOf() = default;

    explicit TangentCoefficientsOf(const VectorOf<Number> &p)
      : a(power_series(a_series, Number(p * p)))
      , b(power_series(b_series, Number(p * p)))
      , square(p * p)
    {
      using std::cos, std::sin, std::sqrt;
      const auto large = is_large();
      if (any_of(large))
        {
          const Number t  = sqrt(square);
          where(large, a) = (1 - cos(t)) / square;
          where(large, b) = (1 - sin(t) / t) / square;
        }
    }

  protected:
    /**
     * Whether the angle is too large for the series; below, the quotients would
     * cancel.
     */
    auto is_large() const
    {
      return square >= 0.25;
    }

    static constexpr std::array<double, 7> a_series = {{1. / 2,
                                                        -1. / 24,
                                                        1. / 720,
                                                        -1. / 40320,
                                                        1. / 3628800,
                                                        -1. / 479001600,
                                                        1. / 87178291200.}};
    static constexpr std::array<double, 7> b_series = {{1. / 6,
                                                        -1. / 120,
                                                        1. / 5040,
                                                        -1. / 362880,
                                                        1. / 39916800,
                                                        -1. / 6227020800.,
                                                        1. / 1307674368000.}};
  };
  using TangentCoefficients = TangentCoefficientsOf<double>;

  /** Coefficients a, b and their derivatives. */
  template <class Number>
  struct RotationCoefficientsOf : public TangentCoefficientsOf<Number>
  {
    Number da, db;   ///< a', b'
    Number dda, ddb; ///< a'', b''

    /** Values are not set. */
    RotationCoefficientsOf() = default;

    explicit RotationCoefficientsOf(const VectorOf<Number> &p)
      : TangentCoefficientsOf<Number>(p)
    {
      from_series();
      const auto large = this->is_large();
      if (any_of(large))
        from_quotients(large);
    }

  private:
    void from_series()
    {
      // The derivative of x^k, x = t^2, by t and over t is 2 k x^(k - 1).
      std::array<double, 6> da_series, db_series;
      std::array<double, 5> dda_series, ddb_series;
      for (int k = 0; k < 6; ++k)
        {
          da_series[k] = 2 * (k + 1) * this->a_series[k + 1];
          db_series[k] = 2 * (k + 1) * this->b_series[k + 1];
        }
      for (int k = 0; k < 5; ++k)
        {
          dda_series[k] = 2 * (k + 1) * da_series[k + 1];
          ddb_series[k] = 2 * (k + 1) * db_series[k + 1];
        }
      da  = power_series(da_series, this->square);
      db  = power_series(db_series, this->square);
      dda = power_series(dda_series, this->square);
      ddb = power_series(ddb_series, this->square);
    }

    template <class Condition>
    void from_quotients(const Condition &large)
    {
      using std::cos, std::sin, std::sqrt;
      const Number square = this->square, t = sqrt(square), sine = sin(t) / t,
                   cosine = cos(t);
      where(large, da)    = (sine - 2 * this->a) / square;
      where(large, db)    = (this->a - 3 * this->b) / square;
      where(large, dda)   = ((cosine - sine) / square - 4 * da) / square;
      where(large, ddb)   = (da - 5 * db) / square;
    }
  };
  using RotationCoefficients = RotationCoefficientsOf<double>;

  /** The operator T. */
  template <class Number>
  inline TensorOf<Number>
  tangent_operator(const TangentCoefficientsOf<Number> &c,
                   const VectorOf<Number>              &p)
  {
    return plus_identity(c.b * dyad(p, p) - c.a * cross_product_tensor(p),
                         1 - c.b * c.square);
  }

  /** T @p q. */
  template <class Number>
  inline VectorOf<Number>
  tangent_product(const TangentCoefficientsOf<Number> &c,
                  const VectorOf<Number>              &p,
                  const VectorOf<Number>              &q)
  {
    return (1 - c.b * c.square) * q + (c.b * (p * q)) * p -
      c.a * dealii::cross_product_3d(p, q);
  }

  /** p x (p x v) = p (p . v) - t^2 v. */
  template <class Number>
  inline VectorOf<Number>
  double_cross_product(const RotationCoefficientsOf<Number> &c,
                       const VectorOf<Number>               &p,
                       const VectorOf<Number>               &v)
  {
    return (p * v) * p - c.square * v;
  }

  /** Derivative of T^T v by p. */
  template <class Number>
  inline TensorOf<Number>
  left_tangent_derivative(const RotationCoefficientsOf<Number> &c,
                          const VectorOf<Number>               &p,
                          const VectorOf<Number>               &v)
  {
    return plus_identity(-c.a * cross_product_tensor(v) +
                           dyad(c.da * dealii::cross_product_3d(p, v) +
                                  c.db * double_cross_product(c, p, v),
                                p) +
                           c.b * (dyad(p, v) - 2. * dyad(v, p)),
                         c.b * (p * v));
  }

  /** @p m times tangent_derivative(). */
  template <class Number>
  inline VectorOf<Number>
  times_tangent_derivative(const VectorOf<Number>               &m,
                           const RotationCoefficientsOf<Number> &c,
                           const VectorOf<Number>               &p,
                           const VectorOf<Number>               &q)
  {
    using dealii::cross_product_3d;
    const Number along_p = c.db * (m * double_cross_product(c, p, q)) -
      c.da * (m * cross_product_3d(p, q)) - 2 * c.b * (m * q);
    return c.a * cross_product_3d(m, q) + along_p * p +
      c.b * ((m * p) * q + (p * q) * m);
  }

  /** Derivative of T q by p. */
  template <class Number>
  inline TensorOf<Number>
  tangent_derivative(const RotationCoefficientsOf<Number> &c,
                     const VectorOf<Number>               &p,
                     const VectorOf<Number>               &q)
  {
    return plus_identity(c.a * cross_product_tensor(q) +
                           dyad(c.db * double_cross_product(c, p, q) -
                                  c.da * dealii::cross_product_3d(p, q),
                                p) +
                           c.b * (dyad(p, q) - 2. * dyad(q, p)),
                         c.b * (p * q));
  }

  /** tangent_derivative() times @p v. */
  template <class Number>
  inline VectorOf<Number>
  tangent_derivative_product(const RotationCoefficientsOf<Number> &c,
                             const VectorOf<Number>               &p,
                             const VectorOf<Number>               &q,
                             const VectorOf<Number>               &v)
  {
    using dealii::cross_product_3d;
    return c.a * cross_product_3d(q, v) +
      (p * v) *
      (c.db * double_cross_product(c, p, q) - c.da * cross_product_3d(p, q)) +
      c.b * ((q * v) * p - 2. * (p * v) * q + (p * q) * v);
  }

  /** Second derivative of m . T q by p; symmetric. */
  template <class Number>
  inline TensorOf<Number>
  tangent_second_derivative(const RotationCoefficientsOf<Number> &c,
                            const VectorOf<Number>               &p,
                            const VectorOf<Number>               &q,
                            const VectorOf<Number>               &m)
  {
    const VectorOf<Number> across  = dealii::cross_product_3d(q, m);
    const Number           linear  = p * across;
    const Number           squared = (p * m) * (p * q) - c.square * (m * q);
    const VectorOf<Number> slope  = (p * q) * m + (p * m) * q - 2 * (m * q) * p;
    const VectorOf<Number> with_p = c.db * slope - c.da * across;
    return plus_identity(dyad(with_p, p) + dyad(p, with_p) +
                           (c.ddb * squared - c.dda * linear) * dyad(p, p) +
                           c.b * (dyad(m, q) + dyad(q, m)),
                         c.db * squared - c.da * linear - 2 * c.b * (m * q));
  }

  /** Coefficient c of T^-1 and its derivative c'. */
  template <class Number>
  struct InverseRotationCoefficientsOf
  {
    Number c, dc;
    Number square; ///< t^2

    explicit InverseRotationCoefficientsOf(const VectorOf<Number> &p)
      : square(p * p)
    {
      using std::cos, std::sin, std::sqrt;
      constexpr std::array<double, 7> c_series = {{1. / 12,
                                                   1. / 720,
                                                   1. / 30240,
                                                   1. / 1209600,
                                                   1. / 47900160,
                                                   691. / 1307674368000.,
                                                   1. / 74724249600.}};
      std::array<double, 6>           dc_series;
      for (int k = 0; k < 6; ++k)
        dc_series[k] = 2 * (k + 1) * c_series[k + 1];
      c                = power_series(c_series, square);
      dc               = power_series(dc_series, square);
      const auto large = square >= 0.25;
      if (any_of(large))
        {
          const Number t = sqrt(square), sine = sin(t / 2),
                       cotangent = cos(t / 2) / sine;
          where(large, c)        = (1 - t / 2 * cotangent) / square;
          where(large, dc) =
            (-2 / square + cotangent / (2 * t) + 1 / (4 * sine * sine)) /
            square;
        }
    }
  };
  using InverseRotationCoefficients = InverseRotationCoefficientsOf<double>;

  /** T^-1; its transpose is T(-p)^-1. */
  template <class Number>
  inline TensorOf<Number>
  inverse_tangent_operator(const InverseRotationCoefficientsOf<Number> &c,
                           const VectorOf<Number>                      &p)
  {
    return plus_identity(c.c * dyad(p, p) + 0.5 * cross_product_tensor(p),
                         1 - c.c * c.square);
  }

  /** Derivative of T^-1 g by p. */
  template <class Number>
  inline TensorOf<Number>
  inverse_tangent_derivative(const InverseRotationCoefficientsOf<Number> &c,
                             const VectorOf<Number>                      &p,
                             const VectorOf<Number>                      &g)
  {
    return plus_identity(-0.5 * cross_product_tensor(g) +
                           c.c * (dyad(p, g) - 2. * dyad(g, p)) +
                           dyad(c.dc * ((p * g) * p - c.square * g), p),
                         c.c * (p * g));
  }
} // namespace auxfem

#endif
