#ifndef auxfem_struts_factors_h
#define auxfem_struts_factors_h

#include <auxfem/parameters/expression.h>

#include <functional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Factors on numbers of a section: `NAME: EXPRESSION; ...`. */
  class Factors
  {
  public:
    /** Names that expressions of a parameter may use, and advice. */
    struct Language
    {
      const Parameter                  &parameter;
      std::vector<Expression::Variable> variables;
      /** Number of the present item; see Expression. */
      const unsigned int *item = nullptr;
      std::string         advice; ///< last sentence of messages
    };

    /**
     * Reads the value of the parameter. Throws InputError for texts that are
     * no list of factors and for names that are not @p allowed.
     */
    Factors(const ParameterValues          &values,
            const Language                 &language,
            const std::vector<std::string> &allowed);

    /** Names of the numbers that have a factor. */
    const std::vector<std::string> &names() const
    {
      return scaled_names;
    }

    /** The factor @p i of names() at the present values of the variables.
     * Throws InputError if it is not positive; @p place then describes these
     * values. */
    double factor(unsigned int                        i,
                  const std::function<std::string()> &place) const;

  private:
    const ParameterValues    values;
    const Parameter         &parameter;
    std::vector<std::string> scaled_names;
    std::vector<Expression>  expressions;
  };

  /** Sets the quantity @p name of @p values to @p value (SI). */
  void
  set_quantity(const std::string &name, double value, ParameterValues &values);

  /** Names of the quantities among @p parameters that have a number in @p
   * values; of the lengths alone if @p unit is `m`. */
  std::vector<std::string> numbers_among(const Parameters      &parameters,
                                         const ParameterValues &values,
                                         const std::string     &unit = "");

  /** The quantity @p name of @p values (SI). */
  double quantity_of(const std::string &name, const ParameterValues &values);
} // namespace auxfem

#endif
