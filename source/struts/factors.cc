#include <auxfem/struts/factors.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    /** @p value with @p digits significant digits. */
    std::string text_of(const double value, const int digits)
    {
      std::ostringstream text;
      text.precision(digits);
      text << value;
      return text.str();
    }
  } // namespace

  Factors::Factors(const ParameterValues          &values,
                   const Language                 &language,
                   const std::vector<std::string> &allowed)
    : values(values)
    , parameter(language.parameter)
  {
    for (const std::string &text :
         split_string_list(values.text(parameter), ';'))
      {
        const std::size_t colon = text.find(':');
        if (colon == std::string::npos)
          values.refuse(parameter,
                        "\"" + text + "\" has no colon. " + language.advice);
        const std::string name = trim(text.substr(0, colon));
        if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
          values.refuse(parameter,
                        "\"" + name + "\" is no number of this section that " +
                          parameter.name + " can vary. " +
                          (allowed.empty() ? "Choose a shape with dimensions"
                                           : "Allowed: " + joined(allowed)));
        scaled_names.push_back(name);
        try
          {
            expressions.emplace_back(text.substr(colon + 1),
                                     language.variables,
                                     std::vector<Expression::Constant>(),
                                     values.context.constants,
                                     language.item);
          }
        catch (const ExpressionError &error)
          {
            values.refuse(parameter,
                          "cannot understand \"" + text +
                            "\": " + error.what() + ". " + language.advice);
          }
      }
  }

  double Factors::factor(const unsigned int                  i,
                         const std::function<std::string()> &place) const
  {
    const double value = expressions[i].value();
    if (!(value > 0 && std::isfinite(value)))
      values.refuse(parameter,
                    "the factor of " + scaled_names[i] + " is " +
                      text_of(value, 3) + " " + place() +
                      ". It must be positive everywhere");
    return value;
  }

  void set_quantity(const std::string &name,
                    const double       value,
                    ParameterValues   &values)
  {
    values.set(name, text_of(value, std::numeric_limits<double>::max_digits10));
  }

  std::vector<std::string> numbers_among(const Parameters      &parameters,
                                         const ParameterValues &values,
                                         const std::string     &unit)
  {
    std::vector<std::string> names;
    for (const Parameter &parameter : parameters)
      if (parameter.kind == Parameter::Kind::quantity &&
          (unit.empty() || parameter.unit == unit) &&
          !values.is_word(parameter))
        names.push_back(parameter.name);
    return names;
  }

  double quantity_of(const std::string &name, const ParameterValues &values)
  {
    const Parameter *const declared = find_by_name(values.parameters, name);
    return values[Quantity(name,
                           declared->default_value,
                           declared->unit,
                           declared->range,
                           declared->sentence,
                           declared->words)];
  }
} // namespace auxfem
