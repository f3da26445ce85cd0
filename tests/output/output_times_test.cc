#include <auxfem/output/recorder.h>

#include <gtest/gtest.h>

#include <vector>

using namespace auxfem;

TEST(OutputTimes, AreAllMultiplesDespiteRoundOff)
{
  const OutputTimes times(1e-3, 1e-11);
  double            time = 0;
  for (unsigned int i = 1; i <= 1000; ++i)
    {
      const std::optional<double> next = times.after(time);
      ASSERT_TRUE(next);
      EXPECT_EQ(*next, i * 1e-3);
      EXPECT_TRUE(times.has(*next));
      time = *next;
    }
}

TEST(OutputTimes, AcceptNearbyTimes)
{
  const OutputTimes times(1e-3, 1e-11);
  EXPECT_TRUE(times.has(7e-3 + 1e-11));
  EXPECT_TRUE(times.has(7e-3 - 1e-11));
  EXPECT_FALSE(times.has(7e-3 + 1e-10));
  EXPECT_DOUBLE_EQ(*times.after(7e-3 - 1e-10), 7e-3);
  EXPECT_DOUBLE_EQ(*times.after(7e-3 + 1e-10), 8e-3);
}

TEST(OutputTimes, WithoutAnIntervalAreNone)
{
  const OutputTimes times({}, 1e-11);
  EXPECT_FALSE(times.after(0));
  EXPECT_FALSE(times.has(1));
}
