#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  std::unique_ptr<ConnectorLaw> slider(const std::string &hardening = "0")
  {
    return make_law("friction-slider",
                    {{"Spring stiffness", "1000"},
                     {"Slip force", "5"},
                     {"Hardening stiffness", hardening}});
  }
} // namespace

TEST(FrictionSlider, SlipsAtItsForceAndSticksOnTheWayBack)
{
  LawOnTrial law(slider("100"));
  EXPECT_DOUBLE_EQ(law.ramp(0.004, 1).force, 4.4);
  EXPECT_EQ(law.dissipated, 0);
  ConnectorResponse response = law.ramp(0.02, 1);
  EXPECT_DOUBLE_EQ(response.force, 7);
  EXPECT_EQ(response.stiffness, 100);
  EXPECT_DOUBLE_EQ(law.dissipated, 5 * 0.015);
  response = law.ramp(0.016, 1);
  EXPECT_NEAR(response.force, 5 - 4 + 1.6, 1e-13);
  EXPECT_EQ(response.stiffness, 1100);
  EXPECT_DOUBLE_EQ(law.dissipated, 5 * 0.015);
}

// The loop is a parallelogram: 4 F0 (A - F0 / k), with any steps.
TEST(FrictionSlider, LossOfACycle)
{
  for (const unsigned int n : {1u, 7u, 100u})
    for (const std::string hardening : {"0", "300"})
      {
        LawOnTrial law(slider(hardening));
        const auto move = [&](const double to) {
          const double from = law.extension;
          for (unsigned int i = 1; i <= n; ++i)
            law.ramp(from + (to - from) * i / n, 1);
        };
        move(0.02);
        const double before = law.dissipated;
        move(-0.02);
        move(0.02);
        EXPECT_NEAR(law.dissipated - before, 4 * 5 * (0.02 - 0.005), 1e-13);
      }
}

TEST(FrictionSlider, DoesNotCreepByRoundOff)
{
  LawOnTrial law(slider());
  law.ramp(0.1, 1);
  const double slip = law.history[0];
  for (unsigned int i = 0; i < 1000; ++i)
    law.ramp(0.1, 1);
  EXPECT_EQ(law.history[0], slip);
}

// The mean force of a step from stick to slip, and back.
TEST(FrictionSlider, MeanForce)
{
  const auto   law       = slider();
  const double committed = 0;
  const auto   mean      = [&](const double from, const double to) {
    const ConnectorMotion motion = {to, 0, from, 1};
    double                trial;
    ConnectorResponse     response;
    law->evaluate_mean(1, &motion, &committed, &trial, &response);
    return response.force;
  };
  // Half of the way sticks.
  EXPECT_DOUBLE_EQ(mean(0, 0.01), (2.5 + 5) / 2);
  EXPECT_DOUBLE_EQ(mean(0, -0.01), -(2.5 + 5) / 2);
  EXPECT_DOUBLE_EQ(mean(0.002, 0.004), 3);
  EXPECT_DOUBLE_EQ(mean(0.002, 0.002), 2);
  EXPECT_DOUBLE_EQ(mean(0.005, 0.009), 5);
  EXPECT_NEAR(mean(0.005, -0.015), (10. * 0 - 5 * 10.) / 20, 1e-14);
}

TEST(FrictionSlider, SmallMotionsStick)
{
  EXPECT_EQ(slider("100")->dynamic_stiffness({0, 3}, 0.2), 1100.);
  EXPECT_FALSE(slider()->is_viscous());
  EXPECT_TRUE(slider()->dissipates());
}
