#include <auxfem/algebra/dense_block.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(PrincipalAxes, RecoverThoseOfTheTensor)
{
  const dealii::Tensor<1, 3> a({2. / 3, 2. / 3, 1. / 3}),
    b({-2. / 3, 1. / 3, 2. / 3}), c({1. / 3, -2. / 3, 2. / 3});
  const auto axes = principal_axes(2. * dealii::outer_product(b, b) +
                                   7. * dealii::outer_product(a, a));
  EXPECT_NEAR(axes[0].value, 7, 1e-14);
  EXPECT_NEAR(axes[1].value, 2, 1e-14);
  EXPECT_NEAR(axes[2].value, 0, 1e-14);
  EXPECT_NEAR(std::abs(axes[0].direction * a), 1, 1e-14);
  EXPECT_NEAR(std::abs(axes[1].direction * b), 1, 1e-14);
  EXPECT_NEAR(std::abs(axes[2].direction * c), 1, 1e-14);
}
