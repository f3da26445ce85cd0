#include <auxfem/parameters/expression.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/messages.h>

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

TEST(Expression, EvaluatesFunctionsAndConstants)
{
  EXPECT_EQ(value_of("if(x < xmax, F0, 7)", 3), 2.5);
  EXPECT_EQ(value_of("x < xmax ? F0 : 7", 5), 7);
  EXPECT_EQ(value_of("pow(x, 3) + floor(2.7) - ceil(2.3)", 2), 7);
  EXPECT_EQ(value_of("log(x)", 2), std::log(2.));
  EXPECT_EQ(value_of("pi"), std::acos(-1.));
}

TEST(Expression, UsesPresentValuesOfVariables)
{
  double           x = 1;
  const Expression twice("2 * x", {{"x", &x}}, {}, {});
  EXPECT_FALSE(twice.is_constant());
  EXPECT_EQ(twice.value(), 2);
  x = 5;
  EXPECT_EQ(twice.value(), 10);
  EXPECT_TRUE(Expression("2 * 3", {{"x", &x}}, {}, {}).is_constant());
}

TEST(Expression, ReportsErrors)
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

TEST(ConstantValue, IsANumberAQuantityOrAnExpressionOfConstants)
{
  const std::vector<Expression::Constant> constants = {{"L", 0.02}, {"s", 4}};
  const auto                              value = [&](const std::string &text) {
    return constant_value(text, constants);
  };
  EXPECT_DOUBLE_EQ(value("2.5"), 2.5);
  EXPECT_DOUBLE_EQ(value("5/6"), 5. / 6);
  EXPECT_DOUBLE_EQ(value("20 mm"), 0.02);
  EXPECT_DOUBLE_EQ(value("-2 kg"), -2);
  EXPECT_DOUBLE_EQ(value("3 1/ms"), 3000);
  EXPECT_DOUBLE_EQ(value("L / 4"), 0.005);
  EXPECT_DOUBLE_EQ(value("min(L, 1) * pi"), 0.02 * std::acos(-1.));
  // A constant of the user takes precedence over a unit word.
  EXPECT_DOUBLE_EQ(value("2/s"), 0.5);
  expect_parts(input_error_of([&] { value("q"); }), {"\"q\"", "constants"});
  expect_parts(input_error_of([&] { value("1/(s - 4)"); }), {"no unit"});
  expect_parts(input_error_of([&] { value("3 furlongs"); }), {"furlongs"});
}
