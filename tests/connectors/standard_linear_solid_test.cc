#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  LawOnTrial standard_linear_solid(const std::string &long_time = "400",
                                   const std::string &damping   = "50")
  {
    return LawOnTrial(make_law("standard-linear-solid",
                               {{"Long-time stiffness", long_time},
                                {"Spring stiffness", "1000"},
                                {"Damping coefficient", damping}}));
  }

  const double times[] = {0.01, 0.05, 0.1, 0.2};
} // namespace

TEST(StandardLinearSolid, Relaxation)
{
  // ten printed digits
  const double forces[] = {12.1873075308,
                           7.6787944117,
                           5.3533528324,
                           4.1831563889};
  LawOnTrial   law      = standard_linear_solid();
  double       previous = 0;
  EXPECT_DOUBLE_EQ(law.ramp(0.01, 0.).force, 14.);
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(law.ramp(0.01, times[i] - previous).force, forces[i], 1e-10);
      previous = times[i];
    }
}

TEST(StandardLinearSolid, Ramp)
{
  const double forces[] = {1.3063462346,
                           5.1606027941,
                           8.3233235838,
                           12.9084218056};
  LawOnTrial   law      = standard_linear_solid();
  double       previous = 0;
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(law.step(0.1 * times[i], 0.1, times[i] - previous).force,
                  forces[i],
                  1e-10);
      previous = times[i];
    }
}

// Force amplitudes of the last of 12 cycles (start decayed to e^-75 at w = 20,
// e^-141 at 10.7) and the loss factor at its peak. Extension is linear in the
// steps: error up to (w dt)^2 / 6 of a modulus.
TEST(StandardLinearSolid, HarmonicModuliAndPeakLossFactor)
{
  const unsigned int n     = 1000;
  const double       bound = std::pow(2 * M_PI / n, 2) / 5;
  for (const double w : {20., 10.69044968})
    {
      LawOnTrial law     = standard_linear_solid();
      double     storage = 0, loss = 0, dissipated = 0;
      for (unsigned int i = 1; i <= 12 * n; ++i)
        {
          if (i == 11 * n + 1)
            dissipated = law.dissipated;
          const double phase = 2 * M_PI * i / n;
          const double force =
            law.ramp(0.01 * std::sin(phase), 2 * M_PI / (w * n)).force;
          if (i > 11 * n)
            {
              storage += 2 * force * std::sin(phase) / (0.01 * n);
              loss += 2 * force * std::cos(phase) / (0.01 * n);
            }
        }
      dissipated = law.dissipated - dissipated;
      EXPECT_NEAR(dissipated, M_PI * loss * 1e-4, dissipated * 2 * bound);
      if (w == 20.)
        {
          EXPECT_NEAR(storage, 900, 1000 * bound);
          EXPECT_NEAR(loss, 500, 1000 * bound);
          EXPECT_NEAR(dissipated, 0.1570796327, 0.2 * bound);
        }
      else
        EXPECT_NEAR(loss / storage, 0.6681531048, 2 * bound);
    }
}

TEST(StandardLinearSolid, WithoutLongTimeStiffnessItIsMaxwell)
{
  LawOnTrial law = standard_linear_solid("0");
  LawOnTrial maxwell(
    make_law("maxwell",
             {{"Spring stiffness", "1000"}, {"Damping coefficient", "50"}}));
  for (unsigned int i = 1; i <= 20; ++i)
    {
      const double extension = 0.01 * std::sin(i);
      EXPECT_DOUBLE_EQ(law.ramp(extension, 0.02).force,
                       maxwell.ramp(extension, 0.02).force);
      EXPECT_DOUBLE_EQ(law.stored, maxwell.stored);
      EXPECT_DOUBLE_EQ(law.dissipated, maxwell.dissipated);
    }
}

TEST(StandardLinearSolid, LimitsOfTheDashpot)
{
  // Infinite: both springs, up to a / 2 = 5e-14 of the force. None: one spring.
  EXPECT_NEAR(standard_linear_solid("400", "1e15").ramp(0.01, 0.1).force,
              14.,
              1e-12);
  LawOnTrial              soft     = standard_linear_solid("400", "0");
  const ConnectorResponse response = soft.ramp(0.01, 0.1);
  EXPECT_DOUBLE_EQ(response.force, 4.);
  EXPECT_DOUBLE_EQ(response.stiffness, 400.);
  EXPECT_EQ(soft.dissipated, 0.);
}

TEST(StandardLinearSolid, InfiniteStepLeavesTheLongTimeSpring)
{
  LawOnTrial law = standard_linear_solid();
  law.ramp(0.01, 0.);
  EXPECT_DOUBLE_EQ(law.stored, 0.07);
  const ConnectorResponse response = law.ramp(0.01, infinity);
  EXPECT_DOUBLE_EQ(response.force, 4.);
  EXPECT_DOUBLE_EQ(response.stiffness, 400.);
  EXPECT_DOUBLE_EQ(law.stored, 0.02);
  EXPECT_DOUBLE_EQ(law.dissipated, 0.05);
  EXPECT_DOUBLE_EQ(law.law->relaxed(0).stiffness, 400.);
}
