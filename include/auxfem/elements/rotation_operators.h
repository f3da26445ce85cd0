#ifndef auxfem_elements_rotation_operators_h
#define auxfem_elements_rotation_operators_h

#include <auxfem/elements/rotation.h>

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
  inline SpaceTensor dyad(const SpaceVector &v, const SpaceVector &w)
  {
    return dealii::outer_product(v, w);
  }

  /** @p matrix plus @p value times the identity. */
  inline SpaceTensor plus_identity(SpaceTensor matrix, const double value)
  {
    for (int i = 0; i < 3; ++i)
      matrix[i][i] += value;
    return matrix;
  }

  /** sum terms[k] x^k. */
  template <std::size_t n>
  inline double power_series(const std::array<double, n> &terms, const double x)
  {
    double sum = 0;
    for (std::size_t k = n; k-- > 0;)
      sum = terms[k] + x * sum;
    return sum;
  }

  /** a and b. */
  struct TangentCoefficients
  {
    double a, b;   ///< as in T
    double square; ///< t^2

    /** Values are not set. */
    TangentCoefficients() = default;

    explicit TangentCoefficients(const SpaceVector &p) : square(p * p)
    {
      if (square < small_square)
        {
          a = power_series(series_of_a, square);
          b = power_series(series_of_b, square);
        }
      else
        {
          const double t = std::sqrt(square);
          a              = (1 - std::cos(t)) / square;
          b              = (1 - std::sin(t) / t) / square;
        }
    }

  protected:
    /** Below, quotients would cancel. */
    static constexpr double small_square = 0.25;

    static constexpr std::array<double, 7> series_of_a = {{1. / 2,
                                                           -1. / 24,
                                                           1. / 720,
                                                           -1. / 40320,
                                                           1. / 3628800,
                                                           -1. / 479001600,
                                                           1. / 87178291200.}};
    static constexpr std::array<double, 7> series_of_b = {
      {1. / 6,
       -1. / 120,
       1. / 5040,
       -1. / 362880,
       1. / 39916800,
       -1. / 6227020800.,
       1. / 1307674368000.}};
  };

  /** a, b and their derivatives. */
  struct RotationCoefficients : public TangentCoefficients
  {
    double da, db;   ///< a', b'
    double dda, ddb; ///< a'', b''

    /** Values are not set. */
    RotationCoefficients() = default;

    explicit RotationCoefficients(const SpaceVector &p) : TangentCoefficients(p)
    {
      if (square < small_square)
        from_series();
      else
        from_quotients();
    }

  private:
    void from_series()
    {
      // The derivative of x^k, x = t^2, by t and over t is 2 k x^(k - 1).
      std::array<double, 6> of_da, of_db;
      std::array<double, 5> of_dda, of_ddb;
      for (int k = 0; k < 6; ++k)
        {
          of_da[k] = 2 * (k + 1) * series_of_a[k + 1];
          of_db[k] = 2 * (k + 1) * series_of_b[k + 1];
        }
      for (int k = 0; k < 5; ++k)
        {
          of_dda[k] = 2 * (k + 1) * of_da[k + 1];
          of_ddb[k] = 2 * (k + 1) * of_db[k + 1];
        }
      da  = power_series(of_da, square);
      db  = power_series(of_db, square);
      dda = power_series(of_dda, square);
      ddb = power_series(of_ddb, square);
    }

    void from_quotients()
    {
      const double t = std::sqrt(square), sine = std::sin(t) / t,
                   cosine = std::cos(t);
      da                  = (sine - 2 * a) / square;
      db                  = (a - 3 * b) / square;
      dda                 = ((cosine - sine) / square - 4 * da) / square;
      ddb                 = (da - 5 * db) / square;
    }
  };

  /** T. */
  inline SpaceTensor tangent_operator(const TangentCoefficients &c,
                                      const SpaceVector         &p)
  {
    return plus_identity(c.b * dyad(p, p) - c.a * cross_product_tensor(p),
                         1 - c.b * c.square);
  }

  /** T @p q. */
  inline SpaceVector tangent_product(const TangentCoefficients &c,
                                     const SpaceVector         &p,
                                     const SpaceVector         &q)
  {
    return (1 - c.b * c.square) * q + (c.b * (p * q)) * p -
      c.a * dealii::cross_product_3d(p, q);
  }

  /** p (p . v) - t^2 v. */
  inline SpaceVector across_twice(const RotationCoefficients &c,
                                  const SpaceVector          &p,
                                  const SpaceVector          &v)
  {
    return (p * v) * p - c.square * v;
  }

  /** Derivative of T^T v by p. */
  inline SpaceTensor left_tangent_derivative(const RotationCoefficients &c,
                                             const SpaceVector          &p,
                                             const SpaceVector          &v)
  {
    return plus_identity(-c.a * cross_product_tensor(v) +
                           dyad(c.da * dealii::cross_product_3d(p, v) +
                                  c.db * across_twice(c, p, v),
                                p) +
                           c.b * (dyad(p, v) - 2. * dyad(v, p)),
                         c.b * (p * v));
  }

  /** @p m times tangent_derivative(). */
  inline SpaceVector times_tangent_derivative(const SpaceVector          &m,
                                              const RotationCoefficients &c,
                                              const SpaceVector          &p,
                                              const SpaceVector          &q)
  {
    using dealii::cross_product_3d;
    const double along_p = c.db * (m * across_twice(c, p, q)) -
      c.da * (m * cross_product_3d(p, q)) - 2 * c.b * (m * q);
    return c.a * cross_product_3d(m, q) + along_p * p +
      c.b * ((m * p) * q + (p * q) * m);
  }

  /** Derivative of T q by p. */
  inline SpaceTensor tangent_derivative(const RotationCoefficients &c,
                                        const SpaceVector          &p,
                                        const SpaceVector          &q)
  {
    return plus_identity(c.a * cross_product_tensor(q) +
                           dyad(c.db * across_twice(c, p, q) -
                                  c.da * dealii::cross_product_3d(p, q),
                                p) +
                           c.b * (dyad(p, q) - 2. * dyad(q, p)),
                         c.b * (p * q));
  }

  /** tangent_derivative() times @p v. */
  inline SpaceVector tangent_derivative_product(const RotationCoefficients &c,
                                                const SpaceVector          &p,
                                                const SpaceVector          &q,
                                                const SpaceVector          &v)
  {
    using dealii::cross_product_3d;
    return c.a * cross_product_3d(q, v) +
      (p * v) * (c.db * across_twice(c, p, q) - c.da * cross_product_3d(p, q)) +
      c.b * ((q * v) * p - 2. * (p * v) * q + (p * q) * v);
  }

  /** Second derivative of m . T q by p; symmetric. */
  inline SpaceTensor tangent_second_derivative(const RotationCoefficients &c,
                                               const SpaceVector          &p,
                                               const SpaceVector          &q,
                                               const SpaceVector          &m)
  {
    const SpaceVector across  = dealii::cross_product_3d(q, m);
    const double      linear  = p * across;
    const double      squared = (p * m) * (p * q) - c.square * (m * q);
    const SpaceVector slope   = (p * q) * m + (p * m) * q - 2 * (m * q) * p;
    const SpaceVector with_p  = c.db * slope - c.da * across;
    return plus_identity(dyad(with_p, p) + dyad(p, with_p) +
                           (c.ddb * squared - c.dda * linear) * dyad(p, p) +
                           c.b * (dyad(m, q) + dyad(q, m)),
                         c.db * squared - c.da * linear - 2 * c.b * (m * q));
  }

  /** c and its derivative c'. */
  struct InverseRotationCoefficients
  {
    double c, dc;
    double square; ///< t^2

    explicit InverseRotationCoefficients(const SpaceVector &p) : square(p * p)
    {
      constexpr double small_square = 0.25;
      if (square < small_square)
        {
          constexpr std::array<double, 7> of_c = {{1. / 12,
                                                   1. / 720,
                                                   1. / 30240,
                                                   1. / 1209600,
                                                   1. / 47900160,
                                                   691. / 1307674368000.,
                                                   1. / 74724249600.}};
          std::array<double, 6>           of_dc;
          for (int k = 0; k < 6; ++k)
            of_dc[k] = 2 * (k + 1) * of_c[k + 1];
          c  = power_series(of_c, square);
          dc = power_series(of_dc, square);
        }
      else
        {
          const double t = std::sqrt(square), sine = std::sin(t / 2),
                       cotangent = std::cos(t / 2) / sine;
          c                      = (1 - t / 2 * cotangent) / square;
          dc = (-2 / square + cotangent / (2 * t) + 1 / (4 * sine * sine)) /
            square;
        }
    }
  };

  /** T^-1; its transpose is that of -p. */
  inline SpaceTensor
  inverse_tangent_operator(const InverseRotationCoefficients &c,
                           const SpaceVector                 &p)
  {
    return plus_identity(c.c * dyad(p, p) + 0.5 * cross_product_tensor(p),
                         1 - c.c * c.square);
  }

  /** Derivative of T^-1 g by p. */
  inline SpaceTensor
  inverse_tangent_derivative(const InverseRotationCoefficients &c,
                             const SpaceVector                 &p,
                             const SpaceVector                 &g)
  {
    return plus_identity(-0.5 * cross_product_tensor(g) +
                           c.c * (dyad(p, g) - 2. * dyad(g, p)) +
                           dyad(c.dc * ((p * g) * p - c.square * g), p),
                         c.c * (p * g));
  }
} // namespace auxfem

#endif
