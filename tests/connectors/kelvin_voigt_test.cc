#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  LawOnTrial kelvin_voigt(const std::string &damping = "50")
  {
    return LawOnTrial(make_law("kelvin-voigt",
                               {{"Spring stiffness", "1000"},
                                {"Damping coefficient", damping}}));
  }
} // namespace

TEST(KelvinVoigt, Ramp)
{
  // u = s t with s = 0.1 m/s: F = k s t + c s
  const double times[]  = {0.01, 0.05, 0.1, 0.2};
  const double forces[] = {6., 10., 15., 25.};
  LawOnTrial   law      = kelvin_voigt();
  double       previous = 0;
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(law.step(0.1 * times[i], 0.1, times[i] - previous).force,
                  forces[i],
                  1e-13);
      previous = times[i];
    }
}

// Storage modulus k and loss modulus c w give W = pi c w U^2 per cycle. The
// dissipation uses the mean rate of the step, low by (w dt)^2 / 24, twice that
// in its square: second order in dt.
TEST(KelvinVoigt, LossOfAHarmonicCycle)
{
  const double w = 20, U = 0.01, exact = 0.314159265358979;
  double       error[2];
  for (const unsigned int level : {0, 1})
    {
      const unsigned int n   = 200u << level;
      const double       dt  = 2 * M_PI / (w * n);
      LawOnTrial         law = kelvin_voigt();
      for (unsigned int i = 1; i <= n; ++i)
        {
          const double phase = w * dt * i;
          const double force =
            law.step(U * std::sin(phase), U * w * std::cos(phase), dt).force;
          EXPECT_NEAR(force,
                      U * (1000 * std::sin(phase) + 1000 * std::cos(phase)),
                      1e-12);
        }
      error[level] = std::abs(law.dissipated - exact) / exact;
      EXPECT_LT(error[level], 1.1 * std::pow(w * dt, 2) / 12);
    }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.05);
}

TEST(KelvinVoigt, EnergyBalanceIsExactUnderAverageAcceleration)
{
  LawOnTrial   law  = kelvin_voigt();
  double       rate = 0, largest = 0;
  const double dt = 2e-3;
  for (unsigned int i = 1; i <= 100; ++i)
    {
      const double extension = 0.01 * std::sin(0.3 * i) * std::cos(0.05 * i);
      rate                   = 2 * (extension - law.extension) / dt - rate;
      law.step(extension, rate, dt);
      largest = std::max(largest, std::abs(law.work));
      // round-off of a hundred sums
      EXPECT_NEAR(law.stored + law.dissipated, law.work, 1e-13 * largest);
    }
}

TEST(KelvinVoigt, WithoutDashpotItIsASpring)
{
  LawOnTrial              law      = kelvin_voigt("0");
  const ConnectorResponse response = law.step(0.01, 5., 1e-9);
  EXPECT_FALSE(law.law->is_viscous());
  EXPECT_DOUBLE_EQ(response.force, 10.);
  EXPECT_EQ(response.damping, 0.);
  EXPECT_EQ(law.dissipated, 0.);
}

TEST(KelvinVoigt, AStepOfLengthZeroAndRest)
{
  LawOnTrial law = kelvin_voigt();
  EXPECT_DOUBLE_EQ(law.step(0., 0.1, 0.).force, 5.);
  EXPECT_EQ(law.dissipated, 0.);
  EXPECT_DOUBLE_EQ(law.law->relaxed(0.01).force, 10.);
  EXPECT_EQ(law.law->relaxed(0.01).damping, 0.);
  EXPECT_DOUBLE_EQ(law.law->relaxed(0).stiffness, 1000.);
}
