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

  /** A time at which a function of time or one of its derivatives jumps. */
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
   * Distance (s) below which two times near @p t are the same: 1e-12 of t or
   * of 1 s. This is thousands of round-offs, because operands of expressions
   * such as (0.01 * t - 3) have fewer digits than t.
   */
  inline double time_resolution(const double t)
  {
    return 4096 * std::numeric_limits<double>::epsilon() *
      std::max(std::abs(t), 1.);
  }

  class TimeHistory;

  /** Interpolation between the rows of a table. */
  enum class TableKind
  {
    linear,
    smooth
  };

  /** Distance by which a spline leaves the range of two neighbouring rows. */
  struct Overshoot
  {
    double begin, end; ///< times of the rows (s)
    double amount;     ///< in the unit of the values
  };

  /** The parts of `SCALE * smooth table: FILE, COLUMN`. */
  struct TableText
  {
    std::string prefix; ///< text before the file name, as the user wrote it
    std::string scale;  ///< factor of the values; empty for one
    TableKind   kind;
    std::string file; ///< file name, maybe followed by a column
  };

  /** Splits a reference to a table; nothing if @p text is none. */
  std::optional<TableText> table_text(const std::string &text);

  /**
   * A scalar function of time: an expression in `t` (see Expression) or a
   * table, `2 kN * smooth table: file.csv, 3`. The table's first column is time
   * (s), the second (or the named) one the value. Lines join the rows, or a
   * CubicSpline those of a smooth table; values are constant outside of them.
   * Two rows of a linear table at one time are a jump; the value at that time
   * is the second one. Copies share the parsed function.
   */
  class TimeFunction
  {
  public:
    /** The constant zero. */
    TimeFunction() = default;

    /** The function times @p factor. */
    TimeFunction scaled(double factor) const;

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
     * Sorted times (s) between @p begin and @p end at which the value or one of
     * the first @p derivatives derivatives (1 or 2) jumps; without times closer
     * to either end than time_resolution(). The same on all ranks.
     *
     * Roots that touch zero count as kinks, such as sqrt((t - 1)^2). Infinite
     * values or slopes are events, too; isolated values, as of `t == 1`, are
     * not.
     */
    std::vector<TimeEvent>
    events(double begin, double end, unsigned int derivatives = 1) const;

    /**
     * First and last time (s) of a table, whose first value holds until then
     * and whose last one from then on; none for expressions.
     */
    ///@{
    std::optional<double> first_time() const;
    std::optional<double> last_time() const;
    ///@}

    /** Largest overshoot of a smooth table, if it exceeds a hundredth of the
     * range of its values. */
    std::optional<Overshoot> overshoot() const;

    /** Path and text of the parameter, for messages; empty for the constant
     * zero. */
    const std::string &origin() const;

    /** @p value of the function in the unit of origin(), before scaled(). */
    double as_written(double value) const;

    /** One-sided limits of value, first and second derivative at @p t (s).
     * Throws ComputationError if one is not finite. */
    std::array<double, 3> jet(double t, TimeSide side = TimeSide::after) const;

    /** Whether the text makes the function zero at all times: it is empty, `0`,
     * or an expression without `t` that is zero. */
    bool is_zero() const
    {
      return !history;
    }

    /** Whether the text makes the function constant, as is_zero(). */
    bool is_constant() const;

  private:
    /** Returns @p result, the @p quantity (empty: value) at @p t, if finite. */
    double
    checked(double result, double t, const std::string &quantity = "") const;

    std::shared_ptr<const TimeHistory> history;
  };

  /** Implementation of a TimeFunction: an expression or a table. */
  class TimeHistory
  {
  public:
    virtual ~TimeHistory() = default;

    /** Value at time @p t (s), finite or not. */
    virtual double value(double t) const = 0;

    /** Limit of the value at @p t (s) from one side, finite or not. */
    virtual double limit(double t, TimeSide side) const = 0;

    /** Limits of the value and its first two derivatives at @p t (s) from one
     * side, finite or not. */
    virtual Jet jet(double t, TimeSide side) const = 0;

    /**
     * Jumps of the value and of its first @p derivatives derivatives, 1 or 2,
     * at begin < t < end (s), sorted.
     */
    virtual std::vector<TimeEvent>
    events(double begin, double end, unsigned int derivatives) const = 0;

    /** See TimeFunction::first_time() and TimeFunction::last_time(). */
    ///@{
    virtual std::optional<double> first_time() const
    {
      return {};
    }

    virtual std::optional<double> last_time() const
    {
      return {};
    }
    ///@}

    /** See TimeFunction::overshoot(). */
    virtual std::optional<Overshoot> overshoot() const
    {
      return {};
    }

    /** Whether the value does not depend on time. */
    virtual bool is_constant() const
    {
      return false;
    }

    /** Path and text of the parameter, for messages. */
    std::string origin;

    /** See TimeFunction::scaled(). */
    double scale = 1;
  };

  /**
   * Reads a table for the parameter @p path. Cells are separated by commas,
   * semicolons or white space; one row of headings, comments after `#` and
   * empty rows are skipped. Throws InputError for a missing or wrong table, and
   * for a jump of a smooth one.
   */
  std::shared_ptr<TimeHistory> make_table_history(const TableText    &table,
                                                  const std::string  &path,
                                                  const SceneContext &context);

  /**
   * Parses the expression in t of the parameter @p path; nullptr if it is zero
   * at all times. Throws InputError if it is no expression.
   */
  std::shared_ptr<TimeHistory>
  make_expression_history(const std::string  &text,
                          const std::string  &path,
                          const SceneContext &context);
} // namespace auxfem

#endif
