#include <gtest/gtest.h>

#include "law_on_trial.h"

using namespace auxfem;

TEST(Spring, ForceTangentAndEnergy)
{
  LawOnTrial spring(make_law("spring", {{"Spring stiffness", "1000"}}));
  const ConnectorResponse response = spring.step(0.01, 3., 1e-3);

  EXPECT_DOUBLE_EQ(response.force, 10.);
  EXPECT_DOUBLE_EQ(response.stiffness, 1000.);
  EXPECT_EQ(response.damping, 0.);
  EXPECT_DOUBLE_EQ(spring.stored, 0.05);
  EXPECT_EQ(spring.dissipated, 0.);
}

TEST(Spring, IsItsOwnLongTimeLimit)
{
  const auto law = make_law("spring", {{"Spring stiffness", "2 kN/m"}});
  EXPECT_FALSE(law->is_viscous());
  EXPECT_EQ(law->n_history(), 0u);
  EXPECT_DOUBLE_EQ(law->relaxed(0).stiffness, 2000.);
}

TEST(Spring, ReplacesLawsWithoutViscosity)
{
  LawOnTrial spring(make_spring_law(300.));
  EXPECT_DOUBLE_EQ(spring.step(0.1, 0., infinity).force, 30.);
}
