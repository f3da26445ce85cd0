#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/scene/constants.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;

    const Text constants = {
      "Constants",
      "",
      "Constants for expressions, e.g. \"L = 20 mm, h = L/4\". A value is a "
      "number, in SI or with a unit, or an expression of the constants before "
      "it. Numbers of other parameters may be expressions of constants, in SI, "
      "e.g. \"set Height = 2*h\"."};

    bool is_identifier(const std::string &name)
    {
      const auto letter = [](const char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
      };
      return !name.empty() && letter(name[0]) &&
        std::all_of(name.begin(), name.end(), [&letter](const char c) {
          return letter(c) || (c >= '0' && c <= '9');
        });
    }

    using Constants = std::vector<std::pair<std::string, double>>;

    /** @p text cut at the commas that are outside of parentheses. */
    std::vector<std::string> split_definitions(const std::string &text)
    {
      std::vector<std::string> items;
      int                      depth = 0;
      for (const char c : text)
        {
          depth += (c == '(') - (c == ')');
          if (items.empty() || (c == ',' && depth == 0))
            items.emplace_back();
          if (c != ',' || depth != 0)
            items.back() += c;
        }
      return items;
    }

    /** @param known the constants that @p item may refer to */
    std::pair<std::string, double> read_constant(const std::string &item,
                                                 const Constants   &known)
    {
      static const std::set<std::string> reserved_names = {"t",
                                                           "x",
                                                           "y",
                                                           "z",
                                                           "pi",
                                                           "e",
                                                           "_pi",
                                                           "_e",
                                                           "xmin",
                                                           "xmax",
                                                           "ymin",
                                                           "ymax",
                                                           "zmin",
                                                           "zmax"};
      const std::string message = "Constants = ... " + item + " ...: ";
      const std::size_t equals  = item.find('=');
      const std::string name    = trim(item.substr(0, equals));
      if (equals == std::string::npos || !is_identifier(name))
        throw InputError(message +
                         "not understood; write name = number, the name of "
                         "letters, digits and _, e.g. Constants = F0 = 1.0, t0 "
                         "= 10 ms, t1 = 2*t0");
      if (reserved_names.count(name) != 0)
        throw InputError(message + "the name \"" + name +
                         "\" has a meaning in expressions already; choose "
                         "another one");
      try
        {
          return {name, constant_value(trim(item.substr(equals + 1)), known)};
        }
      catch (const InputError &error)
        {
          throw InputError(message + error.what());
        }
    }
  } // namespace

  const Parameter &constants_parameter()
  {
    return constants;
  }

  std::vector<std::pair<std::string, double>>
  read_constants(const ParameterValues &values)
  {
    Constants result;
    for (const std::string &item : split_definitions(values[constants]))
      {
        const auto constant = read_constant(trim(item), result);
        for (const auto &other : result)
          if (other.first == constant.first)
            throw InputError("Constants: \"" + constant.first +
                             "\" is given twice; remove one of them");
        result.push_back(constant);
      }
    return result;
  }



  namespace
  {
    /** Definitions in @p text as names and texts; the name is empty where there
     * is no `=`. */
    std::vector<std::pair<std::string, std::string>>
    definitions_in(const std::string &text)
    {
      std::vector<std::pair<std::string, std::string>> definitions;
      for (const std::string &item : split_definitions(text))
        {
          const std::size_t equals = item.find('=');
          if (equals == std::string::npos)
            definitions.emplace_back("", trim(item));
          else
            definitions.emplace_back(trim(item.substr(0, equals)),
                                     trim(item.substr(equals + 1)));
        }
      return definitions;
    }
  } // namespace



  std::optional<std::string> constant_in(const std::string &path)
  {
    const std::string beginning = constants.name + "/";
    if (path.compare(0, beginning.size(), beginning) != 0)
      return {};
    return trim(path.substr(beginning.size()));
  }



  std::optional<std::string> text_of_constant(const ParameterSubsection &root,
                                              const std::string         &name)
  {
    if (const ParameterEntry *entry = root.find_entry(constants.name))
      for (const auto &[known, text] : definitions_in(entry->value))
        if (known == name)
          return text;
    return {};
  }



  void set_constant(ParameterSubsection &root,
                    const std::string   &name,
                    const std::string   &text)
  {
    if (!text_of_constant(root, name))
      throw InputError("Constants/" + name +
                       ": there is no constant of this name. Define it at the "
                       "top of the file, e.g. set Constants = " +
                       name + " = " + text);
    ParameterEntry &entry = *root.find_entry(constants.name);
    std::string     changed;
    for (const auto &[known, former] : definitions_in(entry.value))
      changed += (changed.empty() ? "" : ", ") +
        (known.empty() ? "" : known + " = ") + (known == name ? text : former);
    entry.value = changed;
  }
} // namespace auxfem
