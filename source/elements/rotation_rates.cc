#include <auxfem/elements/rotation_rates.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Below this angle (rad) series replace quotients that cancel. */
    constexpr double small_angle = 0.3;

    /** (1 - cos t) / t^2 and (t - sin t) / t^3. */
    struct Coefficients
    {
      explicit Coefficients(const double t)
      {
        const double s = t * t;
        const double half_sine =
          t > 0 ? std::sin(t / 2) / (t / 2) : 1.; // over half the angle
        a = half_sine * half_sine / 2;
        b = t < small_angle
          ? 1. / 6 +
            s *
              (-1. / 120 +
               s * (1. / 5040 + s * (-1. / 362880 + s / 39916800.)))
          : (t - std::sin(t)) / (s * t);
      }
      double a, b;
    };

    SpaceTensor polynomial(const SpaceVector &v,
                           const double       linear,
                           const double       quadratic)
    {
      const SpaceTensor cross  = cross_product_tensor(v);
      SpaceTensor       result = linear * cross + quadratic * cross * cross;
      for (int i = 0; i < 3; ++i)
        result[i][i] += 1;
      return result;
    }
  } // namespace

  SpaceTensor tangent_operator(const SpaceVector &rotation_vector)
  {
    const Coefficients c(rotation_vector.norm());
    return polynomial(rotation_vector, -c.a, c.b);
  }

  SpaceTensor inverse_tangent_operator(const SpaceVector &rotation_vector)
  {
    const double t = rotation_vector.norm(), s = t * t;
    const double c = t < small_angle
      ? 1. / 12 +
        s *
          (1. / 720 + s * (1. / 30240 + s * (1. / 1209600 + s / 47900160.)))
      : (1 - t / 2 / std::tan(t / 2)) / s;
    return polynomial(rotation_vector, 0.5, c);
  }

  AngularMotion angular_motion(const SpaceVector &rotation_vector,
                               const SpaceVector &first,
                               const SpaceVector &second)
  {
    using dealii::cross_product_3d;
    const SpaceVector &phi = rotation_vector;
    const double       t = phi.norm(), s = t * t;
    const Coefficients c(t);
    // Derivatives of the coefficients by t, divided by t.
    const double da = t < small_angle
      ? -1. / 12 + s * (1. / 180 + s * (-1. / 6720 + s / 453600.))
      : (1 - s * c.b - 2 * c.a) / s;
    const double db = t < small_angle
      ? -1. / 60 + s * (1. / 1260 + s * (-1. / 60480 + s / 4989600.))
      : (c.a - 3 * c.b) / s;

    const double      stretching = phi * first;
    const SpaceVector once  = cross_product_3d(phi, first),
                      twice = cross_product_3d(phi, once);
    const SpaceTensor T     = polynomial(phi, -c.a, c.b);
    return {T * first,
            T * second - da * stretching * once + db * stretching * twice +
              c.b * cross_product_3d(first, once)};
  }

  SpaceVector rotation_vector_near(const Quaternion  &rotation,
                                   const SpaceVector &guess)
  {
    const SpaceVector principal = rotation_vector(rotation);
    const double      angle     = principal.norm();
    // The axis of a rotation by zero or whole turns is that of the guess.
    const SpaceVector axis = angle > 1e-8 ? principal / angle
      : guess.norm() > 0                  ? guess / guess.norm()
                                          : SpaceVector();
    const double      turn = 2 * dealii::numbers::PI;
    return principal +
      turn * std::round((axis * (guess - principal)) / turn) * axis;
  }
} // namespace auxfem
