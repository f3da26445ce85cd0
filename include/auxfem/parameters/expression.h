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
  /** Why a text is no Expression: what() says it. */
  class ExpressionError : public std::runtime_error
  {
  public:
    ExpressionError(const std::string &problem, const std::string &allowed)
      : std::runtime_error(problem)
      , allowed(allowed)
    {}

    /** Lines with the names and operators that the expression knows. */
    const std::string allowed;
  };

  /**
   * A formula that the user wrote, in muParser's syntax. Besides muParser's own
   * functions it knows `if(condition, then, else)`, `pow`, `floor` and `ceil`;
   * `log` is the natural one. `pi` and the scene's constants are known, too.
   */
  class Expression
  {
  public:
    /** A name for the number at an address, which has to outlive the formula.
     */
    using Variable = std::pair<std::string, double *>;
    using Constant = std::pair<std::string, double>;

    /**
     * Throws ExpressionError if @p text cannot be understood, or if one of
     * @p scene_constants has the name of a variable or of one of
     * @p own_constants.
     */
    Expression(const std::string           &text,
               const std::vector<Variable> &variables,
               const std::vector<Constant> &own_constants,
               const std::vector<Constant> &scene_constants);

    /** Lines with the constants, operators and functions of every formula. */
    static std::string known();

    /** A value and the fingerprint of the branches that led to it. */
    struct BranchedValue
    {
      double        value;
      std::uint64_t branches;
    };

    /** With the variables as they are now. */
    double value() const
    {
      return evaluate().value;
    }

    /**
     * value() and a hash of all decisions on its way: results of comparisons,
     * signs in `abs`, choices of `min` and `max`, integers of `floor`, signs of
     * divisors. Where the hash stays the same the formula is as smooth as its
     * other functions are.
     */
    BranchedValue evaluate() const;

    /** Whether no variable occurs in it. */
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
  };

  /**
   * SI value of a number with or without unit word (`20 mm`), or of an
   * expression of @p constants. Throws InputError for any other text.
   */
  double constant_value(const std::string                       &text,
                        const std::vector<Expression::Constant> &constants);
} // namespace auxfem

#endif
