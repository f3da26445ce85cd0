#include <auxfem/parameters/expression.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;

namespace
{
  double value_of(const std::string &text, double x = 0)
  {
    return Expression(text, {{"x", &x}}, {{"xmax", 4}}, {{"F0", 2.5}}).value();
  }

  std::string problem_of(const std::string                       &text,
                         const std::vector<Expression::Constant> &constants)
  {
    double x = 0;
    try
      {
        Expression(text, {{"x", &x}}, {{"xmax", 4}}, constants);
      }
    catch (const ExpressionError &error)
      {
        EXPECT_NE(error.allowed.find("constants: "), std::string::npos);
        EXPECT_NE(error.allowed.find("floor"), std::string::npos);
        return error.what();
      }
    return "";
  }
} // namespace

TEST(Expression, KnowsFunctionsAndConstants)
{
  EXPECT_EQ(value_of("if(x < xmax, F0, 7)", 3), 2.5);
  EXPECT_EQ(value_of("x < xmax ? F0 : 7", 5), 7);
  EXPECT_EQ(value_of("pow(x, 3) + floor(2.7) - ceil(2.3)", 2), 7);
  EXPECT_EQ(value_of("log(x)", 2), std::log(2.));
  EXPECT_EQ(value_of("pi"), std::acos(-1.));
}

TEST(Expression, FollowsItsVariables)
{
  double           x = 1;
  const Expression twice("2 * x", {{"x", &x}}, {}, {});
  EXPECT_FALSE(twice.is_constant());
  EXPECT_EQ(twice.value(), 2);
  x = 5;
  EXPECT_EQ(twice.value(), 10);
  EXPECT_TRUE(Expression("2 * 3", {{"x", &x}}, {}, {}).is_constant());
}

TEST(Expression, SaysWhatIsWrong)
{
  EXPECT_EQ(problem_of("2 * x", {}), "");
  EXPECT_EQ(problem_of("x = 2", {}), "= assigns; to compare, write \"==\".");
  for (const char *text : {"x == 2", "x <= 2", "x >= 2", "x != 2"})
    EXPECT_EQ(problem_of(text, {}), "") << text;
  EXPECT_EQ(problem_of("1, 2", {}), "A comma stands outside of a function.");
  EXPECT_NE(problem_of("2 * q", {}).find("\"q\""), std::string::npos);
  for (const char *name : {"x", "xmax"})
    EXPECT_EQ(problem_of("1", {{name, 3}}),
              "'" + std::string(name) +
                "' cannot be the name of a constant: it has another meaning "
                "here; rename it.");
  EXPECT_NE(problem_of("1", {{"2F", 3}}).find("begin with a digit"),
            std::string::npos);
}
