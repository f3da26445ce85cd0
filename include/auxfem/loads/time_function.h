#ifndef auxfem_loads_time_function_h
#define auxfem_loads_time_function_h

#include <auxfem/parameters/registry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Value, first and second derivative of a function of time. */
  struct Jet
  {
    double value  = 0;
    double first  = 0;
    double second = 0;
  };

  /** A time at which a function of time or a derivative of it jumps. */
  struct TimeEvent
  {
    enum class Kind
    {
      bend, ///< value and first derivative are continuous, the second is not
      kink, ///< the value is continuous, its first derivative is not
      jump  ///< the value jumps
    };

    double time; ///< s
    Kind   kind;
  };

  /** Side of a time from which a limit is taken. */
  enum class TimeSide
  {
    before,
    after
  };

  /** A time (s) and the side from which it is approached. */
  struct TimeLimit
  {
    double   time;
    TimeSide side;
  };

  /**
   * Distance (s) below which times around @p t are one, 1e-12 of t or of 1 s:
   * some thousand units of round-off, because the operands of expressions like
   * (0.01 * t - 3) carry less digits than the time.
   */
  inline double time_resolution(const double t)
  {
    return 4096 * std::numeric_limits<double>::epsilon() *
      std::max(std::abs(t), 1.);
  }

  class TimeHistory;

  /** What a table is between its rows. */
  enum class TableKind
  {
    linear,
    smooth
  };

  /** How far a smooth table leaves the range of two neighbouring rows. */
  struct Overshoot
  {
    double begin, end; ///< times of the rows (s)
    double amount;     ///< in the unit of the values
  };

  /** The parts of `SCALE * smooth table: FILE, COLUMN`. */
  struct TableText
  {
    std::string prefix; ///< all before the file name, as the user wrote it
    std::string scale;  ///< factor of the values; empty for one
    TableKind   kind;
    std::string file; ///< file name, maybe a column
  };

  /** Nothing if @p text has not this form. */
  std::optional<TableText> table_text(const std::string &text);

  /**
   * A number that depends on time: an expression in `t` (muParser syntax, with
   * the scene's constants and `pi`), or `table: file.csv` (`table: file.csv, 3`
   * takes the third column; the first column is time in s; constant outside of
   * the rows). Straight lines join the rows of a table, a CubicSpline those of
   * `smooth table: file.csv`. `2 kN * table: file.csv` scales the values; the
   * scale is a number with or without unit, or an expression of constants.
   * Cheap to copy: copies share the parsed function.
   *
   * Besides muParser's own functions there are `if(condition, then, else)`,
   * `pow`, `floor` and `ceil`; `log` is the natural logarithm.
   *
   * In a table cells are separated by commas, semicolons or white space; a row
   * without any number before the first row of numbers is a header; what
   * follows `#` and empty rows are skipped. In a linear table two rows at one
   * time are a jump: the values just before and just after it, of which the
   * latter is the value at that time.
   */
  class TimeFunction
  {
  public:
    /** The constant zero. */
    TimeFunction() = default;

    /**
     * @param text as the user wrote it. Throws InputError, naming
     * @p context.path and @p parameter, if it cannot be parsed or read.
     */
    TimeFunction(const std::string  &text,
                 const std::string  &parameter,
                 const SceneContext &context);

    /** The straight line through @p at_zero at 0 and @p at_one at 1.
     * @param origin as origin() */
    static TimeFunction
    line(double at_zero, double at_one, const std::string &origin);

    /**
     * Value at time @p t (s). Throws ComputationError if it is not finite. Not
     * to be called by several threads at once.
     */
    double value(double t) const;

    /**
     * Limit of the value at @p t (s) from the times before: the value at the
     * end of a step that ends at t. It is value() unless something switches at
     * t, as in `t < 0.01 ? 1 : 0`. Throws ComputationError if it is not finite.
     */
    double value_before(double t) const;

    /**
     * Limit of the value at @p t (s) from the times after: the value at the
     * start of a step that begins at t. Throws as value_before().
     */
    double value_after(double t) const;

    /**
     * The times (s) at which the value or one of its first @p derivatives
     * derivatives, 1 or 2, jumps, sorted, of those between @p begin and @p end;
     * either end is excluded, as is what is closer to it than
     * time_resolution(). The same on all ranks.
     *
     * Roots of numbers that touch zero count as kinks, as sqrt((t - 1)^2) has
     * one. Where the function or its slope is infinite there is an event too.
     * Single times at which the value is another one, as in `t == 1`, are none.
     */
    std::vector<TimeEvent>
    events(double begin, double end, unsigned int derivatives = 1) const;

    /**
     * Last time (s) of a table, from which on its last value is held; none for
     * expressions.
     */
    std::optional<double> last_time() const;

    /**
     * The interval between two rows of a smooth table in which the spline
     * leaves the range of both rows most, if it does so by more than a
     * hundredth of the range of the table.
     */
    std::optional<Overshoot> overshoot() const;

    /** Path and text of the parameter; empty for the constant zero. */
    const std::string &origin() const;

    /**
     * Limits of value, first and second time derivative at @p t (s) from one
     * side, exact. Throws ComputationError if one is not finite.
     */
    std::array<double, 3> jet(double t, TimeSide side = TimeSide::after) const;

    /**
     * True if it is zero at all times by construction: an empty text, `0`, or
     * an expression without `t` that is zero.
     */
    bool is_zero() const
    {
      return !history;
    }

    /** True if it is the same at all times by construction, as is_zero(). */
    bool is_constant() const;

  private:
    /** @p result, which is @p what of the function at @p t. */
    double checked(double result, double t, const std::string &what = "") const;

    std::shared_ptr<const TimeHistory> history;
  };

  /** What a TimeFunction consists of: an expression or a table. */
  class TimeHistory
  {
  public:
    virtual ~TimeHistory() = default;

    /** Value at time @p t (s), finite or not. */
    virtual double value(double t) const = 0;

    /** Limit of the value at @p t (s) from one side, finite or not. */
    virtual double limit(double t, TimeSide side) const = 0;

    /**
     * Limits of the value and its first two derivatives at @p t (s) from one
     * side, finite or not.
     */
    virtual Jet jet(double t, TimeSide side) const = 0;

    /**
     * Jumps of the value and of its first @p derivatives derivatives, 1 or 2,
     * at begin < t < end (s), sorted.
     */
    virtual std::vector<TimeEvent>
    events(double begin, double end, unsigned int derivatives) const = 0;

    /** Last time (s) it is given for, from which on its value is held; none if
     * it is given for all. */
    virtual std::optional<double> last_time() const
    {
      return {};
    }

    /** See TimeFunction::overshoot(). */
    virtual std::optional<Overshoot> overshoot() const
    {
      return {};
    }

    /** Whether it does not depend on time at all. */
    virtual bool is_constant() const
    {
      return false;
    }

    /** Path and text of the parameter, for messages. */
    std::string origin;
  };

  /**
   * Two columns of a file, linear between rows or a cubic spline through them,
   * constant outside. Two rows at one time are a jump of a linear table.
   * @p path is that of the parameter. Throws InputError if there is no such
   * table, and for a jump of a smooth one.
   */
  std::shared_ptr<TimeHistory> make_table_history(const TableText    &table,
                                                  const std::string  &path,
                                                  const SceneContext &context);

  /**
   * The expression in t that the user wrote for the parameter @p path; nullptr
   * if it is zero at all times. Throws InputError if it is no expression.
   */
  std::shared_ptr<TimeHistory>
  make_expression_history(const std::string  &text,
                          const std::string  &path,
                          const SceneContext &context);
} // namespace auxfem

#endif
