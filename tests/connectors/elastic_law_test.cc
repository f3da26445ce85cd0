#include <auxfem/connectors/elastic_law.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  /** Energy by 20000 trapezia from 0 to @p u. */
  double integral(const ForceCurve &curve, const double u)
  {
    constexpr unsigned int n   = 20000;
    double                 sum = 0;
    for (unsigned int i = 0; i < n; ++i)
      sum += (curve.at(u * i / n).force + curve.at(u * (i + 1) / n).force) / 2;
    return sum * u / n;
  }

  /** Slopes 3, 1, 5, 0 with kinks at -2, 1 and 4. */
  const PiecewiseLinearCurve &four_pieces()
  {
    static const PiecewiseLinearCurve curve({{-2, -1}, {1, 2}, {4, 17}}, 3, 0);
    return curve;
  }

  const double sample_extensions[] = {-5, -2, -0.3, 0, 0.5, 1, 2.5, 4, 7};

  double relaxed_force(const ConnectorLaw &law, const double u)
  {
    return law.relaxed(u).force;
  }
} // namespace

TEST(PiecewiseLinearCurve, ForcesAndStiffnesses)
{
  const double forces[]      = {-10, -1, 0.7, 1, 1.5, 2, 9.5, 17, 17};
  const double stiffnesses[] = {3, 3, 1, 1, 1, 5, 5, 5, 0};
  for (unsigned int i = 0; i < 9; ++i)
    {
      const ForceCurve::Value value = four_pieces().at(sample_extensions[i]);
      EXPECT_NEAR(value.force, forces[i], 1e-14) << i;
      // At a kink that of the stiffer side.
      EXPECT_EQ(value.stiffness, stiffnesses[i]) << i;
    }
}

// The trapezia miss less than a kink of 5 N/m in one of them, (7 / 20000)^2.
TEST(PiecewiseLinearCurve, EnergyIsTheIntegralOfTheForce)
{
  for (const double u : sample_extensions)
    EXPECT_NEAR(four_pieces().energy(u), integral(four_pieces(), u), 1e-6);
}

TEST(PiecewiseLinearCurve, WorkOfTheMeanIsTheChangeOfEnergy)
{
  const ForceCurve &curve = four_pieces();
  for (const double from : sample_extensions)
    for (const double to : sample_extensions)
      {
        EXPECT_NEAR(curve.mean(from, to).force * (to - from),
                    curve.energy(to) - curve.energy(from),
                    1e-13);
        if (from == to)
          {
            EXPECT_EQ(curve.mean(from, to).force, curve.at(from).force);
          }
      }
}

// However short the way across a kink is, nothing cancels.
TEST(PiecewiseLinearCurve, MeanOfShortWays)
{
  for (const double way : {1e-3, 1e-8, 1e-14})
    for (const double sign : {1., -1.})
      {
        // Half on either side of the kink at 1, slopes 1 and 5.
        const ForceCurve::Value mean =
          four_pieces().mean(1 - sign * way / 2, 1 + sign * way / 2);
        EXPECT_NEAR(mean.force, 2 + (5 - 1) * way / 8, 2e-15);
        // (k2 3/4 + k1 1/4) / 2, or with the slopes exchanged; the way has an
        // error of 1e-16
        const double stiffness = sign > 0 ? 2 : 1;
        EXPECT_NEAR(mean.stiffness, stiffness, 0.1 * 1e-14 / way + 1e-13);
      }
}

TEST(PiecewiseLinearCurve, DerivativeOfTheMean)
{
  constexpr double h = 1e-6;
  for (const double from : sample_extensions)
    for (const double to : {-4., -1., 0.7, 3., 6.})
      if (from != to)
        {
          EXPECT_NEAR((four_pieces().mean(from, to + h).force -
                       four_pieces().mean(from, to - h).force) /
                        (2 * h),
                      four_pieces().mean(from, to).stiffness,
                      1e-8);
        }
}

TEST(CubicLaw, ForceEnergyAndMean)
{
  const auto law =
    make_law("cubic", {{"Spring stiffness", "3"}, {"Cubic stiffness", "2"}});
  EXPECT_FALSE(law->is_viscous());
  EXPECT_FALSE(law->has_kinks());
  EXPECT_DOUBLE_EQ(relaxed_force(*law, 2), 22);
  EXPECT_DOUBLE_EQ(law->relaxed(2).stiffness, 27);
  EXPECT_DOUBLE_EQ(law->continuous(2, 5, nullptr, nullptr).stored, 14);
  // k u_m + k3 (u0 + u1) (u0^2 + u1^2) / 4
  const ConnectorMotion motion = {2, 0, 1, 0.1};
  ConnectorResponse     response;
  law->evaluate_mean(1, &motion, nullptr, nullptr, &response);
  EXPECT_DOUBLE_EQ(response.force, 12);
}

