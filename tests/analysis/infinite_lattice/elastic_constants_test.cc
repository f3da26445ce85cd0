#include <auxfem/analysis/infinite_lattice/elastic_constants.h>
#include <auxfem/mathematics/voigt.h>

#include <deal.II/base/point.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

namespace
{
  using Direction = dealii::Point<3>;

  /** An isotropic continuum of Young's modulus 1. */
  dealii::FullMatrix<double> isotropic(const double nu)
  {
    dealii::FullMatrix<double> S(6, 6);
    for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int j = 0; j < 3; ++j)
          S(i, j) = i == j ? 1 : -nu;
        S(3 + i, 3 + i) = 2 * (1 + nu);
      }
    S.gauss_jordan();
    return S;
  }

  /** Cubic symmetry. */
  dealii::FullMatrix<double>
  cubic(const double C11, const double C12, const double C44)
  {
    dealii::FullMatrix<double> C(6, 6);
    for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int j = 0; j < 3; ++j)
          C(i, j) = i == j ? C11 : C12;
        C(3 + i, 3 + i) = C44;
      }
    return C;
  }
} // namespace

TEST(ElasticConstants, IsotropicOnesAreThoseOfAnyDirection)
{
  const double           nu = 0.3;
  const ElasticConstants constants(isotropic(nu));
  const Direction        n(0.48, 0.6, 0.64), m(-0.8, 0.6, 0);
  EXPECT_NEAR(constants.youngs_modulus(n), 1, 1e-14);
  EXPECT_NEAR(constants.poissons_ratio(m, Direction(0, 0, 1)), nu, 1e-14);
  EXPECT_NEAR(constants.shear_modulus(m, Direction(0, 0, 1)), 1 / 2.6, 1e-14);
  for (const double value : constants.poissons_ratios(n))
    EXPECT_NEAR(value, nu, 1e-14);
  for (const double value : constants.shear_moduli(n))
    EXPECT_NEAR(value, 1 / 2.6, 1e-14);
  EXPECT_NEAR(constants.bulk_modulus(), 1 / (3 * (1 - 2 * nu)), 1e-14);
  EXPECT_NEAR(constants.anisotropy(), 0, 1e-15);
}

// Hayes and Shuvalov (1998): along (1, 1, 0) of a cubic crystal the extremes of
// Poisson's ratio are those across along (0, 0, 1) and (1, -1, 0).
TEST(ElasticConstants, CubicOnesDependOnTheDirection)
{
  const ElasticConstants constants(cubic(3, 1, 2.5));
  const double           S11 = (*constants.compliance())(0, 0),
               S12 = (*constants.compliance())(0, 1), S44 = 1 / 2.5;
  const double    s = std::sqrt(0.5);
  const Direction n(s, s, 0);
  const double    along = (S11 + S12) / 2 + S44 / 4;
  EXPECT_NEAR(constants.youngs_modulus(n), 1 / along, 1e-14);
  const double across_z = -S12 / along,
               in_plane = -((S11 + S12) / 2 - S44 / 4) / along;
  EXPECT_NEAR(constants.poissons_ratio(n, Direction(s, -s, 0)),
              in_plane,
              1e-14);
  const auto range = constants.poissons_ratios(n);
  EXPECT_NEAR(range[0], std::min(across_z, in_plane), 1e-14);
  EXPECT_NEAR(range[1], std::max(across_z, in_plane), 1e-14);
  EXPECT_NEAR(constants.shear_modulus(Direction(1, 0, 0), Direction(0, 1, 0)),
              2.5,
              1e-14);
  EXPECT_GT(constants.anisotropy(), 0.1);
}

TEST(ElasticConstants, SingularStiffnessesHaveNoCompliance)
{
  EXPECT_FALSE(ElasticConstants(cubic(1, 0, 0)).compliance());
  EXPECT_TRUE(ElasticConstants(cubic(1, 0, 1e-6)).compliance());
}

TEST(ElasticConstants, TellHowFarTheyWereFromSymmetric)
{
  dealii::FullMatrix<double> C(3, 3);
  C(0, 0) = C(1, 1) = C(2, 2) = 1;
  C(0, 1)                     = 0.25;
  C(1, 0)                     = 0.2501;
  EXPECT_NEAR(ElasticConstants(C).asymmetry(), 1e-4 / 1.25, 1e-6);
}
