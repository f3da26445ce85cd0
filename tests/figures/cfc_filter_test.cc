#include <auxfem/figures/cfc_filter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double interval = 1e-4;

  /** Half a sine of amplitude 100 and 10 ms between zeros, 401 samples. */
  RecordedHistory half_sine()
  {
    RecordedHistory history;
    for (int i = 0; i <= 400; ++i)
      {
        history.times.push_back(i * interval);
        history.values.push_back(
          i >= 100 && i <= 200 ? 100 * std::sin(pi * (i - 100) / 100) : 0);
      }
    return history;
  }

  std::vector<double> ramp()
  {
    std::vector<double> values;
    for (int i = 0; i <= 50; ++i)
      values.push_back(1 + i / 50.);
    return values;
  }
} // namespace

// Gains from the formula of the standard, computed by another program.
TEST(CfcFilter, HasThePublishedGain)
{
  const CfcFilter cfc_60(60, interval), cfc_1000(1000, interval),
    cfc_180(180, 1e-5);
  EXPECT_NEAR(cfc_60.gain(60), 0.94912808, 1e-8);
  EXPECT_NEAR(cfc_60.gain(100), 0.70725465, 1e-8);
  EXPECT_NEAR(cfc_60.gain(200), 0.13073752, 1e-8);
  EXPECT_NEAR(cfc_1000.gain(1000), 0.96838979, 1e-8);
  EXPECT_NEAR(cfc_1000.gain(1000 / 0.6), 0.75448367, 1e-8);
  EXPECT_NEAR(cfc_180.gain(300), 0.70711724, 1e-8);
}

// A long sine comes out with the gain and without delay.
TEST(CfcFilter, ScalesASineByItsGain)
{
  const CfcFilter     filter(180, interval);
  const double        frequency = 250;
  std::vector<double> sine;
  for (int i = 0; i <= 2000; ++i)
    sine.push_back(std::sin(2 * pi * frequency * i * interval));
  const std::vector<double> smooth = filter.apply(sine);
  for (int i = 800; i <= 1200; ++i)
    EXPECT_NEAR(smooth[i], filter.gain(frequency) * sine[i], 1e-8);
}

TEST(CfcFilter, SmoothsAHalfSineAsPublishedCodesDo)
{
  const auto by_60  = filtered(half_sine(), 60),
             by_180 = filtered(half_sine(), 180);
  ASSERT_TRUE(by_60 && by_180);
  EXPECT_NEAR(by_60->values[150], 95.078753, 1e-6);
  EXPECT_NEAR(by_60->values[100], 16.117505, 1e-6);
  EXPECT_NEAR(by_60->values[200], 16.117505, 1e-6);
  EXPECT_NEAR(by_180->values[150], 99.965459, 1e-6);
  double sum = 0;
  for (const double value : by_180->values)
    sum += value * interval;
  EXPECT_NEAR(sum, 0.63656741, 1e-8);
}

TEST(CfcFilter, KeepsARampByOddReflection)
{
  const std::vector<double> smooth = CfcFilter(180, interval).apply(ramp(), 30);
  EXPECT_NEAR(smooth[0], 1.0002588, 1e-7);
  EXPECT_NEAR(smooth[25], 1.5000088, 1e-7);
  EXPECT_NEAR(smooth[50], 1.9997435, 1e-7);
}

TEST(CfcFilter, NeedsTenSamplesInTheTimeOfItsClass)
{
  RecordedHistory history;
  for (int i = 0; i <= 20; ++i)
    {
      history.times.push_back(i * 1e-3);
      history.values.push_back(i);
    }
  EXPECT_TRUE(filtered(history, 60));
  EXPECT_TRUE(filtered(history, 100));
  EXPECT_FALSE(filtered(history, 180));
  EXPECT_FALSE(filtered({{0}, {1}}, 60));
}

TEST(CfcFilter, InterpolatesUnequalIntervals)
{
  const RecordedHistory equal = half_sine();
  RecordedHistory       unequal;
  for (std::size_t i = 0; i < equal.times.size(); ++i)
    if (i < 120 || i > 130 || i % 2 == 0)
      {
        unequal.times.push_back(equal.times[i]);
        unequal.values.push_back(equal.values[i]);
      }
  ASSERT_FALSE(is_equally_spaced(unequal));
  const auto smooth = filtered(unequal, 180), exact = filtered(equal, 180);
  EXPECT_NEAR(*std::max_element(smooth->values.begin(), smooth->values.end()),
              *std::max_element(exact->values.begin(), exact->values.end()),
              3e-2);
}
