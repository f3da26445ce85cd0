#include <auxfem/time/schemes/step_control.h>

#include <gtest/gtest.h>
#include <support/hand_over.h>

#include <cmath>
#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * Steps to @p end in intervals of length 1. A step has the relative error
   * (dt / @p right)^order, where @p right may depend on time (s).
   */
  template <typename Length>
  struct StepsTo
  {
    StepsTo(const unsigned int order,
            const double       smallest,
            const double       end,
            const Length      &right)
    {
      const auto control = make_error_controlled_steps(1, smallest, order);
      double     time    = 0;
      while (time < end)
        {
          const double      target  = std::floor(time + 1);
          const PlannedStep planned = control->plan(time, target);
          const double      error   = std::pow(planned.dt / right(time), order);
          EXPECT_LE(planned.end, target);
          if (!control->may_be_accepted(error))
            {
              EXPECT_TRUE(control->rejected(error));
              ++rejected;
              continue;
            }
          EXPECT_NEAR(planned.end - time, planned.dt, 1e-12);
          changes += !lengths.empty() && lengths.back() != planned.dt;
          lengths.push_back(planned.dt);
          time = planned.end;
          control->accepted(error);
        }
      EXPECT_EQ(time, end);
    }

    std::vector<double> lengths; ///< of accepted steps
    unsigned int        rejected = 0, changes = 0;
  };

  const auto always = [](const double length) {
    return [length](double) { return length; };
  };
} // namespace

TEST(ErrorControlledSteps, FindTheLengthForTheErrorAndKeepIt)
{
  for (const unsigned int order : {2, 3, 4})
    for (const double right : {0.9, 0.3, 0.1, 0.01})
      {
        const StepsTo run(order, 1e-5, 20, always(right));
        const double  last = run.lengths.back();
        EXPECT_LE(last, 1.25 * right) << order;
        // Successive numbers of pieces differ by a factor of up to 3 / 2.
        EXPECT_GE(last, right / 1.5 / 1.25) << order;
        EXPECT_LE(run.rejected, 3u);
        EXPECT_LE(run.changes, 3u) << order << ' ' << right;
      }
}

TEST(ErrorControlledSteps, BecomeMoreThanTwiceAsLongAtOnce)
{
  const StepsTo run(2, 1e-5, 3, [](const double time) {
    return time < 1 ? 0.01 : 0.5;
  });
  EXPECT_LT(run.lengths.front(), 0.011);
  EXPECT_GE(run.lengths.back(), 1. / 6);
  // The mean error decreases over some steps and never grows again.
  EXPECT_LE(run.changes, 12u);
}

TEST(ErrorControlledSteps, LengthsAreAFewExactPartsOfTheInterval)
{
  const StepsTo          run(3, 1e-5, 30, [](const double time) {
    return 0.05 * (1.5 + std::sin(time));
  });
  const std::set<double> lengths(run.lengths.begin(), run.lengths.end());
  for (const double length : lengths)
    {
      unsigned int pieces = 1;
      while (pieces < 1000 && 1. / pieces != length)
        ++pieces;
      while (pieces % 2 == 0)
        pieces /= 2;
      EXPECT_LE(pieces, 7u) << length;
    }
  EXPECT_LE(lengths.size(), 12u);
  EXPECT_GE(lengths.size(), 3u);
}

TEST(ErrorControlledSteps, NoneIsShorterThanTheSmallest)
{
  const StepsTo run(2, 0.07, 3, always(1e-3));
  for (const double length : run.lengths)
    EXPECT_GE(length, 0.07);
  EXPECT_LT(run.lengths.back(), 2 * 0.07);
  const auto control = make_error_controlled_steps(1, 1, 2);
  control->plan(0, 1);
  EXPECT_TRUE(control->may_be_accepted(1e3));
  EXPECT_FALSE(control->rejected(0));
}

TEST(ErrorControlledSteps, OnlyVeryLargeErrorsRepeatAStep)
{
  const auto control = make_error_controlled_steps(1, 1e-3, 2);
  control->plan(0, 1);
  EXPECT_TRUE(control->may_be_accepted(2.9));
  EXPECT_FALSE(control->may_be_accepted(3.1));
}

TEST(ErrorControlledSteps, AFailedStepIsHalved)
{
  const auto control = make_error_controlled_steps(1, 1e-3, 2);
  control->plan(0, 1);
  ASSERT_TRUE(control->rejected(0));
  EXPECT_EQ(control->plan(0, 1).dt, 0.5);
  ASSERT_TRUE(control->rejected(0));
  EXPECT_EQ(control->plan(0, 1).dt, 0.25);
}

TEST(ErrorControlledSteps, KeepTheirLengthInResumedRuns)
{
  const auto control = make_error_controlled_steps(1, 1e-4, 2),
             resumed = make_error_controlled_steps(1, 1e-4, 2);
  double     time    = 0;
  const auto step    = [&time](StepControl &control, const double at) {
    const PlannedStep planned = control.plan(at, std::floor(at + 1));
    control.accepted(std::pow(planned.dt / 0.1, 2));
    time = planned.end;
    return planned;
  };
  control->plan(0, 1);
  control->rejected(100);
  while (time < 1)
    step(*control, time);
  hand_over(*control, *resumed);
  for (unsigned int i = 0; i < 20; ++i)
    {
      const double      at      = time;
      const PlannedStep planned = step(*control, at),
                        other   = step(*resumed, at);
      EXPECT_EQ(planned.end, other.end);
      EXPECT_EQ(planned.dt, other.dt);
    }
  EXPECT_GT(time, 2);
}
