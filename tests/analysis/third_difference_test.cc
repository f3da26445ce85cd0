#include <auxfem/analysis/third_difference.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace auxfem;

namespace
{
  /** Of @p motion, at the last of @p times. */
  template <typename Motion>
  std::optional<Vector> difference_of(const Motion                &motion,
                                      const std::array<double, 4> &times)
  {
    ThirdDifference difference;
    for (unsigned int i = 0; i < 3; ++i)
      {
        EXPECT_FALSE(
          difference.with(times[3], motion(times[3]), 1.).has_value());
        difference.add(times[i], motion(times[i]));
      }
    return difference.with(times[3], motion(times[3]), times[3] - times[2]);
  }
} // namespace

TEST(ThirdDifference, IsThatOfACubicWithStepsOfAnyLength)
{
  const auto motion = [](const double t) {
    return Vector{t * t * t - 2 * t * t + 3, 5 * t - 1};
  };
  const auto difference = difference_of(motion, {0.1, 0.4, 0.5, 1.1});
  ASSERT_TRUE(difference.has_value());
  EXPECT_NEAR((*difference)[0], 6 * std::pow(0.6, 3), 1e-12);
  EXPECT_NEAR((*difference)[1], 0., 1e-12);
}

TEST(ThirdDifference, OfAnOscillationIsAtMostEightAmplitudes)
{
  for (const double angle : {0.1, 1., 2., 3., 50.})
    {
      const auto motion = [angle](const double t) {
        return Vector{std::cos(angle * t), std::sin(angle * t)};
      };
      const auto difference = difference_of(motion, {0., 1., 2., 3.});
      ASSERT_TRUE(difference.has_value());
      EXPECT_NEAR(std::hypot((*difference)[0], (*difference)[1]),
                  std::pow(2 * std::abs(std::sin(angle / 2)), 3),
                  1e-12);
    }
}

TEST(ThirdDifference, KnowsTheLastThreeValuesOnlyAndForgetsThem)
{
  ThirdDifference difference;
  for (const double t : {-1., 0., 1., 2.})
    difference.add(t, {t < 0 ? 100. : t * t});
  const auto of_square = difference.with(3, {9.}, 1.);
  ASSERT_TRUE(of_square.has_value());
  EXPECT_NEAR((*of_square)[0], 0., 1e-12);
  difference.forget();
  EXPECT_FALSE(difference.has_begun());
  EXPECT_FALSE(difference.with(3, {9.}, 1.).has_value());
}
