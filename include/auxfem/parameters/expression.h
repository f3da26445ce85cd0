#ifndef auxfem_parameters_expression_h
#define auxfem_parameters_expression_h

#include <auxfem/parameters/registry.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <muParser.h>

namespace auxfem
{
  /** A text that is not a valid Expression; what() gives the reason. */
  class ExpressionError : public std::runtime_error
  {
  public:
    ExpressionError(const std::string &problem, const std::string &allowed)
      : std::runtime_error(problem)
      , allowed(allowed)
    {}

    /** Lines with the names and operators that the expression may use. */
    const std::string allowed;
  };

  /**
   * A formula of the user in muParser's syntax. Besides muParser's functions it
   * has `if(condition, then, else)`, `pow`, `floor` and `ceil`; `log` is the
   * natural logarithm. `pi` and the scene's constants are defined. Formulas
   * evaluated item by item also have `random(seed)`, uniform in [0, 1), and
   * `normal(seed)` with mean 0 and standard deviation 1; each item has its own
   * values, whatever the order of evaluation.
   */
  class Expression
  {
  public:
    /** Name and address of a number; it must outlive the formula. */
    using Variable = std::pair<std::string, double *>;
    using Constant = std::pair<std::string, double>;

    /**
     * Throws ExpressionError if @p text is invalid, or if one of @p
     * scene_constants has the name of a variable or of one of @p own_constants.
     * @param item number of the present item, which must outlive the formula;
     * nullptr: no random numbers
     */
    Expression(const std::string           &text,
               const std::vector<Variable> &variables,
               const std::vector<Constant> &own_constants,
               const std::vector<Constant> &scene_constants,
               const unsigned int          *item = nullptr);

    /** Lines with the constants, operators and functions of every formula. */
    static std::string syntax_help();

    /** A value and the hash of the branches taken to compute it. */
    struct BranchedValue
    {
      double        value;
      std::uint64_t branches;
    };

    /** Value at the present values of the variables. */
    double value() const
    {
      return evaluate().value;
    }

    /**
     * value() and a hash of all decisions taken: comparisons, signs in `abs`,
     * choices of `min` and `max`, integers of `floor`, signs of divisors. While
     * the hash stays the same, the formula is smooth.
     */
    BranchedValue evaluate() const;

    /** Whether the formula contains no variable. */
    bool is_constant() const
    {
      return constant;
    }

  private:
    void define_constants(const std::vector<Variable> &variables,
                          const std::vector<Constant> &own_constants,
                          const std::vector<Constant> &scene_constants);
    void parse(const std::string &text);

    mu::Parser parser;
    bool       constant = false;

    const unsigned int *const item;
  };

  /**
   * SI value of a number with or without unit word (`20 mm`), or of an
   * expression of @p constants. Throws InputError for other text.
   */
  double constant_value(const std::string                       &text,
                        const std::vector<Expression::Constant> &constants);
} // namespace auxfem

#endif
