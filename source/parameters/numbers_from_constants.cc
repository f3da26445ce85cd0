#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/parameter.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/text.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <optional>

namespace auxfem
{
  namespace
  {
    using Constants = std::vector<std::pair<std::string, double>>;

    /** Value of an expression of @p constants; none if it is no such thing. */
    std::optional<double> value_of(const std::string &expression,
                                   const Constants   &constants)
    {
      try
        {
          const double value =
            Expression(expression, {}, {}, constants).value();
          return std::isfinite(value) ? std::optional<double>(value)
                                      : std::nullopt;
        }
      catch (const ExpressionError &)
        {
          return {};
        }
    }

    /** All digits of @p value, with its SI unit where @p unit measures
     * something. */
    std::string si_quantity(const double value, const std::string &unit)
    {
      constexpr int     n_digits = 17;
      const std::string word     = si_unit(unit);
      return number_text(value, n_digits) + (word.empty() ? "" : " " + word);
    }

    bool are_quantities(const std::string &text, const std::string &unit)
    {
      try
        {
          for (const std::string &item : split_quantity_list(text))
            parse_quantity(item, unit);
          return true;
        }
      catch (const InputError &)
        {
          return false;
        }
    }

    std::string list_with_constants(const Parameter   &parameter,
                                    const std::string &text,
                                    const Constants   &constants)
    {
      std::vector<std::string> items;
      for (const std::string &item :
           dealii::Utilities::split_string_list(text, ','))
        {
          const auto value = are_quantities(item, parameter.unit)
            ? std::nullopt
            : value_of(item, constants);
          items.push_back(value ? si_quantity(*value, parameter.unit) : item);
        }
      return joined(items);
    }
  } // namespace



  std::string Parameter::with_constants(const std::string &text,
                                        const Constants   &constants) const
  {
    if (constants.empty() || problem(text).empty())
      return text;
    if (kind == Kind::quantity_list)
      return list_with_constants(*this, text, constants);
    if (kind != Kind::quantity && kind != Kind::integer)
      return text;
    const std::optional<double> value = value_of(text, constants);
    if (!value)
      return text;
    return kind == Kind::integer ? number_text(*value)
                                 : si_quantity(*value, unit);
  }
} // namespace auxfem
