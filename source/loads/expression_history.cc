#include <auxfem/loads/event_search.h>
#include <auxfem/loads/expression_history.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

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

    /** `=` that is not part of `==`, `<=`, `>=`, `!=`. */
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

    /** What may stand in an expression, for messages. */
    std::string expression_help(const mu::Parser &parser)
    {
      std::string constants, functions;
      for (const auto &constant : parser.GetConst())
        constants += (constants.empty() ? "" : ", ") + constant.first;
      for (const auto &function : parser.GetFunDef())
        functions += (functions.empty() ? "" : ", ") + function.first;
      return "Allowed is an expression of the time t (s), e.g. 2e7*t^3 or "
             "100*min(t/0.01, 1), or a table, e.g. table: force.csv.\n"
             "  constants: " +
        constants +
        "\n"
        "  operators: + - * / ^ < > <= >= == != && || ?:\n"
        "  functions: " +
        functions +
        "\n"
        "Write a decimal point, not a comma, and * between factors.";
    }
  } // namespace

  ExpressionHistory::ExpressionHistory(const std::string  &text,
                                       const std::string  &path,
                                       const SceneContext &context)
  {
    parser.DefineVar("t", &time);
    define_functions();
    define_constants(path, context);
    parse(text, path);
  }

  void ExpressionHistory::define_functions()
  {
    parser.DefineFun("if", &if_function);
    parser.DefineFun("pow", &power_function);
    parser.DefineFun("floor", &floor_function);
    parser.DefineFun("ceil", &ceil_function);
    // In some versions of muParser this is the decimal one.
    parser.DefineFun("log", &natural_logarithm);
  }

  void ExpressionHistory::define_constants(const std::string  &path,
                                           const SceneContext &context)
  {
    parser.DefineConst("pi", dealii::numbers::PI);
    for (const auto &[name, value] : context.constants)
      try
        {
          // muParser would let the constant hide the variable.
          if (name == "t")
            throw mu::ParserError("t is the time");
          parser.DefineConst(name, value);
        }
      catch (const mu::ParserError &error)
        {
          throw InputError(
            path + ": '" + name +
            "' cannot be the name of a constant: " + error.GetMsg() +
            "\nNames consist of letters, digits and _, do "
            "not begin with a digit, and are not t.");
        }
  }

  void ExpressionHistory::parse(const std::string &text,
                                const std::string &path)
  {
    const std::string found = path + ": cannot understand '" + text + "': ";
    if (has_assignment(text))
      throw InputError(found + "= assigns; to compare, write ==.");
    try
      {
        parser.SetExpr(text);
        int n_results = 0;
        parser.Eval(n_results);
        if (n_results != 1)
          throw mu::ParserError("A comma stands outside of a function.");

        // GetUsedVar() lets unknown names pass and leaves its own compiled
        // form behind, so it comes second and the text is set once more.
        constant = parser.GetUsedVar().empty();
        parser.SetExpr(text);
      }
    catch (const mu::ParserError &error)
      {
        throw InputError(found + error.GetMsg() + "\n" +
                         expression_help(parser));
      }
  }

  bool ExpressionHistory::is_constant() const
  {
    return constant;
  }

  const ExpressionTree &ExpressionHistory::tree() const
  {
    if (!known_tree)
      {
        // The parser compiles at the first evaluation.
        parser.Eval();
        known_tree =
          std::make_unique<const ExpressionTree>(read_expression(parser));
      }
    return *known_tree;
  }

  double ExpressionHistory::limit(const double t, const TimeSide side) const
  {
    const Jet<double> here   = tree().result(tree().evaluate(t));
    const Jet<double> result = auxfem::limit(tree(), t, side);

    // At a kink branches differ by the round-off of its time.
    double error = 0;
    for (const double slope : {here.first, result.first})
      if (std::isfinite(slope))
        error += time_resolution(t) * std::abs(slope);
    return std::abs(result.value - here.value) <= error ? value(t)
                                                        : result.value;
  }

  Jet<double> ExpressionHistory::jet(const double t, const TimeSide side) const
  {
    Jet<double> result = auxfem::limit(tree(), t, side);
    result.value       = limit(t, side);
    return result;
  }

  std::vector<TimeEvent>
  ExpressionHistory::events(const double       begin,
                            const double       end,
                            const unsigned int derivatives) const
  {
    return find_events(tree(), begin, end, derivatives);
  }
} // namespace auxfem
