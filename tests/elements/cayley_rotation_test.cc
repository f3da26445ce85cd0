#include <auxfem/elements/cayley_rotation.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(CayleyRotation, GivesTheIncrementOfATurnedVectorFromItsMean)
{
  for (const double angle : {-3., -0.7, -1e-9, 0., 1e-4, 1.2, 2.9})
    {
      const double before[2] = {0.8, -0.3};
      const double c = std::cos(angle), s = std::sin(angle);
      const double after[2] = {c * before[0] - s * before[1],
                               s * before[0] + c * before[1]};
      const double turn     = cayley_rotation(angle);
      EXPECT_NEAR(after[0] - before[0],
                  -turn * (before[1] + after[1]) / 2,
                  1e-15);
      EXPECT_NEAR(after[1] - before[1],
                  turn * (before[0] + after[0]) / 2,
                  1e-15);
      EXPECT_NEAR(angle_per_cayley_rotation(angle) * turn, angle, 1e-15);
    }
  EXPECT_EQ(angle_per_cayley_rotation(0.), 1.);
}

TEST(CayleyRotation, SeriesOfSmallTurnsAreExactToTheLastDigit)
{
  EXPECT_EQ(sinc(0.), 1.);
  for (double x = 1e-3; x < 3; x *= 1.07)
    {
      EXPECT_NEAR(sinc(x), std::sin(x) / x, 2.3e-16) << x;
      EXPECT_EQ(sinc(-x), sinc(x));
      EXPECT_NEAR(cosine_of_small(x), std::cos(x), 2.3e-16) << x;
    }
}
