#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <muParser.h>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;

    const std::string table_prefix = "table:";

    double if_function(const double condition,
                       const double then_value,
                       const double else_value)
    {
      return condition != 0 ? then_value : else_value;
    }

    double power(const double base, const double exponent)
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

    /** Reads a cell; false if it is not a finite number as a whole. */
    bool read_number(const std::string &cell, double &number)
    {
      // from_chars does not depend on the locale, but knows no plus sign.
      const char *const begin =
        cell.data() + (cell.size() > 1 && cell[0] == '+' ? 1 : 0);
      const char *const end    = cell.data() + cell.size();
      const auto        answer = std::from_chars(begin, end, number);
      return answer.ec == std::errc() && answer.ptr == end &&
        std::isfinite(number);
    }

    /** Cells of a row; one separator per row: semicolon, comma or blanks. */
    std::vector<std::string> split_row(const std::string &row)
    {
      std::vector<std::string> cells;
      for (const char separator : {';', ','})
        if (row.find(separator) != std::string::npos)
          {
            std::istringstream in(row);
            for (std::string cell; std::getline(in, cell, separator);)
              cells.push_back(trim(cell));
            return cells;
          }
      std::istringstream in(row);
      for (std::string cell; in >> cell;)
        cells.push_back(cell);
      return cells;
    }

    bool is_header(const std::vector<std::string> &cells)
    {
      double number;
      return std::none_of(cells.begin(),
                          cells.end(),
                          [&number](const std::string &cell) {
                            return read_number(cell, number);
                          });
    }
  } // namespace

  /** A function of time that is not zero everywhere. */
  class TimeFunction::Implementation
  {
  public:
    virtual ~Implementation() = default;

    /** Value at time @p t, finite or not. */
    virtual double value(double t) const = 0;

    /** Path and text of the parameter, for messages. */
    std::string origin;
  };

  /** An expression in t. */
  class TimeFunction::Expression : public TimeFunction::Implementation
  {
  public:
    Expression(const std::string  &text,
               const std::string  &path,
               const SceneContext &context)
    {
      parser.DefineVar("t", &time);
      define_functions();
      define_constants(path, context);
      parse(text, path);
    }

    double value(const double t) const override
    {
      time = t;
      return parser.Eval();
    }

    /** Whether `t` does not occur in it. */
    bool is_constant() const
    {
      return constant;
    }

  private:
    void define_functions()
    {
      parser.DefineFun("if", &if_function);
      parser.DefineFun("pow", &power);
      parser.DefineFun("floor", &floor_function);
      parser.DefineFun("ceil", &ceil_function);
      // In some versions of muParser this is the decimal one.
      parser.DefineFun("log", &natural_logarithm);
    }

    void define_constants(const std::string &path, const SceneContext &context)
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

    void parse(const std::string &text, const std::string &path)
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

    mutable double time = 0; ///< where the parser finds `t`
    mu::Parser     parser;
    bool           constant = false;
  };

  /** Two columns of a file, linear between rows. */
  class TimeFunction::Table : public TimeFunction::Implementation
  {
  public:
    /** @p reference is what follows `table:`: a file name, maybe a column. */
    Table(const std::string  &reference,
          const std::string  &path,
          const SceneContext &context)
      : path(path)
    {
      read_reference(reference, context);
      std::ifstream in(file);
      if (!in || std::filesystem::is_directory(file))
        throw InputError(path + ": cannot read the table " + file +
                         ".\nGive the name of a text file; a relative name "
                         "starts from the folder of the parameter file (" +
                         context.directory + ").");
      std::string row;
      for (line = 1; std::getline(in, row); ++line)
        {
          // Spreadsheets mark UTF-8 files by three bytes in front.
          if (line == 1 && row.compare(0, 3, "\xEF\xBB\xBF") == 0)
            row.erase(0, 3);
          read_row(trim(row.substr(0, row.find('#'))));
        }
      if (times.empty())
        throw InputError(path + ": the table " + file +
                         " has no row of numbers.\nNeeded are rows of a time "
                         "(s) and a value, e.g. 0.01, 250.");
    }

    double value(const double t) const override
    {
      const std::size_t next =
        std::upper_bound(times.begin(), times.end(), t) - times.begin();
      if (next == 0)
        return values.front();
      if (next == times.size())
        return values.back();
      const double fraction =
        (t - times[next - 1]) / (times[next] - times[next - 1]);
      return (1 - fraction) * values[next - 1] + fraction * values[next];
    }

  private:
    void read_reference(const std::string  &reference,
                        const SceneContext &context)
    {
      std::string       name  = trim(reference);
      const std::size_t comma = name.rfind(',');
      if (comma != std::string::npos)
        {
          const std::string text = trim(name.substr(comma + 1));
          const auto        answer =
            std::from_chars(text.data(), text.data() + text.size(), column);
          if (answer.ec != std::errc() ||
              answer.ptr != text.data() + text.size() || column < 2)
            throw InputError(path + ": '" + text +
                             "' is not a column of a table.\nColumn 1 is time; "
                             "write table: FILE, COLUMN with a whole number "
                             "from 2, or without it for column 2.");
          name = trim(name.substr(0, comma));
        }
      if (name.empty())
        throw InputError(path +
                         ": 'table:' must be followed by the name of a "
                         "file, e.g. table: force.csv.");
      file = (std::filesystem::path(context.directory) / name).string();
    }

    void read_row(const std::string &row)
    {
      const std::vector<std::string> cells = split_row(row);
      if (cells.empty())
        return;
      if (times.empty() && !header_seen && is_header(cells))
        {
          header_seen = true;
          return;
        }
      if (cells.size() < column)
        fail("has " + std::to_string(cells.size()) +
             (cells.size() == 1 ? " column" : " columns") + ", but column " +
             std::to_string(column) +
             " is asked for.\nSeparate cells by commas, semicolons or blanks.");
      const double t = number(cells[0], 1);
      if (!times.empty() && t <= times.back())
        fail("has the time '" + cells[0] +
             "', which is not after that of the row before.\nTimes (s, first "
             "column) must increase from row to row.");
      times.push_back(t);
      values.push_back(number(cells[column - 1], column));
    }

    double number(const std::string &cell, const unsigned int cell_column) const
    {
      double result;
      if (!read_number(cell, result))
        fail("has '" + cell + "' in column " + std::to_string(cell_column) +
             ", which is not a number.\nWrite numbers like 0.01 or 1e-2, with "
             "a decimal point and without unit.");
      return result;
    }

    [[noreturn]] void fail(const std::string &problem) const
    {
      throw InputError(path + ": line " + std::to_string(line) +
                       " of the table " + file + " " + problem);
    }

    std::string         path; ///< of the parameter, for messages
    std::string         file;
    unsigned int        column      = 2;
    unsigned int        line        = 0;
    bool                header_seen = false;
    std::vector<double> times, values;
  };

  TimeFunction::TimeFunction(const std::string  &text,
                             const std::string  &parameter,
                             const SceneContext &context)
  {
    const std::string trimmed = trim(text);
    if (trimmed.empty())
      return;

    const std::string path =
      (context.path.empty() ? "" : context.path + "/") + parameter;
    std::shared_ptr<Implementation> function;
    if (trimmed.compare(0, table_prefix.size(), table_prefix) == 0)
      function = std::make_shared<Table>(trimmed.substr(table_prefix.size()),
                                         path,
                                         context);
    else
      {
        const auto expression =
          std::make_shared<Expression>(trimmed, path, context);
        if (expression->is_constant() && expression->value(0) == 0)
          return;
        function = expression;
      }
    function->origin = path + ": '" + trimmed + "'";
    implementation   = function;
  }

  double TimeFunction::value(const double t) const
  {
    if (!implementation)
      return 0;
    const double result = implementation->value(t);
    if (!std::isfinite(result))
      {
        std::ostringstream message;
        message.precision(17);
        message << implementation->origin
                << " is not a finite number at t = " << t << " s (" << result
                << ").\nLook for a division by zero, or a root or logarithm "
                   "of a negative number, at that time.";
        throw ComputationError(message.str());
      }
    return result;
  }

  std::array<double, 3> TimeFunction::jet(const double t,
                                          const double scale) const
  {
    Assert(scale > 0 && std::isfinite(scale),
           dealii::ExcMessage("Differences need a time scale > 0."));
    const double f0 = value(t);
    if (!implementation)
      return {{f0, 0, 0}};

    // Steps are powers of two: t + k h is then free of rounding, which the
    // division by h^2 would blow up. Differences to f0 make the derivatives of
    // a constant exactly zero.
    const auto step = [scale](const double n) {
      return std::ldexp(1., std::ilogb(scale / n));
    };
    const auto difference = [this, t, f0](const double dt) {
      return value(t + dt) - f0;
    };

    double h = step(2);
    if (t < 0 || t >= 2 * h)
      {
        const double m2 = difference(-2 * h), m1 = difference(-h);
        const double p1 = difference(h), p2 = difference(2 * h);
        return {{f0,
                 (8 * (p1 - m1) - (p2 - m2)) / (12 * h),
                 (16 * (p1 + m1) - (p2 + m2)) / (12 * h * h)}};
      }

    h = step(5);
    std::array<double, 6> d;
    for (unsigned int k = 0; k < d.size(); ++k)
      d[k] = difference(k * h);
    return {{f0,
             (48 * d[1] - 36 * d[2] + 16 * d[3] - 3 * d[4]) / (12 * h),
             (-154 * d[1] + 214 * d[2] - 156 * d[3] + 61 * d[4] - 10 * d[5]) /
               (12 * h * h)}};
  }

  bool TimeFunction::is_zero() const
  {
    return !implementation;
  }
} // namespace auxfem
