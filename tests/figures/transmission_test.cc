#include <auxfem/figures/transmission.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  RecordedHistory history_of(const std::vector<double>           &times,
                             const std::function<double(double)> &value)
  {
    RecordedHistory history{times, {}};
    for (const double time : times)
      history.values.push_back(value(time));
    return history;
  }

  std::vector<double> equal_times(const double end, const int n)
  {
    std::vector<double> times;
    for (int i = 0; i <= n; ++i)
      times.push_back(end * i / n);
    return times;
  }
} // namespace

// A mass on a damped spring, shaken at its base at half its frequency, in the
// steady state: |H|^2 = (1 + (2 z r)^2) / ((1 - r^2)^2 + (2 z r)^2).
TEST(Transmission, HasTheTransmissibilityOfOneMass)
{
  const double               z = 0.1, r = 0.5, w = 2 * pi * 4;
  const double               in_phase = 1 - r * r, in_quadrature = 2 * z * r;
  const std::complex<double> H = std::complex<double>(1, in_quadrature) /
    std::complex<double>(in_phase, in_quadrature);
  const auto times = equal_times(3, 3000);
  const auto found = transmission_between(
    history_of(times, [&](const double t) { return std::cos(w * t); }),
    history_of(times,
               [&](const double t) {
                 return std::real(H * std::exp(std::complex<double>(0, w * t)));
               }),
    {});
  ASSERT_TRUE(found);
  ASSERT_NE(found->main_line(), nullptr);
  EXPECT_NEAR(found->main_line()->frequency, 4, 1e-12);
  EXPECT_NEAR(std::abs(found->main_line()->input), 1, 1e-12);
  EXPECT_NEAR(std::abs(*found->main_line()->ratio), 1.3282289, 1e-7);
  EXPECT_NEAR(std::arg(*found->main_line()->ratio), std::arg(H), 1e-10);
  EXPECT_NEAR(*found->rms_ratio(), 1.3282289, 1e-3);
}

// Exponentials: exp(-a t) and exp(-b t) have the transforms 1 / (a + i w) and
// 1 / (b + i w).
TEST(Transmission, HasTheSpectrumOfDecayingPulses)
{
  const double a = 20, b = 35;
  const auto   times = equal_times(2, 100000);
  const auto   found = transmission_between(
    history_of(times, [&](const double t) { return std::exp(-a * t); }),
    history_of(times, [&](const double t) { return std::exp(-b * t); }),
    {});
  ASSERT_TRUE(found);
  for (const unsigned int k : {1, 5, 20})
    {
      const TransmissionLine    &line = found->spectrum[k];
      const std::complex<double> iw(0, 2 * pi * line.frequency);
      EXPECT_NEAR(line.frequency, k / 2., 1e-12);
      // The jump at the start is half a sample wide.
      EXPECT_NEAR(std::abs(*line.ratio - (a + iw) / (b + iw)), 0, 1e-3);
    }
}

TEST(Transmission, UsesTheChosenTimes)
{
  const auto          times = equal_times(4, 4000);
  TransmissionOptions options;
  options.from              = 2;
  options.largest_frequency = 10;
  const auto found          = transmission_between(
    history_of(times,
               [](const double t) {
                 return t < 2 ? 9 : std::sin(2 * pi * 5 * t);
               }),
    history_of(times,
               [](const double t) { return 3 * std::sin(2 * pi * 5 * t); }),
    options);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found->peak_ratio(), 3, 1e-10);
  EXPECT_NEAR(std::abs(*found->main_line()->ratio), 3, 1e-10);
  EXPECT_LE(found->spectrum.back().frequency, 10);
  options.to = 2.002;
  EXPECT_FALSE(transmission_between(history_of(times, [](double) { return 1; }),
                                    history_of(times, [](double) { return 1; }),
                                    options));
}

// A frequency between two lines leaks less through Hann's window.
TEST(Transmission, LeaksLessThroughHannsWindow)
{
  const auto          times = equal_times(1, 1000);
  const auto          sine  = history_of(times, [](const double t) {
    return std::sin(2 * pi * 20.5 * t);
  });
  TransmissionOptions hann;
  hann.hann_window  = true;
  const auto raw    = transmission_between(sine, sine, {}),
             smooth = transmission_between(sine, sine, hann);
  EXPECT_LT(std::abs(smooth->spectrum[40].input),
            std::abs(raw->spectrum[40].input) / 20);
}

TEST(Transmission, HasNoRatioWithoutInput)
{
  const auto times = equal_times(1, 100);
  const auto found =
    transmission_between(history_of(times, [](double) { return 0; }),
                         history_of(times, [](double) { return 1; }),
                         {});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->peak_ratio());
  EXPECT_EQ(found->main_line(), nullptr);
}

// Steps shorter than the others for a while do not change the amplitudes.
TEST(Transmission, InterpolatesUnequalSteps)
{
  std::vector<double> times = equal_times(1, 2000);
  times.insert(times.begin() + 700, (times[699] + times[700]) / 2);
  const auto found = transmission_between(
    history_of(times, [](const double t) { return std::sin(2 * pi * 10 * t); }),
    history_of(times, [](const double t) { return std::cos(2 * pi * 10 * t); }),
    {});
  EXPECT_NEAR(found->main_line()->frequency, 10, 1e-12);
  EXPECT_NEAR(std::abs(found->main_line()->input), 1, 1e-3);
  EXPECT_NEAR(std::abs(*found->main_line()->ratio), 1, 1e-3);
}
