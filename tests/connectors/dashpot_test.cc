#include <gtest/gtest.h>

#include "law_on_trial.h"

using namespace auxfem;

TEST(Dashpot, ForceTangentAndLoss)
{
  LawOnTrial dashpot(make_law("dashpot", {{"Damping coefficient", "50"}}));
  const ConnectorResponse response = dashpot.step(0.02, 0.2, 0.1);

  EXPECT_DOUBLE_EQ(response.force, 10.);
  EXPECT_EQ(response.stiffness, 0.);
  EXPECT_DOUBLE_EQ(response.damping, 50.);
  EXPECT_EQ(dashpot.stored, 0.);
  // force 10 N over 0.02 m
  EXPECT_DOUBLE_EQ(dashpot.dissipated, 0.2);
}

TEST(Dashpot, HasNoForceAfterRelaxation)
{
  const auto dashpot = make_law("dashpot", {{"Damping coefficient", "50"}});
  const ConnectorResponse response = dashpot->relaxed(0.02);
  EXPECT_EQ(response.force, 0.);
  EXPECT_EQ(response.damping, 0.);
  EXPECT_EQ(dashpot->relaxed(0).stiffness, 0.);
}

TEST(Dashpot, RefusesNegativeDamping)
{
  EXPECT_ANY_THROW(make_law("dashpot", {{"Damping coefficient", "-1"}}));
}
