#include <auxfem/time/step_error.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace auxfem;

namespace
{
  /** Difference of @p motion at the last of @p times. */
  template <typename Motion>
  std::optional<Vector> difference_of(const Motion                &motion,
                                      const std::array<double, 4> &times)
  {
    BackwardDifferences differences;
    for (unsigned int i = 0; i < 3; ++i)
      {
        EXPECT_FALSE(differences.difference(3, times[3], motion(times[3]), 1.)
                       .has_value());
        differences.add(times[i], motion(times[i]));
      }
    return differences.difference(3,
                                  times[3],
                                  motion(times[3]),
                                  times[3] - times[2]);
  }
} // namespace

TEST(BackwardDifferences, AreDerivativesOfAPolynomialForStepsOfAnyLength)
{
  const auto motion = [](const double t) {
    return Vector{t * t * t - 2 * t * t + 3, 5 * t - 1};
  };
  const auto difference = difference_of(motion, {0.1, 0.4, 0.5, 1.1});
  ASSERT_TRUE(difference.has_value());
  EXPECT_NEAR((*difference)[0], 6 * std::pow(0.6, 3), 1e-12);
  EXPECT_NEAR((*difference)[1], 0., 1e-12);
}

TEST(BackwardDifferences, ThirdOneOfAnOscillationIsAtMostEightAmplitudes)
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

TEST(BackwardDifferences, OmitEntriesAddedLater)
{
  BackwardDifferences differences;
  differences.add(0, {1.});
  differences.add(1, {3., 100.});
  const auto difference = differences.difference(2, 2, {7., 200., 300.}, 1.);
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(*difference, Vector{2.});
}

TEST(BackwardDifferences, UseOnlyTheLastValues)
{
  BackwardDifferences differences;
  for (const double t : {-1., 0., 1., 2.})
    differences.add(t, {t < 0 ? 100. : t * t});
  const auto third = differences.difference(3, 3, {9.}, 1.);
  ASSERT_TRUE(third.has_value());
  EXPECT_NEAR((*third)[0], 0., 1e-12);
  const auto second = differences.difference(2, 3, {9.}, 2.);
  ASSERT_TRUE(second.has_value());
  EXPECT_NEAR((*second)[0], 2 * 4., 1e-12);
  differences.clear();
  EXPECT_TRUE(differences.is_empty());
  EXPECT_FALSE(differences.difference(3, 3, {9.}, 1.).has_value());
}
