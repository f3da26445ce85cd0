#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/suggest.h>
#include <auxfem/parameters/value_pattern.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using Kind = ValueRule::Kind;
    using dealii::Utilities::trim;

    const std::string description_start = "[auxfem|";

    std::string number_text(const double value)
    {
      std::ostringstream out;
      out.precision(17);
      out << value;
      return out.str();
    }

    std::string short_text(const double value)
    {
      std::ostringstream out;
      out << value;
      return out.str();
    }

    std::string out_of_range(const ValueRule   &rule,
                             const std::string &item,
                             const double       value)
    {
      // the number is repeated only where a unit word has changed it
      const bool converted = !split_quantity(item).unit.empty();
      return "\"" + item + "\"" +
        (converted ? " (" + short_text(value) +
             (rule.unit == "1" ? "" : " " + rule.unit) + ")"
                   : "") +
        " is out of range";
    }

    std::string quantity_problem(const ValueRule &rule, const std::string &item)
    {
      try
        {
          const ParsedQuantity parsed = split_quantity(item);
          // exact at the bounds unless a conversion is needed
          const double value =
            (parsed.unit.empty() ? parsed.number
                                 : parse_quantity(item, rule.unit) /
                 parse_unit(rule.unit).factor);
          return rule.range.contains(value) ? ""
                                            : out_of_range(rule, item, value);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
    }

    std::string list_problem(const ValueRule &rule, const std::string &value)
    {
      const std::vector<std::string> items = split_quantity_list(value);
      for (const std::string &item : items)
        {
          const std::string problem = quantity_problem(rule, item);
          if (!problem.empty())
            return problem;
        }
      if (items.size() < rule.minimum_length ||
          items.size() > rule.maximum_length)
        return "it has " + std::to_string(items.size()) +
          (items.size() == 1 ? " number" : " numbers");
      return "";
    }

    std::string integer_problem(const ValueRule &rule, const std::string &value)
    {
      long long  number = 0;
      const auto answer =
        std::from_chars(value.data(), value.data() + value.size(), number);
      if (answer.ec != std::errc() || answer.ptr != value.data() + value.size())
        return "\"" + value + "\" is not a whole number";
      return rule.range.contains(static_cast<double>(number))
        ? ""
        : "\"" + value + "\" is out of range";
    }

    std::string choice_problem(const ValueRule &rule, const std::string &value)
    {
      if (rule.is_word(value))
        return "";
      const std::vector<std::string> near = nearest_names(value, rule.words);
      return "\"" + value + "\" is not among the choices" +
        (near.empty() ? "" : " (did you mean " + joined(near) + "?)");
    }

    std::string time_problem(const ValueRule &rule, const std::string &value)
    {
      std::string unit;
      try
        {
          unit = split_quantity(value).unit;
        }
      catch (const InputError &)
        {
          return ""; // no number in front: an expression or a table
        }
      if (unit.empty() || !std::isalpha(static_cast<unsigned char>(unit[0])))
        return ""; // a plain number, or an operator that goes on with it
      const std::string problem = quantity_problem(rule, value);
      return problem.empty()
        ? ""
        : problem + " (in an expression, write products with *)";
    }

    std::string number_phrase(const ValueRule &rule, const std::string &what)
    {
      const std::string range = rule.range.text();
      return what + (range.empty() ? "" : " " + range) +
        (rule.unit == "1" ? "" : " in " + rule.unit);
    }

    std::string words_before(const ValueRule &rule)
    {
      return rule.words.empty() ? "" : joined(rule.words) + ", or ";
    }

    std::string list_phrase(const ValueRule &rule)
    {
      const std::string least     = std::to_string(rule.minimum_length);
      const std::string most      = std::to_string(rule.maximum_length);
      const bool        unlimited = rule.maximum_length > 100000;
      const bool adjacent = rule.maximum_length == rule.minimum_length + 1;
      const std::string count =
        (least == most ? least
           : unlimited ? least + " or more"
                       : least + (adjacent ? " or " : " to ") + most);
      return words_before(rule) + number_phrase(rule, count + " numbers");
    }
  } // namespace



  std::string joined(const std::vector<std::string> &items,
                     const std::size_t               maximum)
  {
    std::string text;
    for (std::size_t i = 0; i < std::min(items.size(), maximum); ++i)
      text += (i == 0 ? "" : ", ") + items[i];
    return items.size() > maximum ? text + ", ..." : text;
  }



  bool ValueRule::is_word(const std::string &value) const
  {
    return std::find(words.begin(), words.end(), trim(value)) != words.end();
  }



  std::string ValueRule::problem(const std::string &untrimmed) const
  {
    const std::string value = trim(untrimmed);
    if (value.empty() || is_word(value))
      return "";
    switch (kind)
      {
        case Kind::quantity:
          return quantity_problem(*this, value);
        case Kind::quantity_list:
          return list_problem(*this, value);
        case Kind::integer:
          return integer_problem(*this, value);
        case Kind::choice:
          return choice_problem(*this, value);
        case Kind::time_expression:
          return time_problem(*this, value);
        case Kind::text:
          break;
      }
    return "";
  }



  std::string ValueRule::allowed() const
  {
    switch (kind)
      {
        case Kind::quantity:
          return words_before(*this) + number_phrase(*this, "a number");
        case Kind::quantity_list:
          return list_phrase(*this);
        case Kind::integer:
          return "a whole number " + range.text();
        case Kind::choice:
          return "one of " + joined(words);
        case Kind::time_expression:
          return words_before(*this) + "an expression in t or \"table: FILE\"" +
            (unit == "1" ? "" : " in SI") + ", or a number in " + unit;
        case Kind::text:
          break;
      }
    return "text";
  }



  std::string ValueRule::allowed_with_units() const
  {
    const bool has_unit =
      (kind == Kind::quantity || kind == Kind::quantity_list ||
       kind == Kind::time_expression);
    return allowed() +
      (has_unit && unit != "1"
         ? "; unit words allowed: " + joined(fitting_units(unit), 12)
         : "");
  }



  ValuePattern::ValuePattern(const ValueRule &rule) : rule(rule)
  {}



  bool ValuePattern::match(const std::string &value) const
  {
    return rule.problem(value).empty();
  }



  std::string ValuePattern::description(const OutputStyle style) const
  {
    if (style != Machine)
      return rule.allowed();
    std::string text = description_start;
    for (const std::string &field :
         {std::to_string(static_cast<int>(rule.kind)),
          rule.unit,
          number_text(rule.range.minimum),
          number_text(rule.range.maximum),
          std::to_string(rule.range.minimum_open),
          std::to_string(rule.range.maximum_open),
          std::to_string(rule.minimum_length),
          std::to_string(rule.maximum_length),
          std::to_string(rule.required)})
      text += field + "|";
    for (const std::string &word : rule.words)
      text += word + "|";
    return text + "]";
  }



  std::unique_ptr<dealii::Patterns::PatternBase> ValuePattern::clone() const
  {
    return std::make_unique<ValuePattern>(rule);
  }



  std::optional<ValueRule> rule_from_description(const std::string &description)
  {
    if (description.compare(0, description_start.size(), description_start) !=
        0)
      return {};
    const std::vector<std::string> fields =
      dealii::Utilities::split_string_list(description.substr(
                                             description_start.size()),
                                           '|');
    // nine fields, any number of words, the closing bracket
    AssertThrow(fields.size() >= 10, dealii::ExcInternalError());
    ValueRule rule;
    rule.kind               = static_cast<Kind>(std::stoi(fields[0]));
    rule.unit               = fields[1];
    rule.range.minimum      = std::stod(fields[2]);
    rule.range.maximum      = std::stod(fields[3]);
    rule.range.minimum_open = (fields[4] == "1");
    rule.range.maximum_open = (fields[5] == "1");
    rule.minimum_length     = std::stoul(fields[6]);
    rule.maximum_length     = std::stoul(fields[7]);
    rule.required           = (fields[8] == "1");
    rule.words.assign(fields.begin() + 9, fields.end() - 1);
    return rule;
  }
} // namespace auxfem