TEST(BilinearLaw, IsOddAndStiffUpToTheKink)
{
  const auto law = make_law("bilinear",
                            {{"Spring stiffness", "100"},
                             {"Second stiffness", "10"},
                             {"Kink extension", "20 mm"}});
  for (const double sign : {1., -1.})
    {
      EXPECT_DOUBLE_EQ(relaxed_force(*law, sign * 0.01), sign);
      EXPECT_DOUBLE_EQ(relaxed_force(*law, sign * 0.12), sign * 3);
      EXPECT_DOUBLE_EQ(law->continuous(sign * 0.12, 0, nullptr, nullptr).stored,
                       0.02 + 0.25);
    }
}

TEST(GapLaw, PushesOnceTheGapHasClosed)
{
  const auto law =
    make_law("gap", {{"Spring stiffness", "100"}, {"Gap", "20 mm"}});
  EXPECT_EQ(relaxed_force(*law, 1), 0);
  EXPECT_EQ(relaxed_force(*law, -0.02), 0);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, -0.05), -3);
  // Without a gap it holds a structure at rest.
  EXPECT_EQ(
    make_law("gap", {{"Spring stiffness", "100"}})->relaxed(0).stiffness,
    100);
}

TEST(HookLaw, PullsOnceTheSlackIsTakenUp)
{
  const auto law =
    make_law("hook", {{"Spring stiffness", "100"}, {"Slack", "20 mm"}});
  EXPECT_EQ(relaxed_force(*law, -1), 0);
  EXPECT_EQ(relaxed_force(*law, 0.02), 0);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, 0.05), 3);
  EXPECT_EQ(
    make_law("hook", {{"Spring stiffness", "100"}})->relaxed(0).stiffness,
    100);
}

// F (1 + c du/dt) with the elastic force F, none where it is zero.
TEST(GapLaw, StopDamping)
{
  const auto            law     = make_law("gap",
                            {{"Spring stiffness", "100"},
                                            {"Gap", "20 mm"},
                                            {"Stop damping", "0.5 s/m"}});
  const ConnectorMotion closing = {-0.05, -0.4, 0, 1},
                        open    = {-0.01, -0.4, 0, 1};
  ConnectorResponse response;
  law->evaluate(1, &closing, nullptr, nullptr, &response);
  EXPECT_DOUBLE_EQ(response.force, -3 * (1 + 0.5 * 0.4));
  EXPECT_DOUBLE_EQ(response.damping, 0.5 * 3);
  law->evaluate(1, &open, nullptr, nullptr, &response);
  EXPECT_EQ(response.force, 0);
  EXPECT_EQ(response.damping, 0);
}

TEST(BucklingLinkLaw, CompressionStaysAtTheBucklingLoad)
{
  const auto law =
    make_law("buckling-link",
             {{"Spring stiffness", "100"}, {"Buckling load", "5"}});
  EXPECT_DOUBLE_EQ(relaxed_force(*law, 0.1), 10);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, -0.04), -4);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, -0.3), -5);
  EXPECT_EQ(law->relaxed(-0.3).stiffness, 0);
}

TEST(TabulatedLaw, ContinuesBeyondItsEnds)
{
  const auto law =
    make_law("tabulated", {{"Extensions", "-1, 0, 2"}, {"Forces", "-3, 0, 4"}});
  EXPECT_DOUBLE_EQ(relaxed_force(*law, -2), -6);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, -0.5), -1.5);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, 1), 2);
  EXPECT_DOUBLE_EQ(relaxed_force(*law, 3), 6);
}

TEST(TabulatedLaw, RefusesTablesThatAreNone)
{
  const auto refuses =
    [](const std::string &u, const std::string &f, const std::string &word) {
      try
        {
          make_law("tabulated", {{"Extensions", u}, {"Forces", f}});
          ADD_FAILURE() << word;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
            << error.what();
        }
    };
  refuses("0, 1, 1", "0, 1, 2", "must rise");
  refuses("0, 1, 2", "0, 1", "equal length");
  refuses("0", "0", "Extensions");
}
