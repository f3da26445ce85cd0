#include <auxfem/contact/plate_definition.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace auxfem;

namespace
{
  constexpr ContactLaw law = {7., 0.2};

  // Gap, parabola, transition, line.
  const std::vector<double> depths = {-1, -1e-9, 0, 1e-9, 0.05, 0.2, 0.3, 2};
} // namespace

TEST(ContactLaw, HasTheValuesOfItsPieces)
{
  EXPECT_EQ(law.force(-0.1), 0);
  EXPECT_EQ(law.slope(-0.1), 0);
  EXPECT_EQ(law.energy(-0.1), 0);
  EXPECT_DOUBLE_EQ(law.force(0.1), 7 * 0.01 / 0.4);
  EXPECT_DOUBLE_EQ(law.slope(0.1), 3.5);
  EXPECT_DOUBLE_EQ(law.energy(0.1), 7 * 0.001 / 1.2);
  EXPECT_DOUBLE_EQ(law.force(1), 7 * 0.9);
  EXPECT_DOUBLE_EQ(law.slope(1), 7);
  // The parabola, then the trapezoid below the line.
  EXPECT_DOUBLE_EQ(law.energy(1),
                   7 * 0.008 / 1.2 + (7 * 0.1 + 7 * 0.9) / 2 * 0.8);
}

TEST(ContactLaw, IsTheDerivativeOfItsEnergy)
{
  const double h = 1e-6;
  for (const double depth : depths)
    {
      // Error from the jump k / s of the third derivative.
      EXPECT_NEAR((law.energy(depth + h) - law.energy(depth - h)) / (2 * h),
                  law.force(depth),
                  1e-9);
      EXPECT_NEAR((law.force(depth + h) - law.force(depth - h)) / (2 * h),
                  law.slope(depth),
                  35 * h);
    }
}

TEST(ContactLaw, MeanForceDoesTheWork)
{
  for (const double from : depths)
    for (const double to : depths)
      EXPECT_NEAR(law.mean_force(from, to) * (to - from),
                  law.energy(to) - law.energy(from),
                  1e-15 * (1 + law.energy(std::max(from, to))))
        << from << " to " << to;
}

TEST(ContactLaw, MeanForceIsExactInShortSteps)
{
  // Divided differences of the energy would lose all digits.
  for (const double depth : {0.1, 0.2, 1.})
    for (const double way : {1e-9, 1e-12, 1e-15, 0.})
      EXPECT_NEAR(law.mean_force(depth, depth + way),
                  law.force(depth + way / 2),
                  1e-14 + 35 * way * way);
}

TEST(ContactLaw, MeanSlopeIsTheDerivativeOfTheMeanForce)
{
  const double h = 1e-5;
  for (const double from : depths)
    for (const double to : depths)
      EXPECT_NEAR(
        (law.mean_force(from, to + h) - law.mean_force(from, to - h)) / (2 * h),
        law.mean_slope(from, to),
        35 * h)
        << from << " to " << to;
}
