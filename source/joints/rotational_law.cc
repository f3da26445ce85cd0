#include <auxfem/joints/rotational_law.h>
#include <auxfem/parameters/errors.h>

#include <map>
#include <sstream>
#include <utility>

namespace auxfem
{
  namespace
  {
    const std::string prefix = "rotational ";

    /** Replaces forces by moments and extensions by rotations. */
    std::string in_rotations(std::string text)
    {
      const std::vector<std::pair<std::string, std::string>> words = {
        {"force", "moment"},
        {"Force", "Moment"},
        {"extension", "rotation"},
        {"Extension", "Rotation"},
        {"shortening", "negative rotation"},
        {"Shortening", "Negative rotation"},
        {"m/s", "rad/s"},
        {"(m)", "(rad)"},
        {"(N)", "(N m)"},
        {"Law = ", "Type = " + prefix}};
      for (const auto &[word, other] : words)
        for (std::size_t at = text.find(word); at != std::string::npos;
             at             = text.find(word, at + other.size()))
          text.replace(at, word.size(), other);
      return text;
    }

    /** Unit for rotations that corresponds to @p unit for extensions. */
    std::string unit_in_rotations(const std::string &unit)
    {
      static const std::map<std::string, std::string> units = {
        {"m", "rad"},
        {"m/s", "rad/s"},
        {"s/m", "s/rad"},
        {"N", "N m"},
        {"N/m", "N m/rad"},
        {"N s/m", "N m s/rad"},
        {"N/m^3", "N m/rad^3"}};
      const auto found = units.find(unit);
      return found == units.end() ? unit : found->second;
    }

    std::string exact_text(const double number)
    {
      std::ostringstream text;
      text.precision(17);
      text << number;
      return text.str();
    }

    /** Value of a parameter with numbers in SI. */
    std::string si_text(const Parameter &parameter, const std::string &text)
    {
      if (parameter.is_word(text) || text.empty())
        return text;
      if (parameter.kind == Parameter::Kind::quantity)
        return exact_text(Quantity(parameter.name,
                                   parameter.default_value,
                                   parameter.unit,
                                   parameter.range,
                                   parameter.sentence,
                                   parameter.words)
                            .value(text));
      if (parameter.kind != Parameter::Kind::quantity_list)
        return text;
      std::vector<std::string> numbers;
      for (const double number : QuantityList(parameter.name,
                                              parameter.default_value,
                                              parameter.unit,
                                              parameter.range,
                                              parameter.minimum_length,
                                              parameter.maximum_length,
                                              parameter.sentence,
                                              parameter.words)
                                   .value(text))
        numbers.push_back(exact_text(number));
      return joined(numbers);
    }

    Parameter parameter_in_rotations(const Parameter &parameter)
    {
      Parameter rotational     = parameter;
      rotational.name          = in_rotations(parameter.name);
      rotational.unit          = unit_in_rotations(parameter.unit);
      rotational.sentence      = in_rotations(parameter.sentence);
      rotational.default_value = si_text(parameter, parameter.default_value);
      return rotational;
    }
  } // namespace

  std::vector<SubsectionVariant> rotational_laws()
  {
    std::vector<SubsectionVariant> variants;
    for (const RegistryEntry<ConnectorLaw> &entry : connector_law_registry())
      if (entry.name != "spring")
        {
          SubsectionVariant variant{prefix + entry.name,
                                    in_rotations(entry.description)};
          for (const Parameter &parameter : entry.parameters)
            variant.parameters.push_back(parameter_in_rotations(parameter));
          variants.push_back(std::move(variant));
        }
    return variants;
  }

  std::unique_ptr<ConnectorLaw> make_rotational_law(const std::string &type,
                                                    ParameterValues   &values)
  {
    const RegistryEntry<ConnectorLaw> &entry =
      find_entry(connector_law_registry(), type.substr(prefix.size()));
    // Numbers without a unit word are SI, for rotations as for extensions.
    ParameterValues extension_values(entry.parameters,
                                     values.context,
                                     values.location);
    for (const Parameter &parameter : entry.parameters)
      {
        const Parameter rotational = parameter_in_rotations(parameter);
        extension_values.set(parameter.name,
                             si_text(rotational, values.text(rotational)));
      }
    try
      {
        return entry.make(extension_values);
      }
    catch (const InputError &error)
      {
        throw InputError(in_rotations(error.what()));
      }
  }
} // namespace auxfem
