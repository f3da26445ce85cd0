#include <auxfem/loads/expression_tree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <muParser.h>

using namespace auxfem;

namespace
{
  /** An expression as the parser evaluates it and as a tree. */
  class Expression
  {
  public:
    explicit Expression(const std::string &text)
    {
      parser.DefineVar("t", &time);
      parser.SetExpr(text);
      parser.Eval();
      tree = std::make_unique<ExpressionTree>(read_expression(parser));
    }

    double parsed(const double t)
    {
      time = t;
      return parser.Eval();
    }

    template <typename Number>
    Jet<Number> jet(const Number &t) const
    {
      return tree->result(tree->evaluate(t));
    }

  private:
    double                          time = 0;
    mu::Parser                      parser;
    std::unique_ptr<ExpressionTree> tree;
  };

  void expect_inside(const Interval &bounds, const double x)
  {
    const double round_off = 1e-12 * (1 + std::abs(x));
    EXPECT_GE(x, bounds.lower() - round_off);
    EXPECT_LE(x, bounds.upper() + round_off);
  }

  /**
   * Values against the parser, derivatives against differences, bounds over
   * spans of time against values in them, for 0.2 < t < 0.9 except for times
   * next to switches.
   */
  void check(const std::string &text)
  {
    SCOPED_TRACE(text);
    Expression expression(text);
    for (const double t : {0.23, 0.41, 0.59, 0.83})
      {
        const double      h = 1e-3, f = expression.parsed(t);
        const double      f1  = expression.parsed(t + h);
        const double      f2  = expression.parsed(t - h);
        const Jet<double> jet = expression.jet(t);
        EXPECT_NEAR(jet.value, f, 1e-14 * (1 + std::abs(f)));
        EXPECT_NEAR(jet.first,
                    (f1 - f2) / (2 * h),
                    1e-4 * (1 + std::abs(jet.first)));
        EXPECT_NEAR(jet.second,
                    (f1 - 2 * f + f2) / (h * h),
                    1e-4 * (1 + std::abs(jet.second)));

        for (const double width : {1e-3, 0.1, 0.6})
          {
            const Jet<Interval> bounds =
              expression.jet(Interval(t - width / 3, t + width / 2));
            expect_inside(bounds.value, jet.value);
            expect_inside(bounds.first, jet.first);
            expect_inside(bounds.second, jet.second);
          }
      }
  }
} // namespace

// A new version of muParser may have more of them.
TEST(ExpressionTree, EveryFunctionOfTheParser)
{
  const mu::Parser parser;
  for (const auto &[name, function] : parser.GetFunDef())
    {
      std::string arguments = name == "acosh" ? "1.1+t^2" : "0.8*sin(t)";
      if (function.GetArgc() == 2)
        arguments += ", t-0.5";
      else if (function.GetArgc() < 0)
        arguments += ", 2*t-1, 0.3";
      check(name + "(" + arguments + ")");
    }
}

TEST(ExpressionTree, Operators)
{
  for (const std::string text : {"t",
                                 "-t",
                                 "+t",
                                 "3",
                                 "2*t-1",
                                 "1-2*t",
                                 "-t^2",
                                 "t^3-t^4",
                                 "t^5",
                                 "t^-2",
                                 "t^0.5",
                                 "(t-2)^3",
                                 "2^t",
                                 "(1+t)^t",
                                 "2^t^2",
                                 "t/(1+t)/2",
                                 "sin(2)*t",
                                 "(t-0.5)*(t+0.5)",
                                 "t<0.5",
                                 "t>0.5",
                                 "t<=0.5",
                                 "t>=0.5",
                                 "t==0.5",
                                 "t!=0.5",
                                 "t>0.3 && t<0.7",
                                 "t<0.3 || t>0.7",
                                 "2*(t>0.3) && 3",
                                 "0 || 2*(t>0.3)",
                                 "t<0.5 ? t : 2*t^2",
                                 "t<0.3 ? 1 : t<0.7 ? t : 3",
                                 "t<0.7 ? t<0.3 ? 1 : t : 3",
                                 "1+(t<0.5 ? sin(t) : max(t, 0.6))*2"})
    check(text);
}

TEST(ExpressionTree, LimitsTakeTheBranchesOfAnotherTime)
{
  mu::Parser parser;
  double     time = 0;
  parser.DefineVar("t", &time);
  parser.SetExpr("t<0.5 ? t^2 : 7");
  parser.Eval();
  const ExpressionTree tree = read_expression(parser);
  EXPECT_EQ(tree.result(tree.evaluate(0.5)).value, 7);
  const Jet<double> jet = tree.result(tree.evaluate(0.5, tree.evaluate(0.4)));
  EXPECT_EQ(jet.value, 0.25);
  EXPECT_EQ(jet.first, 1);
  EXPECT_EQ(jet.second, 2);
}
