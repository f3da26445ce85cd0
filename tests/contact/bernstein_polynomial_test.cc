#include <auxfem/contact/axis_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;

namespace
{
  /** Product of (x - root), in Bernstein coefficients. */
  BernsteinPolynomial with_roots(const std::vector<double> &roots)
  {
    BernsteinPolynomial result;
    result.coefficients[0] = 1;
    for (const double root : roots)
      {
        // (x - root) has the coefficients -root and 1 - root.
        const unsigned int  n = result.degree;
        BernsteinPolynomial raised;
        raised.degree = n + 1;
        for (unsigned int i = 0; i <= n + 1; ++i)
          raised.coefficients[i] =
            ((i <= n ? (n + 1. - i) * -root * result.coefficients[i] : 0.) +
             (i > 0 ? i * (1 - root) * result.coefficients[i - 1] : 0.)) /
            (n + 1);
        result = raised;
      }
    return result;
  }

  std::vector<double> sign_changes(const BernsteinPolynomial &polynomial)
  {
    std::vector<double> found;
    polynomial.add_sign_changes(found);
    std::sort(found.begin(), found.end());
    return found;
  }
} // namespace

TEST(BernsteinPolynomial, ValuesAreThoseOfTheProduct)
{
  const BernsteinPolynomial polynomial = with_roots({0.2, 0.7, 1.5, -0.3, 0.4});
  for (const double x : {0., 0.1, 0.5, 0.77, 1.})
    {
      const double exact =
        (x - 0.2) * (x - 0.7) * (x - 1.5) * (x + 0.3) * (x - 0.4);
      EXPECT_NEAR(polynomial.at(x), exact, 1e-15);
      const auto halves = polynomial.halves();
      EXPECT_NEAR(halves[x < 0.5 ? 0 : 1].at(x < 0.5 ? 2 * x : 2 * x - 1),
                  exact,
                  1e-15);
    }
}

TEST(BernsteinPolynomial, EverySignChangeIsFound)
{
  for (const std::vector<double> &roots : {std::vector<double>{0.5},
                                           {0.25, 0.5, 0.75},
                                           {0.3, 0.300001},
                                           {0.1, 0.2, 0.5, 0.50001, 0.9, 0.99}})
    {
      std::vector<double> all = roots;
      // None of these roots lies inside.
      for (const double outside : {-0.2, 1.3, 2.})
        all.push_back(outside);
      const std::vector<double> found = sign_changes(with_roots(all));
      ASSERT_EQ(found.size(), roots.size());
      for (std::size_t i = 0; i < roots.size(); ++i)
        // Two roots this close lose half of the digits.
        EXPECT_NEAR(found[i], roots[i], 1e-9);
    }
}

TEST(BernsteinPolynomial, PolynomialsOfOneSignHaveNoSignChange)
{
  BernsteinPolynomial zero;
  zero.degree = 5;
  zero.coefficients.fill(0);
  EXPECT_TRUE(sign_changes(zero).empty());
  EXPECT_TRUE(zero.is_nowhere_negative());
  EXPECT_TRUE(zero.is_nowhere_positive());
  EXPECT_TRUE(sign_changes(with_roots({-0.1, 1.1})).empty());
}

TEST(ControlPolygon, RepresentsTheCurveAndItsSquare)
{
  AxisCurve curve;
  curve.degree       = 3;
  curve.coefficients = {{AxisCurve::Vector({0.1, 0, 0}),
                         AxisCurve::Vector({1, 0.5, 0}),
                         AxisCurve::Vector({0, -2, 0.3}),
                         AxisCurve::Vector({0.2, 1, 0})}};
  for (const unsigned int degree : {3u, 5u})
    {
      const ControlPolygon polygon(curve, degree);
      EXPECT_LT((polygon.points[0] - curve.at(0)).norm(), 1e-15);
      EXPECT_LT((polygon.points[degree] - curve.at(1)).norm(), 1e-15);
      for (const double x : {0.2, 0.6})
        EXPECT_NEAR(product(polygon, polygon).at(x),
                    curve.at(x).norm_square(),
                    1e-15);
    }
}
