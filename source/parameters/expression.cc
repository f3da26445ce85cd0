#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    double if_function(const double condition,
                       const double then_value,
                       const double else_value)
    {
      return condition != 0 ? then_value : else_value;
    }

    double power_function(const double base, const double exponent)
    {
      return std::pow(base, exponent);
    }

    double floor_function(const double x)
    {
      return std::floor(x);
    }

    double ceil_function(const double x)
    {
      return std::ceil(x);
    }

    double natural_logarithm(const double x)
    {
      return std::log(x);
    }

    /** `=` that is not part of `==`, `<=`, `>=`, `!=`: muParser would assign.
     */
    bool has_assignment(const std::string &text)
    {
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=')
          {
            if (i + 1 < text.size() && text[i + 1] == '=')
              ++i;
            else if (i == 0 ||
                     std::string("<>!").find(text[i - 1]) == std::string::npos)
              return true;
          }
      return false;
    }

    /** What every formula knows besides muParser's own functions. */
    void define_common(mu::Parser &parser)
    {
      parser.DefineFun("if", &if_function);
      parser.DefineFun("pow", &power_function);
      parser.DefineFun("floor", &floor_function);
      parser.DefineFun("ceil", &ceil_function);
      // In some versions of muParser this is the decimal one.
      parser.DefineFun("log", &natural_logarithm);
      parser.DefineConst("pi", dealii::numbers::PI);
    }

    std::string allowed(const mu::Parser &parser)
    {
      std::string constants, functions;
      for (const auto &constant : parser.GetConst())
        constants += (constants.empty() ? "" : ", ") + constant.first;
      for (const auto &function : parser.GetFunDef())
        functions += (functions.empty() ? "" : ", ") + function.first;
      return "  constants: " + constants +
        "\n"
        "  operators: + - * / ^ < > <= >= == != && || ?:\n"
        "  functions: " +
        functions;
    }
  } // namespace

  Expression::Expression(const std::string           &text,
                         const std::vector<Variable> &variables,
                         const std::vector<Constant> &own_constants,
                         const std::vector<Constant> &scene_constants)
  {
    try
      {
        define_common(parser);
        define_constants(variables, own_constants, scene_constants);
        for (const auto &[name, value] : variables)
          parser.DefineVar(name, value);
        parse(text);
      }
    catch (const mu::ParserError &error)
      {
        throw ExpressionError(error.GetMsg(), allowed(parser));
      }
  }

  std::string Expression::known()
  {
    mu::Parser parser;
    define_common(parser);
    return allowed(parser);
  }

  void
  Expression::define_constants(const std::vector<Variable> &variables,
                               const std::vector<Constant> &own_constants,
                               const std::vector<Constant> &scene_constants)
  {
    for (const auto &[name, value] : own_constants)
      parser.DefineConst(name, value);
    for (const auto &[name, value] : scene_constants)
      {
        const auto has_name = [&name = name](const auto &other) {
          return other.first == name;
        };
        const std::string problem =
          "'" + name + "' cannot be the name of a constant: ";
        // muParser would let the constant hide the other.
        if (std::any_of(variables.begin(), variables.end(), has_name) ||
            std::any_of(own_constants.begin(), own_constants.end(), has_name))
          throw mu::ParserError(problem +
                                "it has another meaning here; rename it.");
        try
          {
            parser.DefineConst(name, value);
          }
        catch (const mu::ParserError &)
          {
            throw mu::ParserError(problem +
                                  "names consist of letters, digits and _, and "
                                  "do not begin with a digit.");
          }
      }
  }

  void Expression::parse(const std::string &text)
  {
    if (has_assignment(text))
      throw mu::ParserError("= assigns; to compare, write \"==\".");
    parser.SetExpr(text);
    int n_results = 0;
    parser.Eval(n_results);
    if (n_results != 1)
      throw mu::ParserError("A comma stands outside of a function.");

    // GetUsedVar() lets unknown names pass and leaves its own compiled form
    // behind, so it comes second and the text is set once more.
    constant = parser.GetUsedVar().empty();
    parser.SetExpr(text);
  }

  double constant_value(const std::string                       &text,
                        const std::vector<Expression::Constant> &constants)
  {
    std::string problem = "\"" + text + "\" is not a number";
    try
      {
        const double value = Expression(text, {}, {}, constants).value();
        if (std::isfinite(value))
          return value;
      }
    catch (const ExpressionError &)
      {
        // A unit word is none of an expression's names.
      }
    try
      {
        const std::string unit = split_quantity(text).unit;
        if (!unit.empty())
          return parse_quantity(text, unit);
      }
    catch (const InputError &error)
      {
        problem = error.what();
      }
    throw InputError(problem +
                     "; allowed: a number, with or without a unit word, or an "
                     "expression of constants that are given before it");
  }
} // namespace auxfem
