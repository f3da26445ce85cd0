#include <auxfem/parameters/text.h>

#include <gtest/gtest.h>

#include <limits>

using namespace auxfem;

TEST(RoundedText, HasThreeDigitsAndRarelyAnExponent)
{
  EXPECT_EQ(rounded_text(0), "0");
  EXPECT_EQ(rounded_text(-0.), "0");
  EXPECT_EQ(rounded_text(0.5), "0.5");
  EXPECT_EQ(rounded_text(-0.49268), "-0.493");
  EXPECT_EQ(rounded_text(99.96), "100");
  EXPECT_EQ(rounded_text(1234.5), "1234");
  EXPECT_EQ(rounded_text(1.23456e-3), "0.00123");
  EXPECT_EQ(rounded_text(1.23456e-9), "1.23e-09");
  EXPECT_EQ(rounded_text(1.23456e9), "1.23e+09");
  EXPECT_EQ(rounded_text(std::numeric_limits<double>::infinity()), "inf");
}

TEST(RoundedText, PercentagesHaveNoExponent)
{
  EXPECT_EQ(percentage_text(1), "100 %");
  EXPECT_EQ(percentage_text(0.12345), "12 %");
  EXPECT_EQ(percentage_text(0.12345, 3), "12.3 %");
  EXPECT_EQ(percentage_text(12.3456), "1235 %");
  EXPECT_EQ(percentage_text(-0.), "0 %");
}
