#include <auxfem/parameters/text.h>

#include <gtest/gtest.h>

#include <limits>

#include <nlohmann/json.hpp>

using namespace auxfem;

TEST(Json, NumbersAreReadBackExactly)
{
  for (const double value : {0.1, -1. / 3, 1e-300, 1.5e300, 0., 12345678901.})
    EXPECT_EQ(Json::parse(json_text(value)).get<double>(), value);
}

TEST(Json, NonFiniteNumbersAreNull)
{
  EXPECT_EQ(json_text(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(json_text(std::numeric_limits<double>::quiet_NaN()), "null");
}

TEST(Json, AnyTextCanBeWritten)
{
  const std::string text =
    "quote \" back \\ line\nreturn\r bell\a Grad \xc2\xb0";
  EXPECT_EQ(Json::parse(json_text(text)), text);
  // File names may be in other encodings.
  EXPECT_EQ(Json::parse(json_text("Stra\xdf"
                                  "e.prm")),
            "Stra\xef\xbf\xbd"
            "e.prm");
}
