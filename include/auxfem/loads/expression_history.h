#ifndef auxfem_loads_expression_history_h
#define auxfem_loads_expression_history_h

#include <auxfem/loads/expression_tree.h>
#include <auxfem/loads/time_history.h>
#include <auxfem/parameters/expression.h>

#include <memory>
#include <string>

namespace auxfem
{
  /** An expression in t. */
  class ExpressionHistory : public TimeHistory
  {
  public:
    /**
     * @param text what the user wrote, @param path of the parameter. Throws
     * InputError if it is no expression.
     */
    ExpressionHistory(const std::string  &text,
                      const std::string  &path,
                      const SceneContext &context);

    double value(const double t) const override
    {
      time = t;
      return expression.value();
    }

    double limit(double t, TimeSide side) const override;

    Jet<double> jet(double t, TimeSide side) const override;

    std::vector<TimeEvent>
    events(double begin, double end, unsigned int derivatives) const override;

    /** Whether `t` does not occur in it. */
    bool is_constant() const
    {
      return expression.is_constant();
    }

  private:
    const ExpressionTree &tree() const;

    mutable double time = 0; ///< where the expression finds `t`
    Expression     expression;

    /** Made when it is needed first: most functions are only evaluated. */
    mutable std::unique_ptr<const ExpressionTree> known_tree;
  };
} // namespace auxfem

#endif
