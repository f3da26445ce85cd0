#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  std::unique_ptr<ConnectorLaw> formula(const std::string &text)
  {
    return make_law("expression", {{"Force", text}});
  }
} // namespace

TEST(ExpressionLaw, ForceAndTangents)
{
  const auto            law      = formula("100*sin(3*u) + 7*v*exp(-v^2)");
  const ConnectorMotion motion   = {0.4, 0.6, 0, 1};
  const double          stored   = 0;
  double                trial    = 0;
  ConnectorResponse     response = {0, 0, 0};
  law->evaluate(1, &motion, &stored, &trial, &response);
  EXPECT_NEAR(response.force,
              100 * std::sin(1.2) + 7 * 0.6 * std::exp(-0.36),
              1e-12);
  EXPECT_NEAR(response.stiffness, 300 * std::cos(1.2), 1e-8);
  EXPECT_NEAR(response.damping, 7 * std::exp(-0.36) * (1 - 2 * 0.36), 1e-9);
}

// Work at v = 0 is stored, whichever way the connector came.
TEST(ExpressionLaw, StoredEnergyIsTheWorkWithoutRate)
{
  LawOnTrial law(formula("200*u + 30*u^3 + 5*v"));
  for (const double u : {0.4, -0.2, 0.7})
    law.ramp(u, 0.1);
  EXPECT_NEAR(law.stored, 100 * 0.49 + 7.5 * std::pow(0.7, 4), 1e-13);
  // 5 (du)^2 / dt
  EXPECT_NEAR(law.dissipated, 50 * (0.16 + 0.36 + 0.81), 1e-12);
}

TEST(ExpressionLaw, IsViscousOnlyWithARate)
{
  EXPECT_FALSE(formula("3*u")->is_viscous());
  EXPECT_TRUE(formula("3*u + v")->is_viscous());
  EXPECT_EQ(formula("3*u + v")->without_viscosity()->relaxed(2).force, 6);
}

TEST(ExpressionLaw, RefusesFormulasThatAreNone)
{
  for (const std::string text : {"3*w", "3*", "1/u"})
    try
      {
        formula(text);
        ADD_FAILURE() << text;
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("Connectors/damper/Force"),
                  std::string::npos)
          << error.what();
      }
}
