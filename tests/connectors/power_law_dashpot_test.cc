#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  std::unique_ptr<ConnectorLaw> power_law(const double exponent)
  {
    return make_law("power-law-dashpot",
                    {{"Force at unit rate", "30"},
                     {"Exponent", std::to_string(exponent)},
                     {"Smoothing rate", "1e-6"}});
  }
} // namespace

TEST(PowerLawDashpot, ForceIsAPowerOfTheRate)
{
  for (const double exponent : {0.3, 1., 2.})
    for (const double rate : {-4., 0.25})
      EXPECT_NEAR(
        power_law(exponent)->continuous(0, rate, nullptr, nullptr).force,
        std::copysign(30 * std::pow(std::abs(rate), exponent), rate),
        1e-8);
}

// Near rest the dashpot is linear, C s^(a - 1).
TEST(PowerLawDashpot, TangentAtRestIsFinite)
{
  const auto   law   = power_law(0.5);
  const double slope = 30 / std::sqrt(1e-6);
  EXPECT_NEAR(law->dynamic_stiffness({0., 1.}, 0).imag(), slope, 1e-9 * slope);
  EXPECT_NEAR(law->continuous(0, 1e-9, nullptr, nullptr).force,
              1e-9 * slope,
              1e-6 * 1e-9 * slope);
}

// 2 sqrt(pi) Gamma(1 + a/2) / Gamma(3/2 + a/2) C w^a A^(a + 1). The dissipation
// uses mean rates, which are low by (w dt)^2 / 24.
TEST(PowerLawDashpot, LossOfAHarmonicCycle)
{
  constexpr double       w = 20, amplitude = 0.01;
  constexpr unsigned int n = 400;
  for (const double a : {0.3, 1., 2.})
    {
      LawOnTrial   law(power_law(a));
      const double dt = 2 * M_PI / (w * n);
      for (unsigned int i = 1; i <= n; ++i)
        law.step(amplitude * std::sin(w * dt * i),
                 amplitude * w * std::cos(w * dt * i),
                 dt);
      const double exact = 2 * std::sqrt(M_PI) * std::tgamma(1 + a / 2) /
        std::tgamma(1.5 + a / 2) * 30 * std::pow(w, a) *
        std::pow(amplitude, a + 1);
      EXPECT_NEAR(law.dissipated / exact,
                  1,
                  2 * (a + 1) * std::pow(w * dt, 2) / 24);
      EXPECT_EQ(law.stored, 0);
    }
}
