#include <auxfem/mathematics/non_negative_least_squares.h>
#include <auxfem/struts/prony_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

using namespace auxfem;

namespace
{
  using Complex = std::complex<double>;

  /** Moduli of 2 MPa and Maxwell elements of @p stiffness (Pa) by time (s), at
   * four frequencies per decade from 1e-2 to 1e3 rad/s. */
  std::vector<MeasuredModulus>
  measurements(const std::map<double, double> &stiffness, const double noise)
  {
    std::mt19937                           generator;
    std::uniform_real_distribution<double> error(1 - noise, 1 + noise);
    std::vector<MeasuredModulus>           measured;
    for (int i = -8; i <= 12; ++i)
      {
        const double omega   = std::pow(10., i / 4.);
        Complex      modulus = 2e6;
        for (const auto &[time, k] : stiffness)
          modulus += k * Complex(0, omega * time) / Complex(1, omega * time);
        measured.push_back({omega,
                            modulus.real() * error(generator),
                            modulus.imag() * error(generator)});
      }
    return measured;
  }
} // namespace

TEST(NonNegativeLeastSquares, MeetsItsOptimalityConditions)
{
  std::mt19937                           generator;
  std::uniform_real_distribution<double> noise(-1, 1);
  for (int run = 0; run < 50; ++run)
    {
      std::vector<std::vector<double>> columns(8, std::vector<double>(12));
      std::vector<double>              b(12);
      for (auto &column : columns)
        for (double &entry : column)
          entry = noise(generator);
      for (double &entry : b)
        entry = noise(generator);
      const std::vector<double> x = non_negative_least_squares(columns, b);
      for (std::size_t j = 0; j < columns.size(); ++j)
        for (std::size_t i = 0; i < b.size(); ++i)
          b[i] -= columns[j][i] * x[j];
      // The gradient vanishes where x > 0 and does not fall where x = 0.
      for (std::size_t j = 0; j < columns.size(); ++j)
        {
          double slope = 0;
          for (std::size_t i = 0; i < b.size(); ++i)
            slope += columns[j][i] * b[i];
          EXPECT_GE(x[j], 0);
          if (x[j] > 0)
            {
              EXPECT_NEAR(slope, 0, 1e-12);
            }
          else
            {
              EXPECT_LE(slope, 1e-12);
            }
        }
    }
}

TEST(PronyFit, FindsASeriesWithItsOwnTimes)
{
  // Times of the fit: 1e-3 to 1e2 s, two a decade.
  const PronyFit fit =
    fit_prony_series(measurements({{1e-2, 3e6}, {1, 5e6}}, 0));
  EXPECT_NEAR(fit.instantaneous_modulus, 1e7, 1);
  EXPECT_LT(fit.largest_error, 1e-9);
  double others = 0;
  for (const auto &[time, part] : fit.parts)
    if (std::abs(time - 1e-2) < 1e-9)
      EXPECT_NEAR(part, 0.3, 1e-8);
    else if (std::abs(time - 1) < 1e-9)
      EXPECT_NEAR(part, 0.5, 1e-8);
    else
      others += part;
  EXPECT_LT(others, 1e-8);
}

TEST(PronyFit, BridgesOtherTimesAndNoise)
{
  const std::map<double, double> between = {{0.017, 3e6}, {0.6, 5e6}};
  const PronyFit smooth = fit_prony_series(measurements(between, 0)),
                 noisy  = fit_prony_series(measurements(between, 0.02));
  EXPECT_LT(smooth.largest_error, 0.06);
  EXPECT_NEAR(smooth.instantaneous_modulus, 1e7, 2e5);
  EXPECT_GT(noisy.rms_error, 0.005);
  EXPECT_LT(noisy.rms_error, 0.04);
  double sum = 0;
  for (const auto &[time, part] : noisy.parts)
    {
      EXPECT_GT(part, 0);
      sum += part;
    }
  EXPECT_LT(sum, 1);
}
