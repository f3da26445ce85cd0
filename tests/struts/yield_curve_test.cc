#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "section_on_trial.h"

using namespace auxfem;

namespace
{
  using Entries = std::map<std::string, std::string>;

  /** Stress of a bar of the material @p entries, in GPa with E = 200 GPa, at
   * each of the @p strains. */
  std::vector<double> stresses(const Entries             &entries,
                               const std::vector<double> &strains,
                               const double               dt = 0)
  {
    Entries material            = entries;
    material["Young's modulus"] = "200";
    material["Yield stress"]    = "0.25";
    const auto        law       = make_law(elastic_plastic_entry(), material);
    SectionOnTrial<3> bar(
      *law,
      {{StrainType::normal, StrainType::shear, StrainType::normal}},
      {{2., 0.7, 0.005}});
    std::vector<double> result;
    for (const double strain : strains)
      {
        const Lanes now[] = {strain, 0., 0.};
        result.push_back(
          100 *
          lane_value(bar.step({SectionStep::Kind::end, dt}, now).forces[0], 0));
      }
    return result;
  }
} // namespace

// Return mapping has no error in time for linear hardening: closed forms of the
// cycle strain .005, -.005, .005, 0 with E 200, yield stress .25, kinematic
// modulus 5, isotropic modulus 2 (GPa).
TEST(YieldCurve, CyclesOfABarHaveTheirClosedForm)
{
  const auto   found   = stresses({{"Kinematic hardening modulus", "5"},
                                   {"Plastic strains", "1"},
                                   {"Flow stresses", "2.25"}},
                              {.005, -.005, .005, 0});
  const double exact[] = {.2753623188405797,
                          -.2893649793461111,
                          .3030970570,
                          -.2827473555};
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(found[i], exact[i], 1e-10);
}

// The same with Voce's hardening 0.1 (1 - exp(-20 a)), from a table.
TEST(YieldCurve, TablesApproachCurvedHardening)
{
  std::string strains, flow;
  for (int i = 1; i <= 300; ++i)
    {
      const double a = 1e-4 * i;
      strains += std::to_string(a) + ", ";
      char text[40];
      std::snprintf(text, 40, "%.15g, ", .25 + .1 * (1 - std::exp(-20 * a)));
      flow += text;
    }
  const auto   found   = stresses({{"Kinematic hardening modulus", "5"},
                                   {"Plastic strains", strains + "1"},
                                   {"Flow stresses", flow + "0.35"}},
                              {.005, -.005, .005, 0});
  const double exact[] = {.2751144980, -.2872650330, .2976350768, -.2760917001};
  // Chords of the curve are off by up to .1 (20 1e-4)^2 / 8.
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(found[i], exact[i], 1e-7);
}

// Cowper & Symonds with D = 40.4 / s, n = 5: the stress at a steady strain rate
// satisfies s = .25 (1 + (rate / D)^(1/5)).
TEST(YieldCurve, StressGrowsWithTheStrainRate)
{
  const double exact[] = {.27996841, .36930640, .54968412, .72496733};
  int          i       = 0;
  for (const double rate : {.001, 1., 100., 1000.})
    {
      std::vector<double> strains;
      for (int k = 1; k <= 200; ++k)
        strains.push_back(.01 * k / 200);
      EXPECT_NEAR(stresses({{"Reference strain rate", "40.4"}},
                           strains,
                           .01 / 200 / rate)
                    .back(),
                  exact[i++],
                  1e-6);
    }
}

TEST(YieldCurve, NoTimeLeavesNoTimeToFlow)
{
  const auto found = stresses({{"Reference strain rate", "40.4"}},
                              {.002, .002},
                              /*dt=*/0);
  EXPECT_DOUBLE_EQ(found[0], .4);
  EXPECT_DOUBLE_EQ(found[1], .4);
}
