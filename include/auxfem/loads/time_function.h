#ifndef auxfem_loads_time_function_h
#define auxfem_loads_time_function_h

#include <auxfem/parameters/registry.h>

#include <array>
#include <memory>
#include <string>

namespace auxfem
{
  /**
   * A number that depends on time: an expression in `t` (muParser syntax, with
   * the scene's constants and `pi`), or `table: file.csv` (linear between rows,
   * constant outside; `table: file.csv, 3` takes the third column; the first
   * column is time in s). Cheap to copy: copies share the parsed function.
   *
   * Besides muParser's own functions there are `if(condition, then, else)`,
   * `pow`, `floor` and `ceil`; `log` is the natural logarithm.
   *
   * In a table cells are separated by commas, semicolons or white space; a row
   * without any number before the first row of numbers is a header; what
   * follows `#` and empty rows are skipped.
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

    /**
     * Value at time @p t (s). Throws ComputationError if it is not finite. Not
     * to be called by several threads at once.
     */
    double value(double t) const;

    /**
     * Value, first and second time derivative at @p t (s). The derivatives are
     * fourth-order differences between values at most @p scale (s, > 0) away,
     * a time over which the function is smooth (e.g. the time step): central
     * ones, but forward ones where central ones would need times before zero,
     * so that at t = 0 a motion has its rates just after the start. Those of
     * tables are the same differences of the piecewise linear function: between
     * rows, further than @p scale from either, the slope and zero.
     */
    std::array<double, 3> jet(double t, double scale) const;

    /**
     * True if it is zero at all times by construction: an empty text, `0`, or
     * an expression without `t` that is zero.
     */
    bool is_zero() const;

  private:
    class Implementation;
    class Expression;
    class Table;
    std::shared_ptr<const Implementation> implementation;
  };
} // namespace auxfem

#endif
