#ifndef auxfem_parameters_value_pattern_h
#define auxfem_parameters_value_pattern_h

#include <auxfem/parameters/declare.h>

#include <deal.II/base/patterns.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** What the text of a parameter may be. */
  struct ValueRule
  {
    enum class Kind
    {
      quantity,
      quantity_list,
      integer,
      choice,
      text,
      time_expression
    };

    Kind        kind = Kind::text;
    std::string unit = "1";
    Range       range;
    /** Words allowed besides a number, or the choices. */
    std::vector<std::string> words          = {};
    unsigned int             minimum_length = 0;
    unsigned int             maximum_length = 0;
    /** The default is empty and the user must give a value. */
    bool required = false;

    /**
     * What is wrong with @p value, a clause for an error message; empty if
     * nothing is. The empty value counts as "not given" and is not wrong.
     */
    std::string problem(const std::string &value) const;

    /** What is allowed, e.g. `a number > 0 in m`. */
    std::string allowed() const;

    /** allowed(), followed by unit words that may be used. */
    std::string allowed_with_units() const;

    bool is_word(const std::string &value) const;
  };

  /**
   * A ValueRule as a pattern of deal.II's ParameterHandler. Its description
   * holds the whole rule, so that rule_from_description() restores it from
   * what ParameterHandler gives out.
   */
  class ValuePattern : public dealii::Patterns::PatternBase
  {
  public:
    explicit ValuePattern(const ValueRule &rule);

    bool        match(const std::string &value) const override;
    std::string description(const OutputStyle style = Machine) const override;
    std::unique_ptr<PatternBase> clone() const override;

  private:
    const ValueRule rule;
  };

  /** The rule in a ValuePattern's description; nothing for other patterns. */
  std::optional<ValueRule>
  rule_from_description(const std::string &description);

  /** Items joined by `, `; after @p maximum of them `, ...`. */
  std::string joined(const std::vector<std::string> &items,
                     std::size_t                     maximum = 1000);
} // namespace auxfem

#endif
