#include <auxfem/contact/axis_curve.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace auxfem;

namespace
{
  using Point = AxisCurve::Vector;

  class RandomCurves
  {
  public:
    double number(const double size)
    {
      return std::uniform_real_distribution<double>(-size, size)(generator);
    }

    Point point(const double size)
    {
      return Point({number(size), number(size), number(size)});
    }

    AxisCurve curve(const unsigned int degree)
    {
      AxisCurve curve;
      curve.degree = degree;
      for (unsigned int k = 0; k <= degree; ++k)
        curve.coefficients[k] = point(k == 1 ? 1. : 0.5);
      return curve;
    }

  private:
    std::mt19937 generator;
  };
} // namespace

TEST(AxisCurve, DerivativesAreThoseOfThePosition)
{
  RandomCurves random;
  for (unsigned int degree = 1; degree <= 6; ++degree)
    {
      const AxisCurve  curve = random.curve(degree);
      constexpr double h = 1e-5, at = 0.37;
      EXPECT_LT((curve.tangent(at) -
                 (curve.at(at + h) - curve.at(at - h)) / (2 * h))
                  .norm(),
                1e-8);
      EXPECT_LT((curve.bend(at) -
                 (curve.tangent(at + h) - curve.tangent(at - h)) / (2 * h))
                  .norm(),
                1e-7);
    }
}

TEST(AxisCurve, NoPointOfTheRangeIsNearer)
{
  RandomCurves random;
  for (unsigned int i = 0; i < 400; ++i)
    {
      const AxisCurve curve = random.curve(1 + i % 4);
      const Point     point = random.point(1);
      const double    begin = i % 3 == 0 ? 0.2 : 0., end = i % 5 == 0 ? 0.7 : 1;
      const NearestPoint found = nearest_point(curve, point, begin, end);
      EXPECT_GE(found.parameter, begin);
      EXPECT_LE(found.parameter, end);
      EXPECT_NEAR((curve.at(found.parameter) - point).norm(),
                  found.distance,
                  1e-14);
      if (found.is_inside)
        {
          const double slope = (curve.at(found.parameter) - point) *
            curve.tangent(found.parameter);
          EXPECT_NEAR(slope, 0, 1e-12);
        }
      double least = found.distance;
      for (unsigned int k = 0; k <= 1000; ++k)
        least = std::min(
          least,
          (curve.at(begin + (end - begin) * k / 1000.) - point).norm());
      EXPECT_NEAR(least, found.distance, 1e-5);
    }
}
