#include <auxfem/time/schemes/step_control.h>

#include <gtest/gtest.h>
#include <support/hand_over.h>

#include <vector>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A step control with its current time. */
  struct ControlledSteps
  {
    ControlledSteps(const double step,
                    const double smallest,
                    const double begin = 0)
      : control(make_halved_steps(step, smallest))
      , time(begin)
    {}

    /** Plans the next step to @p target and accepts it. */
    PlannedStep accept(const double target)
    {
      const PlannedStep planned = control->plan(time, target);
      control->accepted(0);
      time = planned.end;
      return planned;
    }

    /** Plans the next step to @p target and rejects it. */
    bool reject(const double target)
    {
      control->plan(time, target);
      return control->rejected(0);
    }

    std::unique_ptr<StepControl> control;
    double                       time;
  };
} // namespace

TEST(StepControl, ConstantStepsReachTheirTargetsWithExactlyEqualLengths)
{
  // 0.1 has no finite binary fraction: differences of its multiples vary in
  // the last digits.
  ControlledSteps walk(0.1, 0.01);
  unsigned int    n_uneven = 0;
  for (unsigned int i = 1; i <= 1000; ++i)
    {
      const double      target = i * 0.1, before = walk.time;
      const PlannedStep planned = walk.accept(target);
      EXPECT_EQ(planned.end, target);
      EXPECT_EQ(planned.dt, 0.1);
      n_uneven += target - before != 0.1;
    }
  EXPECT_GT(n_uneven, 0u);
}

TEST(StepControl, AShorterLastIntervalIsOneStep)
{
  ControlledSteps walk(0.1, 0.01, 1);
  EXPECT_EQ(walk.accept(1.0625).dt, 0.0625);
  EXPECT_EQ(walk.time, 1.0625);
}

TEST(StepControl, AFailedStepIsHalvedAndTheHalvesDoubleWhereTheyAlign)
{
  // Steps of 1: all numbers are exact.
  ControlledSteps walk(1, 1. / 64);
  ASSERT_TRUE(walk.reject(1)); // a whole one
  ASSERT_TRUE(walk.reject(1)); // the first half
  ASSERT_TRUE(walk.reject(1)); // the first quarter
  std::vector<double> ends, lengths;
  while (walk.time < 1)
    {
      const PlannedStep planned = walk.accept(1);
      ends.push_back(planned.end);
      lengths.push_back(planned.dt);
    }
  // Two eighths make a quarter, two quarters a half.
  EXPECT_EQ(lengths, (std::vector<double>{0.125, 0.125, 0.25, 0.5}));
  EXPECT_EQ(ends, (std::vector<double>{0.125, 0.25, 0.5, 1}));

  // The next interval begins with a whole step again.
  EXPECT_EQ(walk.accept(2).dt, 1);
  EXPECT_EQ(walk.time, 2);
}

TEST(StepControl, AStepThatFailsLaterIsHalvedThere)
{
  ControlledSteps walk(1, 1. / 64);
  ASSERT_TRUE(walk.reject(1));
  EXPECT_EQ(walk.accept(1).end, 0.5);
  ASSERT_TRUE(walk.reject(1)); // the second half
  EXPECT_EQ(walk.accept(1).end, 0.75);
  ASSERT_TRUE(walk.reject(1)); // the last quarter
  EXPECT_EQ(walk.accept(1).end, 0.875);
  const PlannedStep last = walk.accept(1);
  EXPECT_EQ(last.end, 1);
  EXPECT_EQ(last.dt, 0.125);
}

TEST(StepControl, PartsOfUnevenStepsEndExactlyAtTheTarget)
{
  for (unsigned int i = 1; i <= 100; ++i)
    {
      ControlledSteps walk(0.1, 1e-3, (i - 1) * 0.1);
      const double    target = i * 0.1;
      ASSERT_TRUE(walk.reject(target));
      ASSERT_TRUE(walk.reject(target));
      for (const double part : {0.25, 0.25, 0.5})
        EXPECT_EQ(walk.accept(target).dt, 0.1 * part);
      EXPECT_EQ(walk.time, target);
    }
}

TEST(StepControl, NoStepIsShorterThanTheSmallest)
{
  ControlledSteps walk(1, 0.25);
  EXPECT_EQ(walk.control->shortest(), 0.25);
  EXPECT_TRUE(walk.reject(1));
  EXPECT_TRUE(walk.reject(1));
  EXPECT_EQ(walk.control->plan(walk.time, 1).dt, 0.25);
  EXPECT_FALSE(walk.control->rejected(0));
  // The first step is already the smallest one.
  ControlledSteps stiff(1, 1);
  EXPECT_FALSE(stiff.reject(1));
}

TEST(StepControl, NoStateRemainsBetweenIntervals)
{
  ControlledSteps walk(1, 0.1);
  walk.reject(1);
  walk.accept(1);
  walk.accept(1);
  ControlledSteps resumed(1, 0.1, walk.time);
  hand_over(*walk.control, *resumed.control);
  EXPECT_EQ(resumed.accept(2).dt, 1);
}
