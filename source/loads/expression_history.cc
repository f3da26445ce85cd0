#include <auxfem/loads/event_search.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>

#include <cmath>
#include <sstream>

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
            "100*min(t/0.01, 1), or a table, e.g. table: force.csv (straight "
            "lines between its rows), smooth table: force.csv (a spline) or -2 "
            "kg * table: force.csv.\n" +
            error.allowed +
            "\nWrite a decimal point, not a comma, and * between factors.");
        }
    }

    /** An expression in t. */
    class ExpressionHistory : public TimeHistory
    {
    public:
      ExpressionHistory(const std::string  &text,
                        const std::string  &path,
                        const SceneContext &context)
        : expression(read(text, path, context, time))
      {}

      ExpressionHistory(const ExpressionHistory &)            = delete;
      ExpressionHistory &operator=(const ExpressionHistory &) = delete;

      double value(const double t) const override
      {
        time = t;
        return expression.value();
      }

      double limit(const double t, const TimeSide side) const override
      {
        return auxfem::limit(branched, t, side);
      }

      Jet jet(const double t, const TimeSide side) const override
      {
        if (!cached_jet || cached_jet->time != t || cached_jet->side != side)
          cached_jet = {t, side, jet_estimate(branched, t, side).jet};
        return cached_jet->jet;
      }

      std::vector<TimeEvent>
      events(const double       begin,
             const double       end,
             const unsigned int derivatives) const override
      {
        try
          {
            return find_events(branched, begin, end, derivatives);
          }
        catch (const TooManyJumps &jumps)
          {
            std::ostringstream message;
            message.precision(3);
            message
              << origin << " jumps about " << jumps.n
              << " times or more between t = " << begin << " s and " << end
              << " s, once every " << (end - begin) / jumps.n
              << " s, and a step must end at each jump.\nWrite a function "
                 "without jumps, or with ten thousand jumps at most.";
            throw InputError(message.str());
          }
      }

      bool is_constant() const override
      {
        return expression.is_constant();
      }

      bool is_zero() const
      {
        return expression.is_constant() && expression.value() == 0;
      }

    private:
      struct CachedJet
      {
        double   time;
        TimeSide side;
        Jet      jet;
      };

      mutable double   time = 0; ///< value of `t` in the expression
      Expression       expression;
      BranchedFunction branched = [this](const double t) {
        time = t;
        return expression.evaluate();
      };

      /** The last result, which all iterations of a step need. */
      mutable std::optional<CachedJet> cached_jet;
    };
  } // namespace



  std::shared_ptr<TimeHistory>
  make_expression_history(const std::string  &text,
                          const std::string  &path,
                          const SceneContext &context)
  {
    const auto history =
      std::make_shared<ExpressionHistory>(text, path, context);
    return history->is_zero() ? nullptr : history;
  }
} // namespace auxfem
