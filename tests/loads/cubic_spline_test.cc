#include <auxfem/loads/table_history.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

namespace
{
  CubicSpline sampled_sine(const unsigned int n)
  {
    std::vector<double> x, y;
    for (unsigned int i = 0; i <= n; ++i)
      {
        // Uneven spacing that is equally smooth for any number of points.
        const double s = double(i) / n;
        x.push_back(3 * s * (1 + s) / 2);
        y.push_back(std::sin(2 * x.back() + 0.3));
      }
    return {x, y};
  }

  /** Largest errors of value and derivatives of sampled_sine(n). */
  Jet errors(const unsigned int n)
  {
    const CubicSpline spline = sampled_sine(n);
    Jet               largest;
    for (unsigned int i = 0; i <= 3000; ++i)
      {
        const double x = i * 1e-3, phase = 2 * x + 0.3;
        const Jet    jet  = spline(x);
        const auto   take = [](double &result, const double error) {
          result = std::max(result, std::abs(error));
        };
        take(largest.value, jet.value - std::sin(phase));
        take(largest.first, jet.first - 2 * std::cos(phase));
        take(largest.second, jet.second + 4 * std::sin(phase));
      }
    return largest;
  }
} // namespace

TEST(CubicSpline, CubicsAreExact)
{
  const auto        cubic = [](const double x) { return x * x * (x - 2) + 3; };
  const CubicSpline spline(
    {-1, 0, 0.3, 2, 2.5},
    {cubic(-1), cubic(0), cubic(0.3), cubic(2), cubic(2.5)});
  for (const double x : {-1., -0.4, 0., 0.1, 0.3, 1.7, 2.2, 2.5})
    {
      const Jet jet = spline(x);
      EXPECT_NEAR(jet.value, cubic(x), 1e-14);
      EXPECT_NEAR(jet.first, 3 * x * x - 4 * x, 1e-13);
      EXPECT_NEAR(jet.second, 6 * x - 4, 1e-13);
    }
}

TEST(CubicSpline, OrdersUpToTheEnds)
{
  const Jet coarse = errors(160), fine = errors(320);
  EXPECT_NEAR(std::log2(coarse.value / fine.value), 4, 0.3);
  EXPECT_NEAR(std::log2(coarse.first / fine.first), 3, 0.3);
  EXPECT_NEAR(std::log2(coarse.second / fine.second), 2, 0.3);
}

TEST(CubicSpline, SecondDerivativesAreContinuous)
{
  const CubicSpline spline({0, 1, 1.5, 3, 4}, {0, 1, -1, 2, 2});
  for (const double x : {1., 1.5, 3.})
    {
      const Jet before = spline(x - 1e-9), after = spline(x);
      EXPECT_NEAR(before.value, after.value, 1e-7);
      EXPECT_NEAR(before.first, after.first, 1e-7);
      EXPECT_NEAR(before.second, after.second, 1e-7);
    }
}

TEST(CubicSpline, FewPoints)
{
  EXPECT_EQ(CubicSpline({2}, {7})(5).value, 7);
  const Jet line = CubicSpline({2, 4}, {7, 8})(3);
  EXPECT_EQ(line.value, 7.5);
  EXPECT_EQ(line.first, 0.5);
  EXPECT_EQ(line.second, 0);
  const CubicSpline parabola({0, 1, 3}, {0, 1, 9});
  for (const double x : {0., 0.5, 2., 3.})
    {
      EXPECT_NEAR(parabola(x).value, x * x, 1e-14);
      EXPECT_NEAR(parabola(x).first, 2 * x, 1e-14);
      EXPECT_NEAR(parabola(x).second, 2, 1e-13);
    }
}
