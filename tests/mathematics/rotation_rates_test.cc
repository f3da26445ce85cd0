#include <auxfem/mathematics/rotation.h>
#include <auxfem/mathematics/rotation_operators.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  const SpaceVector axis({2. / 7, -3. / 7, 6. / 7});
  const SpaceVector v({0.3, 1.1, -0.7}), w({-0.5, 0.2, 0.9});

  /** Angles on both sides of the limits of the series, and far beyond. */
  const std::vector<double> angles =
    {0, 1e-9, 0.05, 0.2, 0.4999, 0.5001, 1.3, 3., 5.5};

  /** Central difference of @p f along @p direction. */
  template <class Function>
  SpaceVector difference(const Function    &f,
                         const SpaceVector &p,
                         const SpaceVector &direction)
  {
    const double step = 1e-5;
    return (f(p + step * direction) - f(p - step * direction)) / (2 * step);
  }

  // Truncation: step^2 times third derivatives of about one; and round-off over
  // the step.
  constexpr double tolerance = 2e-9;
} // namespace

TEST(RotationRates, TangentOperatorIsTheDerivativeOfTheExponential)
{
  for (const double angle : angles)
    {
      const SpaceVector p    = angle * axis;
      const SpaceVector spin = tangent_operator(RotationCoefficients(p), p) * v;
      const double      step = 1e-5;
      const SpaceVector turned =
        rotation_vector(conjugate(exponential(p - step * v)) *
                        exponential(p + step * v)) /
        (2 * step);
      EXPECT_LT((turned - spin).norm(), tolerance) << "angle " << angle;
    }
}

TEST(RotationRates, InverseOperatorIsTheInverse)
{
  for (const double angle : angles)
    {
      const SpaceVector p = angle * axis;
      EXPECT_LT((inverse_tangent_operator(p) *
                   (tangent_operator(RotationCoefficients(p), p) * v) -
                 v)
                  .norm(),
                // 1 / (2 pi - angle) grows towards a whole turn.
                2e-14)
        << "angle " << angle;
    }
}

TEST(RotationRates, DerivativesOfTheOperatorsAgreeWithDifferences)
{
  for (const double angle : angles)
    {
      SCOPED_TRACE("angle " + std::to_string(angle));
      const SpaceVector          p = angle * axis;
      const RotationCoefficients c(p);
      const auto                 T = [](const SpaceVector &at) {
        return tangent_operator(RotationCoefficients(at), at);
      };
      EXPECT_LT(
        (tangent_derivative(c, p, v) * w -
         difference([&](const SpaceVector &at) { return T(at) * v; }, p, w))
          .norm(),
        tolerance);
      EXPECT_LT(
        (left_tangent_derivative(c, p, v) * w -
         difference([&](const SpaceVector &at) { return v * T(at); }, p, w))
          .norm(),
        tolerance);
      const SpaceVector m({0.8, -0.4, 0.6});
      EXPECT_LT((times_tangent_derivative(m, c, p, v) -
                 m * tangent_derivative(c, p, v))
                  .norm(),
                1e-14 * (1 + angle));
      EXPECT_LT((tangent_second_derivative(c, p, v, m) * w -
                 difference(
                   [&](const SpaceVector &at) {
                     return m *
                       tangent_derivative(RotationCoefficients(at), at, v);
                   },
                   p,
                   w))
                  .norm(),
                tolerance);
      EXPECT_LT(
        (inverse_tangent_derivative(InverseRotationCoefficients(p), p, v) * w -
         difference(
           [&](const SpaceVector &at) {
             return inverse_tangent_operator(at) * v;
           },
           p,
           w))
          .norm(),
        // The derivative grows towards a whole turn.
        angle < 4 ? tolerance : 1e-7);
    }
}

TEST(RotationRates, AngularMotionAgreesWithDifferences)
{
  const auto phi = [](const double t) {
    return SpaceVector({0.4 + t, 0.3 * t * t - 1, 0.9 * t});
  };
  const double        h = 1e-4;
  const AngularMotion motion =
    angular_motion(phi(0), SpaceVector({1, 0, 0.9}), SpaceVector({0, 0.6, 0}));
  const auto between = [&](const double from, const double to) {
    return rotation_vector(conjugate(exponential(phi(from))) *
                           exponential(phi(to)));
  };
  EXPECT_LT((between(-h, h) / (2 * h) - motion.velocity).norm(), 1e-7);
  EXPECT_LT(
    ((between(0, h) - between(-h, 0)) / (h * h) - motion.acceleration).norm(),
    1e-6);
}

TEST(RotationRates, RotationAboutAFixedAxisHasTheRatesOfItsAngle)
{
  const AngularMotion motion =
    angular_motion(7.3 * axis, 2.5 * axis, -1.5 * axis);
  EXPECT_LT((motion.velocity - 2.5 * axis).norm(), 1e-14);
  EXPECT_LT((motion.acceleration + 1.5 * axis).norm(), 1e-14);
}

TEST(RotationRates, RotationVectorIsTheNearestToTheGuess)
{
  for (const double angle : {0.3, 3., 3.3, 9., -20., 2 * 3.14159265358979324})
    EXPECT_LT((rotation_vector_near(exponential(angle * axis),
                                    (angle + 0.2) * axis) -
               angle * axis)
                .norm(),
              1e-13)
      << "angle " << angle;
}
