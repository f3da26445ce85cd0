#include <auxfem/figures/recorded_history.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  RecordedHistory record(const std::function<double(double)> &function,
                         const double                         end,
                         const unsigned int                   n_steps)
  {
    RecordedHistory history;
    for (unsigned int i = 0; i <= n_steps; ++i)
      {
        history.times.push_back(end * i / n_steps);
        history.values.push_back(function(history.times.back()));
      }
    return history;
  }

  double quartic(const double t)
  {
    return 1 - 2 * t + t * t * t - 0.5 * std::pow(t, 4);
  }
} // namespace

TEST(RecordedHistory, RecordedTimesHaveTheirOwnValues)
{
  const RecordedHistory history{{0, 1, 2}, {5, -3, 7}};
  EXPECT_EQ(value_at(history, 1), -3);
  // 3 * 0.1 is not 0.3
  EXPECT_EQ(value_at(history, 1 + 1e-15), -3);
  EXPECT_EQ(value_at(history, 0), 5);
  EXPECT_EQ(value_at(history, 2), 7);
}

TEST(RecordedHistory, PolynomialsOfFourthDegreeAreExactInBetween)
{
  const RecordedHistory history = record(quartic, 3, 9);
  for (const double t : {0.01, 0.5, 1.49, 2.2, 2.99})
    EXPECT_NEAR(value_at(history, t), quartic(t), 1e-13) << t;
}

TEST(RecordedHistory, FewValuesGiveAPolynomialOfLowerDegree)
{
  EXPECT_DOUBLE_EQ(value_at({{0, 2}, {1, 5}}, 0.5), 2);
  EXPECT_DOUBLE_EQ(value_at({{0, 1, 2}, {0, 1, 4}}, 1.5), 2.25);
}

TEST(RecordedHistory, MaximumBetweenTheRowsIsFound)
{
  const double  top     = 0.37;
  const Maximum maximum = maximum_of(
    record([top](const double t) { return 2 - std::pow(t - top, 2); }, 1, 10));
  EXPECT_NEAR(maximum.time, top, 1e-7);
  EXPECT_NEAR(maximum.value, 2, 1e-14);
}

TEST(RecordedHistory, MaximumHasTheErrorOfInterpolationByFourthDegree)
{
  constexpr double rate = 5;
  const auto wave = [](const double t) { return std::sin(rate * t + 0.3); };
  for (const unsigned int n : {11, 17, 22, 44, 100})
    {
      const double error = std::abs(maximum_of(record(wave, 1, n)).value - 1);
      // The product of five distances, 1.5 h^5 at most one step from the middle
      // one, times the fifth derivative over 5!
      EXPECT_LT(error, 1.5 * std::pow(rate / n, 5) / 120) << n;
    }
}

TEST(RecordedHistory, MaximumAtTheEndIsTheLastValue)
{
  const Maximum maximum = maximum_of({{0, 1, 2, 3}, {0, 1, 3, 8}});
  EXPECT_EQ(maximum.time, 3);
  EXPECT_EQ(maximum.value, 8);
}

TEST(RecordedHistory, IntegralsOfCubicPolynomialsAreExact)
{
  const auto cubic = [](const double t) { return 4 * t * t * t - 2 * t + 1; };
  EXPECT_NEAR(integral_of(record(cubic, 2, 7)), 16 - 4 + 2, 1e-13);
  // The last step of a run may be shorter.
  RecordedHistory uneven = record(cubic, 2, 7);
  uneven.times.push_back(2.05);
  uneven.values.push_back(cubic(2.05));
  EXPECT_NEAR(integral_of(uneven),
              std::pow(2.05, 4) - 2.05 * 2.05 + 2.05,
              1e-12);
}

TEST(RecordedHistory, IntegralsConvergeWithFourthOrder)
{
  const auto wave   = [](const double t) { return std::sin(t); };
  double     before = 0;
  for (const unsigned int n : {20, 40, 80})
    {
      const double error = std::abs(integral_of(record(wave, pi, n)) - 2);
      if (before > 0)
        {
          EXPECT_NEAR(std::log2(before / error), 4, 0.3) << n;
        }
      before = error;
    }
}
