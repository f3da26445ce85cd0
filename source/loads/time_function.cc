#include <auxfem/loads/expression_course.h>
#include <auxfem/loads/table_course.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;

    const std::string table_prefix = "table:";
  } // namespace

  TimeFunction::TimeFunction(const std::string  &text,
                             const std::string  &parameter,
                             const SceneContext &context)
  {
    const std::string trimmed = trim(text);
    if (trimmed.empty())
      return;

    const std::string path =
      (context.path.empty() ? "" : context.path + "/") + parameter;
    std::shared_ptr<TimeCourse> function;
    if (trimmed.compare(0, table_prefix.size(), table_prefix) == 0)
      function =
        std::make_shared<TableCourse>(trimmed.substr(table_prefix.size()),
                                      path,
                                      context);
    else
      {
        const auto expression =
          std::make_shared<ExpressionCourse>(trimmed, path, context);
        if (expression->is_constant() && expression->value(0) == 0)
          return;
        function = expression;
      }
    function->origin = path + ": '" + trimmed + "'";
    course           = function;
  }

  double TimeFunction::value(const double t) const
  {
    return course ? checked(course->value(t), t) : 0;
  }

  double TimeFunction::value_before(const double t) const
  {
    return course ? checked(course->limit(t, TimeSide::before), t) : 0;
  }

  double TimeFunction::value_after(const double t) const
  {
    return course ? checked(course->limit(t, TimeSide::after), t) : 0;
  }

  std::vector<TimeEvent> TimeFunction::events(const double begin,
                                              const double end) const
  {
    Assert(std::isfinite(begin) && std::isfinite(end),
           dealii::ExcMessage("Events are sought between finite times."));
    return course && begin < end ? course->events(begin, end)
                                 : std::vector<TimeEvent>();
  }

  std::optional<double> TimeFunction::last_time() const
  {
    return course ? course->last_time() : std::nullopt;
  }

  const std::string &TimeFunction::origin() const
  {
    static const std::string none;
    return course ? course->origin : none;
  }

  double TimeFunction::checked(const double result, const double t) const
  {
    if (!std::isfinite(result))
      {
        std::ostringstream message;
        message.precision(17);
        message << course->origin << " is not a finite number at t = " << t
                << " s (" << result
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
    if (!course)
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
    return !course;
  }
} // namespace auxfem
