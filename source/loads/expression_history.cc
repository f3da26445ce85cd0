#include <auxfem/loads/event_search.h>
#include <auxfem/loads/expression_history.h>
#include <auxfem/parameters/errors.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    Expression read(const std::string  &text,
                    const std::string  &path,
                    const SceneContext &context,
                    double             &time)
    {
      try
        {
          return Expression(text, {{"t", &time}}, {}, context.constants);
        }
      catch (const ExpressionError &error)
        {
          throw InputError(
            path + ": cannot understand '" + text + "': " + error.what() +
            "\nAllowed is an expression of the time t (s), e.g. 2e7*t^3 or "
            "100*min(t/0.01, 1), or a table, e.g. table: force.csv.\n" +
            error.allowed +
            "\nWrite a decimal point, not a comma, and * between factors.");
        }
    }
  } // namespace

  ExpressionHistory::ExpressionHistory(const std::string  &text,
                                       const std::string  &path,
                                       const SceneContext &context)
    : expression(read(text, path, context, time))
  {}

  const ExpressionTree &ExpressionHistory::tree() const
  {
    if (!known_tree)
      {
        // It is compiled at the first evaluation.
        expression.value();
        known_tree = std::make_unique<const ExpressionTree>(
          read_expression(expression.compiled()));
      }
    return *known_tree;
  }

  double ExpressionHistory::limit(const double t, const TimeSide side) const
  {
    const Jet<double> here   = tree().result(tree().evaluate(t));
    const Jet<double> result = auxfem::limit(tree(), t, side);

    // At a kink branches differ by the round-off of its time.
    double error = 0;
    for (const double slope : {here.first, result.first})
      if (std::isfinite(slope))
        error += time_resolution(t) * std::abs(slope);
    return std::abs(result.value - here.value) <= error ? value(t)
                                                        : result.value;
  }

  Jet<double> ExpressionHistory::jet(const double t, const TimeSide side) const
  {
    Jet<double> result = auxfem::limit(tree(), t, side);
    result.value       = limit(t, side);
    return result;
  }

  std::vector<TimeEvent>
  ExpressionHistory::events(const double       begin,
                            const double       end,
                            const unsigned int derivatives) const
  {
    return find_events(tree(), begin, end, derivatives);
  }
} // namespace auxfem
