#include <auxfem/algebra/ritz_pairs.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

TEST(IndependentPairs, AreThoseOfRitz)
{
  constexpr unsigned int     n = 5;
  dealii::FullMatrix<double> springs(n, n), masses(n, n);
  for (unsigned int i = 0; i < n; ++i)
    {
      springs(i, i) = 2 + i;
      masses(i, i)  = 1 + 0.5 * i;
      if (i > 0)
        {
          springs(i, i - 1) = springs(i - 1, i) = -1;
          masses(i, i - 1) = masses(i - 1, i) = 0.25;
        }
    }
  const RitzPairs expected = ritz_pairs(masses, springs),
                  found    = independent_pairs(masses, springs, 2);
  ASSERT_EQ(found.values.size(), n);
  ASSERT_EQ(found.coefficients.n(), 2u);
  for (unsigned int j = 0; j < n; ++j)
    EXPECT_NEAR(found.values[j], expected.values[j], 1e-14);
  for (unsigned int j = 0; j < 2; ++j)
    for (unsigned int i = 0; i < n; ++i)
      EXPECT_NEAR(std::abs(found.coefficients(i, j)),
                  std::abs(expected.coefficients(i, j)),
                  1e-13);
}
