#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

TEST(GeneralizedMaxwell, OneTermIsTheStandardLinearSolid)
{
  LawOnTrial prony(make_law("generalized-maxwell",
                            {{"Long-time stiffness", "400"},
                             {"Stiffnesses", "1000"},
                             {"Relaxation times", "0.05"}}));
  LawOnTrial solid(make_law("standard-linear-solid",
                            {{"Long-time stiffness", "400"},
                             {"Spring stiffness", "1000"},
                             {"Damping coefficient", "50"}}));
  for (unsigned int i = 1; i <= 20; ++i)
    {
      const double extension = 0.01 * std::sin(i);
      EXPECT_DOUBLE_EQ(prony.ramp(extension, 0.02).force,
                       solid.ramp(extension, 0.02).force);
      EXPECT_DOUBLE_EQ(prony.stored, solid.stored);
      EXPECT_DOUBLE_EQ(prony.dissipated, solid.dissipated);
    }
}

TEST(GeneralizedMaxwell, RelaxationIsThePronySeries)
{
  LawOnTrial law(make_law("generalized-maxwell",
                          {{"Long-time stiffness", "50"},
                           {"Stiffnesses", "100, 200, 300"},
                           {"Relaxation times", "1, 0.1, 0.01"}}));
  ASSERT_EQ(law.law->n_history(), 3u);
  const double U = 0.01, dt = 0.013;
  law.ramp(U, 0.);
  for (unsigned int i = 1; i <= 50; ++i)
    {
      const double t = i * dt;
      // round-off of 50 products
      EXPECT_NEAR(law.ramp(U, dt).force,
                  U *
                    (50 + 100 * std::exp(-t) + 200 * std::exp(-t / 0.1) +
                     300 * std::exp(-t / 0.01)),
                  1e-13);
    }
  EXPECT_NEAR(law.stored + law.dissipated, 0.5 * 650 * U * U, 1e-14);
}

TEST(GeneralizedMaxwell, ListsMustBeOfEqualLength)
{
  try
    {
      make_law("generalized-maxwell",
               {{"Stiffnesses", "100, 200"}, {"Relaxation times", "0.1"}});
      FAIL();
    }
  catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("Connectors/damper"), std::string::npos)
        << message;
      EXPECT_NE(message.find("'Stiffnesses' has 2"), std::string::npos)
        << message;
      EXPECT_NE(message.find("'Relaxation times' has 1"), std::string::npos)
        << message;
    }
}

TEST(GeneralizedMaxwell, RefusesNumbersNotPositive)
{
  EXPECT_ANY_THROW(
    make_law("generalized-maxwell",
             {{"Stiffnesses", "100, 0"}, {"Relaxation times", "0.1, 1"}}));
  EXPECT_ANY_THROW(
    make_law("generalized-maxwell",
             {{"Stiffnesses", "100"}, {"Relaxation times", "-1"}}));
}
