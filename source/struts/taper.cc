#include <auxfem/parameters/expression.h>
#include <auxfem/struts/taper.h>

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

    /** Number of points at which factors are checked in advance. */
    constexpr unsigned int n_checked_points = 101;

    /** @p value with @p digits significant digits. */
    std::string text_of(const double value, const int digits)
    {
      std::ostringstream text;
      text.precision(digits);
      text << value;
      return text.str();
    }

    /** The length @p name of @p shape; throws if there is none. */
    Quantity dimension_of(const ParameterValues             &values,
                          const Parameter                   &parameter,
                          const RegistryEntry<CrossSection> &shape,
                          const std::string                 &name)
    {
      std::string allowed;
      for (const Parameter &known : shape.parameters)
        if (known.kind == Parameter::Kind::quantity && known.unit == "m")
          {
            if (known.name == name && !values.is_word(known))
              return {known.name,
                      known.default_value,
                      known.unit,
                      known.range,
                      known.sentence,
                      known.words};
            allowed += (allowed.empty() ? "" : ", ") + known.name;
          }
      values.refuse(parameter,
                    "\"" + name + "\" is no length of Shape = " + shape.name +
                      (allowed.empty()
                         ? ". Choose a shape with dimensions"
                         : " that has a number. Lengths are: " + allowed));
    }
  } // namespace

  Taper::Taper(const ParameterValues             &values,
               const Parameter                   &parameter,
               const RegistryEntry<CrossSection> &shape)
    : values(values)
    , parameter(parameter)
    , shape(shape)
    , position(std::make_unique<double>(0))
  {
    for (const std::string &text :
         split_string_list(values.text(parameter), ';'))
      {
        const std::size_t colon = text.find(':');
        if (colon == std::string::npos)
          values.refuse(parameter,
                        "\"" + text +
                          "\" has no colon. Write DIMENSION: EXPRESSION in s, "
                          "e.g. Height: 1 - 0.5 * s");
        const std::string name = trim(text.substr(0, colon));
        const double      value =
          values[dimension_of(values, parameter, shape, name)];
        try
          {
            factors.push_back(
              {name,
               value,
               std::make_unique<Expression>(text.substr(colon + 1),
                                            std::vector<Expression::Variable>{
                                              {"s", position.get()}},
                                            std::vector<Expression::Constant>(),
                                            values.context.constants)});
          }
        catch (const ExpressionError &error)
          {
            values.refuse(parameter,
                          "cannot understand \"" + text +
                            "\": " + error.what() +
                            ". Write an expression in s, from 0 at the first "
                            "joint of a strut to 1 at the second, e.g. Height: "
                            "1 - 0.5 * s");
          }
        for (unsigned int i = 0; i < n_checked_points; ++i)
          factor_at(factors.back(), double(i) / (n_checked_points - 1));
      }
  }

  Taper::~Taper() = default;

  double Taper::factor_at(const Factor &factor, const double s) const
  {
    *position          = s;
    const double value = factor.expression->value();
    if (!(value > 0 && std::isfinite(value)))
      values.refuse(parameter,
                    "the factor of " + factor.dimension + " is " +
                      text_of(value, 3) + " at s = " + text_of(s, 3) +
                      ". It must be positive along the whole strut");
    return value;
  }

  const CrossSection &Taper::shape_at(const double s) const
  {
    const auto found = known.find(s);
    if (found != known.end())
      return found->second;
    ParameterValues there = values;
    for (const Factor &factor : factors)
      there.set(factor.dimension,
                text_of(factor.value * factor_at(factor, s),
                        std::numeric_limits<double>::max_digits10));
    return known.emplace(s, *shape.make(there)).first->second;
  }
} // namespace auxfem
