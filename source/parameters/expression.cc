#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace auxfem
{
  namespace
  {
    /** Hash of the decisions in this thread's current evaluation. */
    thread_local std::uint64_t branches = 0;

    /** Adds the integer @p decision to the hash and returns it. */
    double record_decision(const double decision)
    {
      constexpr std::uint64_t prime = 0x100000001b3; // FNV-1a
      std::uint64_t           bits;
      std::memcpy(&bits, &decision, sizeof(bits));
      branches = (branches ^ (bits >> 32) ^ bits) * prime + 1;
      return decision;
    }

    /** Number of the item in this thread's current evaluation. */
    thread_local std::uint64_t current_item = 0;

    /** Well-mixed bits of @p x (Steele, Lea and Flood, 2014, splitmix64). */
    std::uint64_t mixed(std::uint64_t x)
    {
      x += 0x9e3779b97f4a7c15;
      x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
      x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
      return x ^ (x >> 31);
    }

    /** Number @p k of the present item, uniform in [0, 1). */
    double random_number(const double seed, const unsigned int k)
    {
      const auto whole = static_cast<std::int64_t>(std::floor(seed));
      return std::ldexp(
        double(mixed(mixed(mixed(std::uint64_t(whole)) + current_item) + k) >>
               11),
        -53);
    }

    double uniform_random(const double seed)
    {
      return random_number(seed, 0);
    }

    /** By the method of Box and Muller (1958). */
    double normal_random(const double seed)
    {
      return std::sqrt(-2 * std::log1p(-random_number(seed, 1))) *
        std::cos(2 * dealii::numbers::PI * random_number(seed, 2));
    }

    double if_function(const double condition,
                       const double then_value,
                       const double else_value)
    {
      return record_decision(condition != 0) != 0 ? then_value : else_value;
    }

    double floor_function(const double x)
    {
      return record_decision(std::floor(x));
    }

    double sign_function(const double x)
    {
      return record_decision((x > 0) - (x < 0));
    }

    double tangent(const double x)
    {
      record_decision(std::cos(x) < 0);
      return std::tan(x);
    }

    double angle_of_point(const double y, const double x)
    {
      record_decision(2 * (x < 0) + (y < 0));
      return std::atan2(y, x);
    }

    double quotient(const double x, const double divisor)
    {
      record_decision(divisor < 0);
      return x / divisor;
    }

    /** The operand that precedes all others. */
    template <typename Order>
    double first_of(const double *x, const int n, const Order &precedes)
    {
      const double *first = std::min_element(x, x + n, precedes);
      record_decision(first - x);
      return *first;
    }

    /**
     * Whether there is a `=` outside `==`, `<=`, `>=`, `!=`: muParser would
     * assign.
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

    /**
     * Defines functions that muParser lacks, and replaces those that branch to
     * record their branches.
     */
    void define_functions(mu::Parser &parser)
    {
      parser.DefineFun("if", &if_function);
      parser.DefineFun("floor", &floor_function);
      parser.DefineFun("sign", &sign_function);
      parser.DefineFun("tan", &tangent);
      parser.DefineFun("atan2", &angle_of_point);
      const auto define = [&parser](const char *name, const auto function) {
        parser.DefineFun(name, +function);
      };
      define("pow", [](double x, double y) { return std::pow(x, y); });
      define("ceil", [](double x) { return record_decision(std::ceil(x)); });
      define("rint",
             [](double x) { return record_decision(std::floor(x + 0.5)); });
      // In some versions of muParser `log` is the decimal logarithm.
      define("log", [](double x) { return std::log(x); });
      define("abs",
             [](double x) { return record_decision(x < 0) != 0 ? -x : x; });
      define("min", [](const double *x, int n) {
        return first_of(x, n, std::less<>());
      });
      define("max", [](const double *x, int n) {
        return first_of(x, n, std::greater<>());
      });
    }

    /**
     * Defines all binary operators with muParser's precedences. Its own record
     * no branches, and it replaces all of them or none.
     */
    void define_operators(mu::Parser &parser)
    {
      parser.EnableBuiltInOprt(false);
      const auto define =
        [&parser](const char *name, const int precedence, const auto function) {
          parser.DefineOprt(name,
                            function,
                            precedence,
                            precedence == mu::prPOW ? mu::oaRIGHT : mu::oaLEFT,
                            true);
        };
      define("||", mu::prLOR, [](double a, double b) -> double {
        return a != 0 || b != 0;
      });
      define("&&", mu::prLAND, [](double a, double b) -> double {
        return a != 0 && b != 0;
      });
      define("<", mu::prCMP, [](double a, double b) {
        return record_decision(a < b);
      });
      define(">", mu::prCMP, [](double a, double b) {
        return record_decision(a > b);
      });
      define("<=", mu::prCMP, [](double a, double b) {
        return record_decision(a <= b);
      });
      define(">=", mu::prCMP, [](double a, double b) {
        return record_decision(a >= b);
      });
      define("==", mu::prCMP, [](double a, double b) {
        return record_decision(a == b);
      });
      define("!=", mu::prCMP, [](double a, double b) {
        return record_decision(a != b);
      });
      define("+", mu::prADD_SUB, [](double a, double b) { return a + b; });
      define("-", mu::prADD_SUB, [](double a, double b) { return a - b; });
      define("*", mu::prMUL_DIV, [](double a, double b) { return a * b; });
      define("/", mu::prMUL_DIV, &quotient);
      define("^", mu::prPOW, [](double a, double b) { return std::pow(a, b); });
    }

    /** Defines what every formula may use besides muParser's own functions. */
    void define_common(mu::Parser &parser)
    {
      define_functions(parser);
      define_operators(parser);
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
                         const std::vector<Constant> &scene_constants,
                         const unsigned int *const    item)
    : item(item)
  {
    try
      {
        define_common(parser);
        if (item != nullptr)
          {
            // muParser must not fold them: they depend on the item.
            parser.DefineFun("random", &uniform_random, false);
            parser.DefineFun("normal", &normal_random, false);
          }
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

  std::string Expression::syntax_help()
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
        // muParser would hide the variable behind the constant.
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

    // GetUsedVar() ignores unknown names and leaves its own compiled form
    // behind: it is called second, and the text is set again.
    constant = item == nullptr && parser.GetUsedVar().empty();
    parser.SetExpr(text);
    // The first evaluation folds constants, whose decisions do not recur.
    parser.Eval();
  }

  Expression::BranchedValue Expression::evaluate() const
  {
    branches           = 0;
    current_item       = item == nullptr ? 0 : *item;
    const double value = parser.Eval();
    return {value, branches};
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
        // A unit word is not a name in an expression.
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
