#ifndef auxfem_loads_time_history_h
#define auxfem_loads_time_history_h

#include <auxfem/loads/time_event.h>
#include <auxfem/loads/time_function.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
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
