#include <auxfem/algebra/dense_block.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(DenseBlock, RootOfTwoRowsIsInvertedAsInClosedForm)
{
  // (4 2; 2 5) = L L^T with L = (2 0; 1 2).
  double a[] = {4, 2, 2, 5};
  invert_root(a, 2);
  const double inverse[] = {0.5, 0, -0.25, 0.5};
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(a[i], inverse[i], 1e-15);
}
