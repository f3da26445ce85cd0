#include <auxfem/mathematics/cayley_rotation.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(CayleyRotation, GivesTheIncrementOfARotatedVectorFromItsMean)
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

TEST(CayleyRotation, SeriesOfSmallAnglesAreExactToTheLastDigit)
{
  EXPECT_EQ(sinc(0.), 1.);
  for (double x = 1e-3; x < 3; x *= 1.07)
    {
      EXPECT_NEAR(sinc(x), std::sin(x) / x, 2.3e-16) << x;
      EXPECT_EQ(sinc(-x), sinc(x));
      EXPECT_NEAR(small_angle_cosine(x), std::cos(x), 2.3e-16) << x;
    }
}

TEST(CayleyRotation, InSpaceGivesTheIncrementOfARotatedVectorFromItsMean)
{
  const SpaceVector before({0.8, -0.3, 0.5});
  for (const double size : {1e-9, 0.3, 1., 2.})
    {
      const SpaceVector turn  = size * SpaceVector({0.6, -0.9, 0.4}),
                        c     = cayley_rotation(turn),
                        after = rotated(exponential(turn), before);
      EXPECT_LT((after - before -
                 dealii::cross_product_3d(c, (before + after) / 2))
                  .norm(),
                1e-15 * (1 + c.norm()));
      EXPECT_NEAR(c.norm(), cayley_rotation(turn.norm()), 1e-14 * c.norm());
    }
}

TEST(CayleyRotation, ChangeBySpinAgreesWithDifferences)
{
  const Quaternion  turn = exponential(SpaceVector({0.9, -1.1, 0.4}));
  const SpaceVector c    = cayley_rotation(turn);
  const double      h    = 1e-5;
  for (unsigned int j = 0; j < 3; ++j)
    {
      SpaceVector spin;
      spin[j]                = h;
      const Quaternion  plus = exponential(spin), minus = exponential(-spin);
      const SpaceVector material = (cayley_rotation(turn * plus) -
                                    cayley_rotation(turn * minus)) /
        (2 * h),
                        fixed = (cayley_rotation(plus * turn) -
                                 cayley_rotation(minus * turn)) /
        (2 * h);
      for (unsigned int i = 0; i < 3; ++i)
        {
          EXPECT_NEAR(cayley_spin_derivative(c)[i][j], material[i], 1e-9);
          EXPECT_NEAR(cayley_spin_derivative(-c)[i][j], fixed[i], 1e-9);
        }
    }
}
