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

    /** The straight line of TimeFunction::line(). */
    class Line : public TimeHistory
    {
    public:
      Line(const double at_zero, const double at_one)
        : at_zero(at_zero)
        , slope(at_one - at_zero)
      {}

      double value(const double t) const override
      {
        return at_zero + t * slope;
      }

      double limit(const double t, const TimeSide /*side*/) const override
      {
        return value(t);
      }

      Jet jet(const double t, const TimeSide /*side*/) const override
      {
        return {value(t), slope, 0.};
      }

      std::vector<TimeEvent> events(double /*begin*/,
                                    double /*end*/,
                                    unsigned int /*derivatives*/) const override
      {
        return {};
      }

    private:
      const double at_zero, slope;
    };

    /** See TimeFunction::scaled(). */
    class Scaled : public TimeHistory
    {
    public:
      Scaled(const std::shared_ptr<const TimeHistory> &base,
             const double                              factor)
        : base(base)
        , factor(factor)
      {
        origin = base->origin;
        scale  = factor * base->scale;
      }

      double value(const double t) const override
      {
        return factor * base->value(t);
      }

      double limit(const double t, const TimeSide side) const override
      {
        return factor * base->limit(t, side);
      }

      Jet jet(const double t, const TimeSide side) const override
      {
        const Jet jet = base->jet(t, side);
        return {factor * jet.value, factor * jet.first, factor * jet.second};
      }

      std::vector<TimeEvent>
      events(const double       begin,
             const double       end,
             const unsigned int derivatives) const override
      {
        return base->events(begin, end, derivatives);
      }

      std::optional<double> first_time() const override
      {
        return base->first_time();
      }

      std::optional<double> last_time() const override
      {
        return base->last_time();
      }

      std::optional<Overshoot> overshoot() const override
      {
        std::optional<Overshoot> overshoot = base->overshoot();
        if (overshoot)
          overshoot->amount *= factor;
        return overshoot;
      }

      bool is_constant() const override
      {
        return base->is_constant();
      }

    private:
      const std::shared_ptr<const TimeHistory> base;
      const double                             factor;
    };
  } // namespace

  std::optional<TableText> table_text(const std::string &text)
  {
    const std::string table = "table:", smooth = "smooth";
    const std::size_t at = text.find(table);
    if (at == std::string::npos)
      return {};
    const std::size_t file = at + table.size();
    TableText         parts{trim(text.substr(0, file)),
                    trim(text.substr(0, at)),
                    TableKind::linear,
                    trim(text.substr(file))};
    std::string      &scale = parts.scale;
    if (scale.size() >= smooth.size() &&
        scale.compare(scale.size() - smooth.size(), smooth.size(), smooth) == 0)
      {
        parts.kind = TableKind::smooth;
        scale      = trim(scale.substr(0, scale.size() - smooth.size()));
      }
    if (scale.empty())
      return parts;
    if (scale.back() != '*')
      return {};
    scale = trim(scale.substr(0, scale.size() - 1));
    return scale.empty() ? std::nullopt : std::optional(parts);
  }

  TimeFunction::TimeFunction(const std::string  &text,
                             const std::string  &parameter,
                             const SceneContext &context)
  {
    const std::string trimmed = trim(text);
    if (trimmed.empty())
      return;

    const std::string path =
      (context.path.empty() ? "" : context.path + "/") + parameter;
    const auto table    = table_text(trimmed);
    const auto function = table
      ? make_table_history(*table, path, context)
      : make_expression_history(trimmed, path, context);
    if (!function)
      return;
    function->origin = path + ": '" + trimmed + "'";
    history          = function;
  }

  TimeFunction TimeFunction::line(const double       at_zero,
                                  const double       at_one,
                                  const std::string &origin)
  {
    TimeFunction line;
    if (at_zero == 0 && at_one == 0)
      return line;
    const auto function = std::make_shared<Line>(at_zero, at_one);
    function->origin    = origin;
    line.history        = function;
    return line;
  }

  double TimeFunction::as_written(const double value) const
  {
    return history ? value / history->scale : value;
  }

  TimeFunction TimeFunction::scaled(const double factor) const
  {
    TimeFunction result;
    if (history && factor != 0)
      result.history = std::make_shared<Scaled>(history, factor);
    return result;
  }

  double TimeFunction::value(const double t) const
  {
    return history ? checked(history->value(t), t) : 0;
  }

  double TimeFunction::value_before(const double t) const
  {
    return history ? checked(history->limit(t, TimeSide::before), t) : 0;
  }

  double TimeFunction::value_after(const double t) const
  {
    return history ? checked(history->limit(t, TimeSide::after), t) : 0;
  }

  std::vector<TimeEvent>
  TimeFunction::events(const double       begin,
                       const double       end,
                       const unsigned int derivatives) const
  {
    Assert(std::isfinite(begin) && std::isfinite(end),
           dealii::ExcMessage("Events are sought between finite times."));
    return history && begin < end ? history->events(begin, end, derivatives)
                                  : std::vector<TimeEvent>();
  }

  std::optional<double> TimeFunction::first_time() const
  {
    return history ? history->first_time() : std::nullopt;
  }

  std::optional<double> TimeFunction::last_time() const
  {
    return history ? history->last_time() : std::nullopt;
  }

  std::optional<Overshoot> TimeFunction::overshoot() const
  {
    return history ? history->overshoot() : std::nullopt;
  }

  const std::string &TimeFunction::origin() const
  {
    static const std::string none;
    return history ? history->origin : none;
  }

  double TimeFunction::checked(const double       result,
                               const double       t,
                               const std::string &quantity) const
  {
    if (!std::isfinite(result))
      {
        std::ostringstream message;
        message.precision(17);
        message << history->origin << (quantity.empty() ? "" : ": " + quantity)
                << " is not a finite number at t = " << t << " s (" << result
                << ").\nLook for a division by zero, or a root or logarithm "
                   "of "
                << (quantity.empty() ? "a negative number" : "zero")
                << ", at that time.";
        throw ComputationError(message.str());
      }
    return result;
  }

  std::array<double, 3> TimeFunction::jet(const double   t,
                                          const TimeSide side) const
  {
    if (!history)
      return {{0, 0, 0}};
    const Jet jet = history->jet(t, side);
    return {{checked(jet.value, t),
             checked(jet.first, t, "the first derivative"),
             checked(jet.second, t, "the second derivative")}};
  }

  bool TimeFunction::is_constant() const
  {
    return !history || history->is_constant();
  }
} // namespace auxfem
