#include <auxfem/figures/derived_columns.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace auxfem
{
  namespace
  {
    /** Name of column @p i inside an expression. */
    std::string variable_name(const std::size_t i)
    {
      return "column_" + std::to_string(i) + "_";
    }

    /** Whether @p character may continue a name of letters, digits, _ and
     * points. */
    bool is_in_name(const char character)
    {
      return std::isalnum(static_cast<unsigned char>(character)) != 0 ||
        character == '_' || character == '.';
    }

    /** Whether @p text has @p name at @p position and not as a part of a longer
     * one. */
    bool has_name(const std::string &text,
                  const std::size_t  position,
                  const std::string &name)
    {
      const std::size_t end = position + name.size();
      return !name.empty() && text.compare(position, name.size(), name) == 0 &&
        (position == 0 || !is_in_name(text[position - 1])) &&
        (end >= text.size() || !is_in_name(text[end]));
    }

    /** Index of the longest of @p names, which may contain blanks, at @p
     * position of @p text; their number if none is there. */
    std::size_t name_at(const std::string              &text,
                        const std::size_t               position,
                        const std::vector<std::string> &names)
    {
      std::size_t found = names.size();
      for (std::size_t i = 0; i < names.size(); ++i)
        if (has_name(text, position, names[i]) &&
            (found == names.size() || names[i].size() > names[found].size()))
          found = i;
      return found;
    }

    /** @p text with variable_name() in place of @p names. */
    std::string with_variables(const std::string              &text,
                               const std::vector<std::string> &names)
    {
      std::string result;
      for (std::size_t position = 0; position < text.size();)
        {
          const std::size_t found = name_at(text, position, names);
          if (found == names.size())
            {
              result += text[position++];
              continue;
            }
          result += variable_name(found);
          position += names[found].size();
        }
      return result;
    }

    /** The word of letters, digits, _ and points that begins at @p position of
     * @p text; empty where it is a function or no name begins there. */
    std::string word_at(const std::string &text, const std::size_t position)
    {
      const auto character = static_cast<unsigned char>(text[position]);
      if ((std::isalpha(character) == 0 && character != '_') ||
          (position > 0 && is_in_name(text[position - 1])))
        return "";
      std::size_t end = position;
      while (end < text.size() && is_in_name(text[end]))
        ++end;
      const std::size_t next = text.find_first_not_of(' ', end);
      return next != std::string::npos && text[next] == '('
        ? ""
        : text.substr(position, end - position);
    }

    bool is_constant(const DerivedColumn &column, const std::string &word)
    {
      // Constants of muParser begin with _.
      return word == "pi" || word[0] == '_' ||
        std::any_of(column.constants.begin(),
                    column.constants.end(),
                    [&word](const auto &constant) {
                      return constant.first == word;
                    });
    }

    [[noreturn]] void refuse(const DerivedColumn            &column,
                             const std::string              &problem,
                             const std::vector<std::string> &names)
    {
      throw InputError(column.path + " = " + column.expression + ": " +
                       problem + "\n  Names: " + joined(names, 60));
    }

    /** Problem of an expression that is not understood because of @p error. */
    std::string problem_of(const DerivedColumn            &column,
                           const ExpressionError          &error,
                           const std::vector<std::string> &names)
    {
      const std::vector<std::string> unknown = names_in(column, names).unknown;
      if (unknown.empty())
        return std::string(error.what()) + "\n" + error.allowed;
      return "there is no \"" + unknown.front() + '"' +
        did_you_mean(unknown.front(), names);
    }
  } // namespace

  ExpressionNames names_in(const DerivedColumn            &column,
                           const std::vector<std::string> &names)
  {
    ExpressionNames    result;
    const std::string &text = column.expression;
    for (std::size_t position = 0; position < text.size();)
      {
        const std::size_t found = name_at(text, position, names);
        const std::string word =
          found < names.size() ? names[found] : word_at(text, position);
        if (found < names.size())
          result.known.push_back(word);
        else if (!word.empty() && !is_constant(column, word))
          result.unknown.push_back(word);
        position += std::max<std::size_t>(1, word.size());
      }
    return result;
  }

  SubsectionSchema columns_schema()
  {
    return {"Columns",
            SubsectionSchema::Form::free_entries,
            "Further columns of history.csv: an expression of the names of "
            "others and of Constants, with the SI unit of the result in "
            "brackets, e.g. \"set stroke = top.uy - bottom.uy [m]\"."};
  }

  DerivedColumn read_derived_column(ParameterValues &values)
  {
    DerivedColumn column;
    column.name      = values.name();
    column.path      = values.context.path;
    column.constants = values.context.constants;
    std::string text = text_of_free_entry(values);
    if (!text.empty() && text.back() == ']')
      {
        const std::size_t bracket = text.rfind('[');
        if (bracket == std::string::npos)
          throw InputError(column.path + " = " + text +
                           ": the bracket of the unit is not opened");
        column.unit = dealii::Utilities::trim(
          text.substr(bracket + 1, text.size() - bracket - 2));
        text = dealii::Utilities::trim(text.substr(0, bracket));
        if (!column.unit.empty() && parse_unit(column.unit).factor != 1)
          throw InputError(column.path + ": the unit \"" + column.unit +
                           "\" is not SI, as columns are. Give the SI unit, or "
                           "none; an expression may have a factor");
      }
    column.expression = text;
    return column;
  }

  DerivedValues::DerivedValues(const std::vector<DerivedColumn> &definitions,
                               const std::vector<std::string>   &names)
    : variables(names.size() + definitions.size())
    , n_columns(names.size())
  {
    std::vector<std::string>          known = names;
    std::vector<Expression::Variable> named_variables;
    for (std::size_t i = 0; i < known.size(); ++i)
      named_variables.emplace_back(variable_name(i), &variables[i]);
    for (const DerivedColumn &column : definitions)
      {
        if (!column.name.empty() &&
            std::find(known.begin(), known.end(), column.name) != known.end())
          refuse(column, "there is a column of this name. Rename it", known);
        try
          {
            expressions.push_back(std::make_unique<Expression>(
              with_variables(column.expression, known),
              named_variables,
              std::vector<Expression::Constant>(),
              column.constants));
          }
        catch (const ExpressionError &error)
          {
            refuse(column, problem_of(column, error, known), known);
          }
        if (column.name.empty())
          continue;
        named_variables.emplace_back(
          variable_name(known.size()),
          &variables[n_columns + expressions.size() - 1]);
        known.push_back(column.name);
      }
  }

  DerivedValues::DerivedValues(DerivedValues &&) noexcept = default;

  DerivedValues &DerivedValues::operator=(DerivedValues &&) noexcept = default;

  DerivedValues::~DerivedValues() = default;

  void DerivedValues::append_to(std::vector<double> &row)
  {
    std::copy_n(row.begin(), n_columns, variables.begin());
    for (std::size_t i = 0; i < expressions.size(); ++i)
      {
        variables[n_columns + i] = expressions[i]->value();
        row.push_back(variables[n_columns + i]);
      }
  }
} // namespace auxfem
