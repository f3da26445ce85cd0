#include <auxfem/output/json.h>

#include <boost/property_tree/json_parser.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace auxfem;

namespace
{
  boost::property_tree::ptree parse(const JsonObject &object)
  {
    std::istringstream          stream(object.text());
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(stream, tree);
    return tree;
  }
} // namespace

TEST(Json, LayoutIsIndented)
{
  JsonObject inner;
  inner.add("b", 2u);
  JsonObject object;
  object.add("a", 0.5);
  object.add("inner", inner);
  object.add("empty", JsonObject());
  object.add("names", std::vector<std::string>{"x", "y"});
  EXPECT_EQ(object.text(),
            "{\n"
            "  \"a\": 0.5,\n"
            "  \"inner\": {\n"
            "    \"b\": 2\n"
            "  },\n"
            "  \"empty\": {},\n"
            "  \"names\": [\"x\", \"y\"]\n"
            "}");
}

TEST(Json, AnyTextSurvives)
{
  const std::string text =
    "quote \" back \\ line\nreturn\r bell\a Grad \xc2\xb0";
  JsonObject object;
  object.add("text", text);
  EXPECT_EQ(parse(object).get<std::string>("text"), text);
}

TEST(Json, NumbersAreReadBackExactly)
{
  for (const double value : {0.1, -1. / 3, 1e-300, 1.5e300, 0., 12345678901.})
    {
      JsonObject object;
      object.add("value", value);
      EXPECT_EQ(std::stod(parse(object).get<std::string>("value")), value);
    }
}

TEST(Json, NumbersThatAreNotFiniteBecomeNull)
{
  JsonObject object;
  object.add("nan", std::numeric_limits<double>::quiet_NaN());
  object.add("infinity", std::numeric_limits<double>::infinity());
  EXPECT_EQ(object.text(), "{\n  \"nan\": null,\n  \"infinity\": null\n}");
}
