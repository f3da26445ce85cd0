#include <auxfem/loads/event_search.h>
#include <auxfem/loads/table_history.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/parameter_file.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** A row of the tridiagonal system for slopes at the points. */
    struct Row
    {
      double before, diagonal, after, right_side;
    };

    /** Gaussian elimination of a tridiagonal system without pivoting. */
    std::vector<double> solve(std::vector<Row> rows)
    {
      const std::size_t n = rows.size();
      for (std::size_t i = 1; i < n; ++i)
        {
          const double factor = rows[i].before / rows[i - 1].diagonal;
          rows[i].diagonal -= factor * rows[i - 1].after;
          rows[i].right_side -= factor * rows[i - 1].right_side;
        }
      std::vector<double> result(n);
      for (std::size_t i = n; i-- > 0;)
        result[i] = (rows[i].right_side -
                     (i + 1 < n ? rows[i].after * result[i + 1] : 0.)) /
          rows[i].diagonal;
      return result;
    }

    /** Not-a-knot condition at the second point; @p h, @p d are widths and
     * slopes of the lines between the first three points. */
    Row end_row(const double (&h)[2], const double (&d)[2])
    {
      const double sum = h[0] + h[1];
      return {0,
              h[1],
              sum,
              ((h[0] + 2 * sum) * h[1] * d[0] + h[0] * h[0] * d[1]) / sum};
    }
  } // namespace

  CubicSpline::CubicSpline(std::vector<double> abscissas,
                           std::vector<double> values)
    : x(std::move(abscissas))
    , y(std::move(values))
  {
    const std::size_t n = x.size();
    const auto width = [this](const std::size_t i) { return x[i + 1] - x[i]; };
    const auto line  = [this, width](const std::size_t i) {
      return (y[i + 1] - y[i]) / width(i);
    };
    if (n < 3)
      {
        slopes.assign(n, n == 2 ? line(0) : 0.);
        return;
      }
    if (n == 3)
      {
        const double second = (line(1) - line(0)) / (x[2] - x[0]);
        slopes              = {line(0) - second * width(0),
                               line(0) + second * width(0),
                               line(1) + second * width(1)};
        return;
      }
    std::vector<Row> rows(n);
    rows.front() = end_row({width(0), width(1)}, {line(0), line(1)});
    for (std::size_t i = 1; i + 1 < n; ++i)
      rows[i] = {width(i),
                 2 * (width(i - 1) + width(i)),
                 width(i - 1),
                 3 * (width(i) * line(i - 1) + width(i - 1) * line(i))};
    const Row last =
      end_row({width(n - 2), width(n - 3)}, {line(n - 2), line(n - 3)});
    rows.back() = {last.after, last.diagonal, 0, last.right_side};
    slopes      = solve(rows);
  }

  Jet CubicSpline::operator()(const double at) const
  {
    const std::size_t n = x.size();
    if (n == 1)
      return {y.front()};
    const std::size_t next =
      std::clamp<std::size_t>(std::upper_bound(x.begin(), x.end(), at) -
                                x.begin(),
                              1,
                              n - 1);
    const std::size_t i = next - 1;
    const double      h = x[next] - x[i], s = at - x[i];
    const double      line = (y[next] - y[i]) / h;
    const double      b    = (3 * line - 2 * slopes[i] - slopes[next]) / h,
                 c         = (slopes[i] + slopes[next] - 2 * line) / (h * h);
    return {y[i] + s * (slopes[i] + s * (b + s * c)),
            slopes[i] + s * (2 * b + 3 * c * s),
            2 * b + 6 * c * s};
  }

  namespace
  {
    using dealii::Utilities::trim;

    /** Reads a cell; false if it is not a finite number. */
    bool read_number(const std::string &cell, double &number)
    {
      // from_chars() does not depend on the locale, but refuses a plus sign.
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

    /** See make_table_history(). */
    class TableHistory : public TimeHistory
    {
    public:
      TableHistory(const TableText    &table,
                   const std::string  &path,
                   const SceneContext &context)
        : path(path)
        , scale(read_scale(table.scale, context))
      {
        read_reference(table.file, context);
        std::istringstream in(content(context));
        std::string        row;
        for (line = 1; std::getline(in, row); ++line)
          {
            // Spreadsheets begin UTF-8 files with a byte order mark.
            if (line == 1 && row.compare(0, 3, "\xEF\xBB\xBF") == 0)
              row.erase(0, 3);
            read_row(trim(row.substr(0, row.find('#'))));
          }
        if (times.empty())
          throw InputError(path + ": the table " + file +
                           " has no row of numbers.\nNeeded are rows of a time "
                           "(s) and a value, e.g. 0.01, 250.");
        if (table.kind == TableKind::smooth)
          make_spline();
      }

      double value(const double t) const override
      {
        return limit(t, TimeSide::after);
      }

      double limit(const double t, const TimeSide side) const override
      {
        return jet(t, side).value;
      }

      Jet jet(const double t, const TimeSide side) const override
      {
        const auto next = side == TimeSide::after
          ? std::upper_bound(times.begin(), times.end(), t)
          : std::lower_bound(times.begin(), times.end(), t);
        return between(next - times.begin(), t);
      }

      std::vector<TimeEvent>
      events(const double       begin,
             const double       end,
             const unsigned int derivatives) const override
      {
        std::vector<TimeEvent> result;
        for (std::size_t first = 0, after; first < times.size(); first = after)
          {
            // A jump has two rows.
            const double t = times[first];
            after          = first + 1 < times.size() && times[first + 1] == t
                       ? first + 2
                       : first + 1;
            if (t - begin < time_resolution(t) || end - t < time_resolution(t))
              continue;
            const Jet  left = between(first, t), right = between(after, t);
            const auto larger = [](const double a, const double b) {
              return std::max(std::abs(a), std::abs(b));
            };
            const FunctionSize size = {larger(left.value, right.value),
                                       larger(left.first, right.first),
                                       larger(left.second, right.second)};
            if (is_jump(left.value, right.value, size, 0))
              result.push_back({t, TimeEvent::Kind::jump});
            else if (is_kink(left.first, right.first, size, 0))
              result.push_back({t, TimeEvent::Kind::kink});
            else if (derivatives > 1 &&
                     is_bend(left.second, right.second, size, 0))
              result.push_back({t, TimeEvent::Kind::bend});
          }
        return result;
      }

      std::optional<double> first_time() const override
      {
        return times.front();
      }

      std::optional<double> last_time() const override
      {
        return times.back();
      }

      std::optional<Overshoot> overshoot() const override
      {
        if (!spline)
          return {};
        Overshoot largest = {0, 0, 0};
        for (std::size_t i = 0; i + 1 < times.size(); ++i)
          {
            const auto [least, greatest] =
              std::minmax(values[i], values[i + 1]);
            constexpr int n_samples = 16;
            for (int k = 1; k < n_samples; ++k)
              {
                const double value =
                  (*spline)(times[i] +
                            (times[i + 1] - times[i]) * k / n_samples)
                    .value;
                const double amount = std::max(value - greatest, least - value);
                if (amount > largest.amount)
                  largest = {times[i], times[i + 1], amount};
              }
          }
        const auto [least, greatest] =
          std::minmax_element(values.begin(), values.end());
        return largest.amount > noticeable_fraction * (*greatest - *least)
          ? std::optional(largest)
          : std::nullopt;
      }

    private:
      double read_scale(const std::string  &text,
                        const SceneContext &context) const
      {
        try
          {
            return text.empty() ? 1 : constant_value(text, context.constants);
          }
        catch (const InputError &error)
          {
            throw InputError(path + ": the scale of the table, " +
                             error.what() + ".");
          }
      }

      std::string content(const SceneContext &context) const
      {
        try
          {
            return read_input_file(file);
          }
        catch (const UnreadableFile &unreadable)
          {
            throw InputError(path + ": cannot read the table " + file +
                             ".\nIt " + unreadable.reason +
                             ". Give the name of a text file; a relative name "
                             "starts from the folder of the parameter file (" +
                             context.directory + ").");
          }
      }

      void read_reference(const std::string  &reference,
                          const SceneContext &context)
      {
        std::string       name  = reference;
        const std::size_t comma = name.rfind(',');
        if (comma != std::string::npos)
          {
            const std::string text = trim(name.substr(comma + 1));
            const auto        answer =
              std::from_chars(text.data(), text.data() + text.size(), column);
            if (answer.ec != std::errc() ||
                answer.ptr != text.data() + text.size() || column < 2)
              throw InputError(
                path + ": '" + text +
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
               " is needed.\nSeparate cells by commas, semicolons or blanks.");
        const double t = number(cells[0], 1);
        check_time(t, cells[0]);
        times.push_back(t);
        values.push_back(scale * number(cells[column - 1], column));
      }

      void check_time(const double t, const std::string &cell) const
      {
        const std::size_t n = times.size();
        if (n > 0 && t < times[n - 1])
          fail("has the time '" + cell +
               "', which is before that of the row before.\nTimes (s, first "
               "column) must not decrease from row to row.");
        if (n > 1 && t == times[n - 2])
          fail(
            "is the third with the time '" + cell +
            "'.\nTwo rows at one time are a jump: the values just before and "
            "just after it.");
      }

      double number(const std::string &cell,
                    const unsigned int cell_column) const
      {
        double result;
        if (!read_number(cell, result))
          fail(
            "has '" + cell + "' in column " + std::to_string(cell_column) +
            ", which is not a number.\nWrite numbers like 0.01 or 1e-2, with "
            "a decimal point and without unit.");
        return result;
      }

      [[noreturn]] void fail(const std::string &problem) const
      {
        throw InputError(path + ": line " + std::to_string(line) +
                         " of the table " + file + " " + problem);
      }

      void make_spline()
      {
        const auto jump = std::adjacent_find(times.begin(), times.end());
        if (jump != times.end())
          {
            std::ostringstream message;
            message
              << path << ": the table " << file
              << " has two rows at t = " << *jump
              << " s, a jump, which the spline of a smooth table cannot "
                 "have.\nRemove one of them, or write table: FILE for straight "
                 "lines between the rows.";
            throw InputError(message.str());
          }
        spline.emplace(times, values);
      }

      /** Value and derivatives at @p t between rows next - 1 and @p next, of
       * which one may not exist. */
      Jet between(const std::size_t next, const double t) const
      {
        if (next == 0)
          return {values.front()};
        if (next == times.size())
          return {values.back()};
        if (spline)
          return (*spline)(t);
        const double width    = times[next] - times[next - 1],
                     fraction = (t - times[next - 1]) / width;
        return {(1 - fraction) * values[next - 1] + fraction * values[next],
                (values[next] - values[next - 1]) / width};
      }

      std::string         path;  ///< of the parameter, for messages
      double              scale; ///< factor of the values
      std::string         file;
      unsigned int        column      = 2;
      unsigned int        line        = 0;
      bool                header_seen = false;
      std::vector<double> times, values;
      /** Spline of a smooth table. */
      std::optional<CubicSpline> spline;
    };
  } // namespace



  std::shared_ptr<TimeHistory> make_table_history(const TableText    &table,
                                                  const std::string  &path,
                                                  const SceneContext &context)
  {
    return std::make_shared<TableHistory>(table, path, context);
  }
} // namespace auxfem
