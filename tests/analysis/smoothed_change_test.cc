#include <auxfem/analysis/smoothed_change.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

TEST(SmoothedChange, LeavesOfAnOscillationTheSquareOfTheCosineOfHalfItsAngle)
{
  for (const double angle : {0., 0.3, 1., 2., 3.})
    {
      SmoothedChange changes;
      const auto     change = [angle](const double i) {
        return Vector{std::cos(angle * i), std::sin(angle * i)};
      };
      changes.add(change(0), 1);
      EXPECT_FALSE(changes.with(change(1), 1).has_value());
      changes.add(change(1), 1);
      const std::optional<Vector> mean = changes.with(change(2), 1);
      ASSERT_TRUE(mean.has_value());
      EXPECT_NEAR(std::hypot((*mean)[0], (*mean)[1]),
                  std::pow(std::cos(angle / 2), 2),
                  1e-14);
    }
}

TEST(SmoothedChange, BeginsAnewWithStepsOfAnotherLength)
{
  SmoothedChange changes;
  for (unsigned int i = 0; i < 3; ++i)
    changes.add({1.}, 1);
  EXPECT_TRUE(changes.with({1.}, 1).has_value());
  EXPECT_FALSE(changes.with({1.}, 0.5).has_value());
  changes.add({1.}, 0.5);
  EXPECT_FALSE(changes.with({1.}, 0.5).has_value());
  changes.add({1.}, 0.5);
  EXPECT_TRUE(changes.with({1.}, 0.5).has_value());
  changes.forget();
  EXPECT_FALSE(changes.with({1.}, 0.5).has_value());
}
