#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/value_pattern.h>

#include <deal.II/base/utilities.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    using Kind = ValueRule::Kind;
    using dealii::Utilities::trim;

    ValueRule rule_of(const Quantity &entry)
    {
      return {Kind::quantity,
              entry.unit,
              entry.range,
              entry.words,
              0,
              0,
              entry.default_value.empty()};
    }

    ValueRule rule_of(const QuantityList &entry)
    {
      return {Kind::quantity_list,
              entry.unit,
              entry.range,
              entry.words,
              entry.minimum_length,
              entry.maximum_length,
              entry.default_value.empty() && entry.minimum_length > 0};
    }

    ValueRule rule_of(const Integer &entry)
    {
      return {Kind::integer, "1", Range::closed(entry.minimum, entry.maximum)};
    }

    ValueRule rule_of(const Boolean &)
    {
      return {Kind::choice, "1", Range::any(), {"true", "false"}};
    }

    ValueRule rule_of(const Choice &entry)
    {
      return {Kind::choice,
              "1",
              Range::any(),
              entry.choices,
              0,
              0,
              entry.default_value.empty()};
    }

    ValueRule rule_of(const Text &entry)
    {
      return {Kind::text, "1", Range::any(), {}, 0, 0, entry.required};
    }

    ValueRule rule_of(const TimeExpression &entry)
    {
      return {Kind::time_expression,
              entry.unit,
              Range::any(),
              entry.words,
              0,
              0,
              entry.default_value.empty()};
    }

    /** The reference cuts the documentation at its first line break again. */
    void declare_entry(dealii::ParameterHandler &prm,
                       const std::string        &name,
                       const std::string        &default_value,
                       const ValueRule          &rule,
                       const std::string        &sentence)
    {
      const std::string allowed =
        (rule.kind == Kind::text ? "" : "\nAllowed: " + rule.allowed() + ".");
      prm.declare_entry(name,
                        default_value,
                        ValuePattern(rule),
                        sentence + allowed);
    }

    /** The text of an entry, checked. */
    template <class Entry>
    std::string checked_text(dealii::ParameterHandler &prm, const Entry &entry)
    {
      const std::string value   = trim(prm.get(entry.name));
      const ValueRule   rule    = rule_of(entry);
      const std::string problem = rule.problem(value);
      if (!problem.empty())
        throw InputError(entry.name + ": " + problem +
                         "; allowed: " + rule.allowed_with_units());
      if (rule.required && value.empty())
        throw InputError(entry.name +
                         " must be given: " + rule.allowed_with_units());
      return value;
    }

    /** checked_text() of an entry that is needed as a number. */
    template <class Entry>
    std::string number_text(dealii::ParameterHandler &prm, const Entry &entry)
    {
      const std::string value = checked_text(prm, entry);
      if (rule_of(entry).is_word(value))
        throw InputError(entry.name + ": \"" + value +
                         "\" stands where a number is needed");
      return value;
    }

    std::string exact_text(const double value)
    {
      std::ostringstream out;
      out.precision(17);
      out << value;
      return out.str();
    }
  } // namespace



  Range Range::any()
  {
    return {};
  }



  Range Range::positive()
  {
    Range range        = non_negative();
    range.minimum_open = true;
    return range;
  }



  Range Range::non_negative()
  {
    Range range;
    range.minimum = 0;
    return range;
  }



  Range Range::closed(const double minimum, const double maximum)
  {
    return {minimum, maximum, false, false};
  }



  Range Range::open(const double minimum, const double maximum)
  {
    return {minimum, maximum, true, true};
  }



  bool Range::contains(const double value) const
  {
    return (minimum_open ? value > minimum : value >= minimum) &&
      (maximum_open ? value < maximum : value <= maximum);
  }



  std::string Range::text() const
  {
    constexpr double   infinity = std::numeric_limits<double>::infinity();
    std::ostringstream out;
    // enough digits for every whole number an unsigned int holds
    out.precision(10);
    if (minimum > -infinity)
      out << (minimum_open ? "> " : ">= ") << minimum;
    if (minimum > -infinity && maximum < infinity)
      out << " and ";
    if (maximum < infinity)
      out << (maximum_open ? "< " : "<= ") << maximum;
    return out.str();
  }



  void declare(dealii::ParameterHandler &prm, const Quantity &entry)
  {
    declare_entry(prm,
                  entry.name,
                  entry.default_value,
                  rule_of(entry),
                  entry.sentence);
  }



  void declare(dealii::ParameterHandler &prm, const QuantityList &entry)
  {
    declare_entry(prm,
                  entry.name,
                  entry.default_value,
                  rule_of(entry),
                  entry.sentence);
  }



  void declare(dealii::ParameterHandler &prm, const Integer &entry)
  {
    declare_entry(prm,
                  entry.name,
                  std::to_string(entry.default_value),
                  rule_of(entry),
                  entry.sentence);
  }



  void declare(dealii::ParameterHandler &prm, const Boolean &entry)
  {
    declare_entry(prm,
                  entry.name,
                  entry.default_value ? "true" : "false",
                  rule_of(entry),
                  entry.sentence);
  }



  void declare(dealii::ParameterHandler &prm, const Choice &entry)
  {
    declare_entry(prm,
                  entry.name,
                  entry.default_value,
                  rule_of(entry),
                  entry.sentence);
  }



  void declare(dealii::ParameterHandler &prm, const Text &entry)
  {
    declare_entry(prm,
                  entry.name,
                  entry.default_value,
                  rule_of(entry),
                  entry.sentence);
  }



  void declare(dealii::ParameterHandler &prm, const TimeExpression &entry)
  {
    declare_entry(prm,
                  entry.name,
                  entry.default_value,
                  rule_of(entry),
                  entry.sentence);
  }



  double get(dealii::ParameterHandler &prm, const Quantity &entry)
  {
    return parse_quantity(number_text(prm, entry), entry.unit);
  }



  std::vector<double> get(dealii::ParameterHandler &prm,
                          const QuantityList       &entry)
  {
    std::vector<double> result;
    for (const std::string &item : split_quantity_list(number_text(prm, entry)))
      result.push_back(parse_quantity(item, entry.unit));
    return result;
  }



  unsigned int get(dealii::ParameterHandler &prm, const Integer &entry)
  {
    const std::string value = checked_text(prm, entry);
    if (value.empty())
      throw InputError(entry.name + " must not be empty");
    return static_cast<unsigned int>(std::stoul(value));
  }



  bool get(dealii::ParameterHandler &prm, const Boolean &entry)
  {
    const std::string value = checked_text(prm, entry);
    if (value.empty())
      throw InputError(entry.name + " must not be empty");
    return value == "true";
  }



  std::string get(dealii::ParameterHandler &prm, const Choice &entry)
  {
    return checked_text(prm, entry);
  }



  std::string get(dealii::ParameterHandler &prm, const Text &entry)
  {
    return checked_text(prm, entry);
  }



  std::string get(dealii::ParameterHandler &prm, const TimeExpression &entry)
  {
    const std::string value = checked_text(prm, entry);
    const ValueRule   rule  = rule_of(entry);
    if (rule.is_word(value))
      return value;
    // only a number with a unit word depends on units, and only such a text
    // is a quantity as a whole
    try
      {
        const ParsedQuantity parsed = split_quantity(value);
        if (parsed.unit.empty() || parsed.unit[0] == '/')
          return value;
        return exact_text(parse_quantity(value, entry.unit));
      }
    catch (const InputError &)
      {
        return value;
      }
  }



  bool is_word(dealii::ParameterHandler &prm, const Quantity &entry)
  {
    return rule_of(entry).is_word(checked_text(prm, entry));
  }



  bool is_word(dealii::ParameterHandler &prm, const QuantityList &entry)
  {
    return rule_of(entry).is_word(checked_text(prm, entry));
  }



  bool is_word(dealii::ParameterHandler &prm, const TimeExpression &entry)
  {
    return rule_of(entry).is_word(checked_text(prm, entry));
  }
} // namespace auxfem
