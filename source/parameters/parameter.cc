#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using Kind = Parameter::Kind;
    using dealii::Utilities::trim;

    std::string exact_text(const double value)
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

    std::string out_of_range(const Parameter   &parameter,
                             const std::string &item,
                             const double       value)
    {
      // The number is repeated only if a unit word changes it.
      const bool converted = !split_quantity(item).unit.empty();
      return "\"" + item + "\"" +
        (converted ? " (" + short_text(value) +
             (parameter.unit == "1" ? "" : " " + parameter.unit) + ")"
                   : "") +
        " is out of range";
    }

    std::string quantity_problem(const Parameter   &parameter,
                                 const std::string &item)
    {
      try
        {
          const ParsedQuantity parsed = split_quantity(item);
          // A number without conversion is exact at the bounds.
          const double value =
            (parsed.unit.empty() ? parsed.number
                                 : parse_quantity(item, parameter.unit) /
                 parse_unit(parameter.unit).factor);
          return parameter.range.contains(value)
            ? ""
            : out_of_range(parameter, item, value);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
    }

    std::string list_problem(const Parameter   &parameter,
                             const std::string &value)
    {
      const std::vector<std::string> items = split_quantity_list(value);
      for (const std::string &item : items)
        {
          const std::string problem = quantity_problem(parameter, item);
          if (!problem.empty())
            return problem;
        }
      if (items.size() < parameter.minimum_length ||
          items.size() > parameter.maximum_length)
        return "it has " + std::to_string(items.size()) +
          (items.size() == 1 ? " number" : " numbers");
      return "";
    }

    std::string integer_problem(const Parameter   &parameter,
                                const std::string &value)
    {
      long long  number = 0;
      const auto answer =
        std::from_chars(value.data(), value.data() + value.size(), number);
      if (answer.ec != std::errc() || answer.ptr != value.data() + value.size())
        return "\"" + value + "\" is not a whole number";
      return parameter.range.contains(static_cast<double>(number))
        ? ""
        : "\"" + value + "\" is out of range";
    }

    std::string choice_problem(const Parameter   &parameter,
                               const std::string &value)
    {
      if (parameter.is_word(value))
        return "";
      const std::vector<std::string> near =
        nearest_names(value, parameter.words);
      return "\"" + value + "\" is not among the choices" +
        (near.empty() ? "" : " (did you mean " + joined(near) + "?)");
    }

    std::string time_problem(const Parameter   &parameter,
                             const std::string &value)
    {
      if (value.find("table:") != std::string::npos)
        return ""; // the scale may have a unit
      std::string unit;
      try
        {
          unit = split_quantity(value).unit;
        }
      catch (const InputError &)
        {
          return ""; // an expression or a table
        }
      if (unit.empty() || !std::isalpha(static_cast<unsigned char>(unit[0])))
        return ""; // a plain number or an expression
      const std::string problem = quantity_problem(parameter, value);
      return problem.empty()
        ? ""
        : problem + " (in an expression, write products with *)";
    }

    std::string number_phrase(const Parameter   &parameter,
                              const std::string &noun)
    {
      const std::string range = parameter.range.text();
      return noun + (range.empty() ? "" : " " + range) +
        (parameter.unit == "1" ? "" : " in " + parameter.unit);
    }

    std::string words_before(const Parameter &parameter)
    {
      return parameter.words.empty() ? "" : joined(parameter.words) + ", or ";
    }

    std::string list_phrase(const Parameter &parameter)
    {
      const std::string least     = std::to_string(parameter.minimum_length);
      const std::string most      = std::to_string(parameter.maximum_length);
      const bool        unlimited = parameter.maximum_length > 100000;
      const bool        adjacent =
        parameter.maximum_length == parameter.minimum_length + 1;
      const std::string count =
        (least == most ? least
           : unlimited ? least + " or more"
                       : least + (adjacent ? " or " : " to ") + most);
      return words_before(parameter) +
        number_phrase(parameter, count + " numbers");
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



  bool Parameter::is_word(const std::string &value) const
  {
    return std::find(words.begin(), words.end(), trim(value)) != words.end();
  }



  std::string Parameter::problem(const std::string &text) const
  {
    const std::string value = trim(text);
    if (value.empty())
      return default_value.empty() ? "" : "there is no value";
    if (is_word(value))
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



  std::string Parameter::allowed() const
  {
    switch (kind)
      {
        case Kind::quantity:
          return words_before(*this) + number_phrase(*this, "a number");
        case Kind::quantity_list:
          return list_phrase(*this);
        case Kind::integer:
          return words_before(*this) + "a whole number " + range.text();
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



  std::string Parameter::allowed_with_units() const
  {
    const bool has_unit =
      (kind == Kind::quantity || kind == Kind::quantity_list ||
       kind == Kind::time_expression);
    return allowed() +
      (has_unit && unit != "1"
         ? "; unit words allowed: " + joined(fitting_units(unit), 12)
         : "");
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



  bool Range::contains(const double value) const
  {
    return (minimum_open ? value > minimum : value >= minimum) &&
      (maximum_open ? value < maximum : value <= maximum);
  }



  std::string Range::text() const
  {
    constexpr double   infinity = std::numeric_limits<double>::infinity();
    std::ostringstream out;
    // Digits for every unsigned int.
    out.precision(10);
    if (minimum > -infinity)
      out << (minimum_open ? "> " : ">= ") << minimum;
    if (minimum > -infinity && maximum < infinity)
      out << " and ";
    if (maximum < infinity)
      out << (maximum_open ? "< " : "<= ") << maximum;
    return out.str();
  }



  Quantity::Quantity(const std::string              &name,
                     const std::string              &default_value,
                     const std::string              &unit,
                     const Range                    &range,
                     const std::string              &sentence,
                     const std::vector<std::string> &words)
    : Parameter{name,
                default_value,
                sentence,
                Kind::quantity,
                unit,
                range,
                words,
                default_value.empty()}
  {}



  double Quantity::value(const std::string &text) const
  {
    return parse_quantity(text, unit);
  }



  QuantityList::QuantityList(const std::string              &name,
                             const std::string              &default_value,
                             const std::string              &unit,
                             const Range                    &range,
                             const unsigned int              minimum_length,
                             const unsigned int              maximum_length,
                             const std::string              &sentence,
                             const std::vector<std::string> &words)
    : Parameter{name,
                default_value,
                sentence,
                Kind::quantity_list,
                unit,
                range,
                words,
                default_value.empty() && minimum_length > 0,
                minimum_length,
                maximum_length}
  {}



  std::vector<double> QuantityList::value(const std::string &text) const
  {
    std::vector<double> result;
    for (const std::string &item : split_quantity_list(text))
      result.push_back(parse_quantity(item, unit));
    return result;
  }



  Integer::Integer(const std::string              &name,
                   const unsigned int              default_value,
                   const unsigned int              minimum,
                   const unsigned int              maximum,
                   const std::string              &sentence,
                   const std::vector<std::string> &words)
    : Integer(name,
              std::to_string(default_value),
              minimum,
              maximum,
              sentence,
              words)
  {}



  Integer::Integer(const std::string              &name,
                   const std::string              &default_word,
                   const unsigned int              minimum,
                   const unsigned int              maximum,
                   const std::string              &sentence,
                   const std::vector<std::string> &words)
    : Parameter{name,
                default_word,
                sentence,
                Kind::integer,
                "1",
                Range::closed(minimum, maximum),
                words}
  {}



  unsigned int Integer::value(const std::string &text) const
  {
    return static_cast<unsigned int>(std::stoul(text));
  }



  Boolean::Boolean(const std::string &name,
                   const bool         default_value,
                   const std::string &sentence)
    : Parameter{name,
                default_value ? "true" : "false",
                sentence,
                Kind::choice,
                "1",
                Range::any(),
                {"true", "false"}}
  {}



  Choice::Choice(const std::string              &name,
                 const std::string              &default_value,
                 const std::vector<std::string> &choices,
                 const std::string              &sentence)
    : Parameter{name,
                default_value,
                sentence,
                Kind::choice,
                "1",
                Range::any(),
                choices,
                default_value.empty()}
  {}



  Text::Text(const std::string &name,
             const std::string &default_value,
             const std::string &sentence,
             const bool         required)
    : Parameter{name,
                default_value,
                sentence,
                Kind::text,
                "1",
                Range::any(),
                {},
                required}
  {}



  TimeExpression::TimeExpression(const std::string              &name,
                                 const std::string              &default_value,
                                 const std::string              &unit,
                                 const std::string              &sentence,
                                 const std::vector<std::string> &words)
    : Parameter{name,
                default_value,
                sentence,
                Kind::time_expression,
                unit,
                Range::any(),
                words,
                default_value.empty()}
  {}



  std::string TimeExpression::value(const std::string &text) const
  {
    if (is_word(text))
      return text;
    // Only a number with a unit word is converted, and only such a text is a
    // quantity as a whole.
    try
      {
        const ParsedQuantity parsed = split_quantity(text);
        if (parsed.unit.empty() || parsed.unit[0] == '/')
          return text;
        return exact_text(parse_quantity(text, unit));
      }
    catch (const InputError &)
      {
        return text;
      }
  }
} // namespace auxfem
