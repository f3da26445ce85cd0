#ifndef auxfem_loads_table_history_h
#define auxfem_loads_table_history_h

#include <auxfem/loads/cubic_spline.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/loads/time_history.h>
#include <auxfem/parameters/registry.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Two columns of a file, linear between rows or a cubic spline through them,
   * constant outside. Two rows at one time are a jump of a linear table.
   */
  class TableHistory : public TimeHistory
  {
  public:
    /**
     * @p reference is what follows `table:`: a file name, maybe a column;
     * @p path that of the parameter. Throws InputError if there is no such
     * table, and for a jump of a smooth one.
     */
    TableHistory(const std::string  &reference,
                 const std::string  &path,
                 const SceneContext &context,
                 TableKind           kind);

    double value(double t) const override;

    double limit(const double t, const TimeSide side) const override
    {
      return jet(t, side).value;
    }

    Jet<double> jet(double t, TimeSide side) const override;

    std::vector<TimeEvent>
    events(double begin, double end, unsigned int derivatives) const override;

    std::optional<double> last_time() const override
    {
      return times.back();
    }

  private:
    void   read_reference(const std::string  &reference,
                          const SceneContext &context);
    void   read_row(const std::string &row);
    void   check_time(double t, const std::string &cell) const;
    double number(const std::string &cell, unsigned int cell_column) const;
    [[noreturn]] void fail(const std::string &problem) const;

    void make_spline();
    /** At @p t after row next - 1 and before row @p next, if there are such. */
    Jet<double> between(std::size_t next, double t) const;

    std::string         path; ///< of the parameter, for messages
    std::string         file;
    unsigned int        column      = 2;
    unsigned int        line        = 0;
    bool                header_seen = false;
    std::vector<double> times, values;
    /** If the table is smooth. */
    std::optional<CubicSpline> spline;
  };
} // namespace auxfem

#endif
