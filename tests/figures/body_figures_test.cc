#include <auxfem/figures/body_figures.h>
#include <auxfem/figures/figure_table.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  RecordedHistory history_of(const std::function<double(double)> &value,
                             const double                         end,
                             const int                            n)
  {
    RecordedHistory history;
    for (int i = 0; i <= n; ++i)
      {
        history.times.push_back(end * i / n);
        history.values.push_back(value(end * i / n));
      }
    return history;
  }

  FigureOptions unfiltered()
  {
    FigureOptions options;
    options.channel_class = std::nullopt;
    return options;
  }
} // namespace

// Rise of 1 s to -20 N, hold of 2 s, fall of 1 s, then nothing: an impulse of
// -60 N s. At a threshold of a half the pulse lasts 3 s and has 55 N s.
TEST(BodyFigures, MeasureATrapezoidPulse)
{
  const RecordedHistory pulse{{0, 1, 3, 4, 10}, {0, -20, -20, 0, 0}};
  FigureOptions         options = unfiltered();
  options.pulse_threshold       = 0.5;
  const ForceFigures figures    = force_figures(pulse, options);
  EXPECT_EQ(figures.peak.value, -20);
  EXPECT_EQ(figures.peak.time, 1);
  EXPECT_FALSE(figures.filtered_peak);
  EXPECT_DOUBLE_EQ(figures.pulse->impulse, -60);
  EXPECT_DOUBLE_EQ(figures.pulse->duration, 3);
  EXPECT_DOUBLE_EQ(figures.pulse->mean, -55. / 3);
}

// Impulse 2 A T / pi; above sin(a) the pulse has 2 A T cos(a) / pi in the time
// T (1 - 2 a / pi).
TEST(BodyFigures, MeasureAHalfSine)
{
  const double A = 7, T = 0.02, a = pi / 6;
  auto         sine = history_of(
    [&](const double t) { return t < T ? A * std::sin(pi * t / T) : 0; },
    2 * T,
    20000);
  FigureOptions options      = unfiltered();
  options.pulse_threshold    = std::sin(a);
  const ForceFigures figures = force_figures(sine, options);
  EXPECT_NEAR(figures.peak.value, A, 1e-12);
  EXPECT_NEAR(figures.peak.time, T / 2, 1e-9);
  EXPECT_NEAR(figures.pulse->impulse, 2 * A * T / pi, 1e-8);
  EXPECT_NEAR(figures.pulse->duration, T * (1 - 2 * a / pi), 1e-8);
  EXPECT_NEAR(figures.pulse->mean,
              2 * A * T * std::cos(a) / pi / (T * (1 - 2 * a / pi)),
              1e-5);
}

TEST(BodyFigures, FilterThePeak)
{
  FigureOptions options;
  options.channel_class      = 60;
  const RecordedHistory sine = history_of(
    [](const double t) {
      return t >= 0.01 && t <= 0.02 ? 100 * std::sin(pi * (t - 0.01) / 0.01)
                                    : 0;
    },
    0.04,
    400);
  const ForceFigures figures = force_figures(sine, options);
  ASSERT_TRUE(figures.filtered_peak);
  EXPECT_NEAR(figures.filtered_peak->value, 95.078753, 1e-6);
  EXPECT_NEAR(figures.filtered_peak->time, 0.015, 1e-12);
}

TEST(BodyFigures, MeasureARebound)
{
  const RecordedHistory velocity{{0, 1, 2, 3}, {-4, -1, 3, 2.5}};
  const ReboundFigures  figures = rebound_figures(velocity);
  EXPECT_EQ(figures.initial_velocity, -4);
  EXPECT_EQ(figures.rebound_velocity, 3);
  EXPECT_EQ(figures.restitution(), 0.75);
  const ReboundFigures none = rebound_figures({{0, 1}, {-4, -1}});
  EXPECT_FALSE(none.rebound_velocity);
  EXPECT_FALSE(none.restitution());
}

// Step response of a mass at 5 Hz with a tenth of critical damping; times by
// another program.
TEST(BodyFigures, FindTheSettlingTimeOfAStepResponse)
{
  const double w = 2 * pi * 5, z = 0.1, wd = w * std::sqrt(1 - z * z);
  const auto   step = history_of(
    [&](const double t) {
      return 1 -
        std::exp(-z * w * t) *
        (std::cos(wd * t) + z / std::sqrt(1 - z * z) * std::sin(wd * t));
    },
    10,
    200000);
  EXPECT_NEAR(*settling_time(step, 0.05), 0.92207543, 1e-6);
  EXPECT_NEAR(*settling_time(step, 0.02), 1.2217778, 1e-6);
}

TEST(BodyFigures, DoNotCallAMotionSettledThatGoesOn)
{
  EXPECT_FALSE(settling_time({{0, 1, 2}, {0, 1, 2}}, 0.05));
  EXPECT_FALSE(settling_time({{0, 1, 2}, {3, 3, 3}}, 0.05));
}

TEST(BodyFigures, ReadTheColumnsOfABody)
{
  RecordedTable table;
  table.names        = {"time", "P.ux", "P.uy", "P.vy", "P.ay", "P.rx", "P.fy"};
  table.columns      = {{0, 1, 2, 3},
                        {0, 1e-12, 0, 1e-12},
                        {5, 4, 3, 9},
                        {-1, -1, 0, 1},
                        {0, 0, 19.6133, 0},
                        {0, 0, 0, 0},
                        {0, 0, 2, 1}};
  const auto figures = figures_of_body("P", table, unfiltered());
  ASSERT_EQ(figures.size(), 1);
  EXPECT_EQ(figures[0].axis, "y");
  EXPECT_EQ(figures[0].force->pulse->impulse, 2.5);
  // The body flies on to the other side after its rebound.
  EXPECT_EQ(figures[0].stroke->value, -2);
  EXPECT_EQ(figures[0].rebound->restitution(), 1);
  for (const BodyFigure &figure : body_figure_columns())
    {
      if (figure.column.name == "peak_acceleration_g")
        {
          EXPECT_DOUBLE_EQ(*figure.value(figures[0]), 2);
        }
    }
  EXPECT_TRUE(figures_of_body("Q", table, unfiltered()).empty());
}
