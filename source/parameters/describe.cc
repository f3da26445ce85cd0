#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/expression.h>
#include <auxfem/parameters/quantity.h>
#include <auxfem/parameters/text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /**
     * Former names of renamed parameters, in lower case, and their present
     * names.
     */
    constexpr std::array<std::pair<const char *, const char *>, 4> renamed = {
      {{"together", "Refine together"},
       {"opposite side", "Reverse branch"},
       {"kept reduction", "Jacobian reuse threshold"},
       {"columns at", "Interlayer joints"}}};

    std::string lower_case(std::string text)
    {
      for (char &letter : text)
        letter =
          static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      return text;
    }

    bool begins_with(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }

    /**
     * Insertions, deletions, replacements and swaps of neighbours that turn
     * one word into the other (optimal string alignment).
     */
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> before_last(b.size() + 1);
      std::vector<std::size_t> last(b.size() + 1);
      std::vector<std::size_t> current(b.size() + 1);
      std::iota(last.begin(), last.end(), std::size_t(0));
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          current[0] = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              current[j] = std::min({last[j] + 1,
                                     current[j - 1] + 1,
                                     last[j - 1] + (a[i - 1] != b[j - 1])});
              if (i > 1 && j > 1 && a[i - 1] == b[j - 2] &&
                  a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before_last[j - 2] + 1);
            }
          before_last.swap(last);
          last.swap(current);
        }
      return last.back();
    }

    bool is_near(const std::string &a, const std::string &b)
    {
      const std::size_t shorter  = std::min(a.size(), b.size());
      const std::size_t distance = edit_distance(a, b);
      // Suggestions that differ in more letters mislead. A short name may
      // differ in one letter, but not in all.
      const std::size_t limit =
        std::max<std::size_t>(1, std::max(a.size(), b.size()) / 3);
      return (distance <= limit && distance < shorter) || distance == 0 ||
        (shorter >= 2 && (begins_with(a, b) || begins_with(b, a)));
    }
  } // namespace

  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known)
  {
    const std::string lower_name = lower_case(name);
    for (const auto &[former, present] : renamed)
      if (lower_name == former &&
          std::find(known.begin(), known.end(), present) != known.end())
        return {present};
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const auto &candidate : known)
      if (is_near(lower_name, lower_case(candidate)))
        near.emplace_back(edit_distance(lower_name, lower_case(candidate)),
                          candidate);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());

    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(max_listed_items, near.size()); ++i)
      names.push_back(near[i].second);
    return names;
  }

  std::string did_you_mean(const std::string              &name,
                           const std::vector<std::string> &known)
  {
    const auto names = nearest_names(name, known);
    if (names.empty())
      return ".";
    std::string text = "; did you mean ";
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "\"" : " or \"") + names[i] + "\"";
    return text + "?";
  }

  namespace
  {
    using Form = SubsectionSchema::Form;

    /** Sentence and allowed values, for a comment. */
    std::string sentences_of(const Parameter &parameter)
    {
      return parameter.sentence +
        (parameter.kind == Parameter::Kind::text
           ? ""
           : " Allowed: " + parameter.allowed() + ".");
    }

    std::string after_equals(const std::string &text)
    {
      return text.empty() ? " =" : " = " + text;
    }

    /** Lines of a commented and indented .prm file. */
    class TerminalText
    {
    public:
      void line(const std::string &text)
      {
        if (!text.empty())
          out << std::string(2 * depth, ' ') << text;
        out << '\n';
      }

      void comment(const std::string &text)
      {
        const unsigned int width = 76 - 2 * depth;
        for (const std::string &piece :
             dealii::Utilities::break_text_into_lines(text, width))
          line("# " + piece);
      }

      void open(const std::string &subsection)
      {
        line("subsection " + subsection);
        indent();
      }

      void close()
      {
        unindent();
        line("end");
      }

      void indent()
      {
        ++depth;
      }

      void unindent()
      {
        --depth;
      }

      void describe(const Parameters &parameters)
      {
        for (const Parameter &parameter : parameters)
          {
            comment(sentences_of(parameter) +
                    (parameter.required ? " Must be given." : ""));
            line("set " + parameter.name +
                 after_equals(parameter.default_value));
          }
      }

      void list(const ParameterValues &values)
      {
        for (const Parameter &parameter : values.parameters)
          {
            if (!parameter.sentence.empty())
              comment(sentences_of(parameter));
            const bool shows_default =
              !values.is_default(parameter) && !parameter.default_value.empty();
            line("set " + parameter.name +
                 after_equals(values.text(parameter)) +
                 (shows_default ? "   # default: " + parameter.default_value
                                : ""));
          }
      }

      /** Parameters of the user's names have no defaults. */
      void list_changes(const ParameterValues &values, const Form form)
      {
        const bool has_defaults =
          form == Form::fixed || form == Form::named_groups;
        for (const Parameter &parameter : values.parameters)
          if (!has_defaults || !values.is_default(parameter))
            line("set " + parameter.name +
                 after_equals(values.text(parameter)));
      }

      std::string text() const
      {
        return out.str();
      }

    private:
      std::ostringstream out;
      unsigned int       depth = 0;
    };

    /** Section of the reference that concerns all parameters. */
    struct Chapter
    {
      std::string              heading;
      std::vector<std::string> paragraphs;
    };

    std::vector<Chapter> chapters()
    {
      std::string units;
      for (const std::string &line : unit_words())
        units += (units.empty() ? "" : "; ") + line;
      return {
        {"Units",
         {"A number without unit word is in the unit of its parameter. Any "
          "fitting unit word may follow: `10 mm`, `70 GPa`, `20 kN/m`, "
          "`5 N s/m`, `1140 kg/m3`. Products are written with a blank or `*`, "
          "powers as `m3` or `m^3`.",
          units + "."}},
        {"Functions of time",
         {"An expression in `t` (s) in SI units, e.g. `2e7*t^3` or "
          "`100*min(t/0.01, 1)`; or a number with or without unit word; or a "
          "table.",
          "`table: FILE` reads times (s) from the first column of a text file "
          "and values (SI) from the second, `table: FILE, 3` from the third. A "
          "relative name starts from the folder of the parameter file. Columns "
          "are separated by commas, semicolons or blanks. One line of headings "
          "and comments after `#` are allowed. Times must not decrease; two "
          "rows at one time are a jump.",
          "Loads and motions are interpolated linearly and constant beyond the "
          "rows. With inertia, a moved support strikes at each row where its "
          "velocity jumps. `smooth table: FILE` uses a cubic spline, for "
          "motions measured at many times: velocities and accelerations are "
          "continuous, but the spline overshoots next to corners. A scale may "
          "precede: `0.001 * table: FILE`, `-2 kg * table: FILE`; it is a "
          "number with or without unit word, or an expression of constants."}},
        {"Expressions",
         {"Functions of time and conditions of sets may use the constants of "
          "the scene, and:",
          Expression::syntax_help()}}};
    }

    void describe_entries(const SubsectionSchema &schema, TerminalText &text)
    {
      text.describe(schema.parameters);
      for (const SubsectionVariant &variant : schema.variants)
        {
          text.line("");
          text.comment("With " + schema.choice + " = " + variant.name + ": " +
                       variant.sentence);
          text.indent();
          text.describe(variant.parameters);
          text.unindent();
        }
    }

    void describe_subsection(const SubsectionSchema &schema, TerminalText &text)
    {
      if (!schema.name.empty())
        text.open(schema.name);
      text.comment(schema.sentence);
      if (schema.form == Form::free_entries)
        text.line("set NAME = TEXT   # any number, with names of your choice");
      if (schema.form == Form::path_entries)
        text.line("set SUBSECTION/PARAMETER = TEXT   # any number");
      if (schema.form == Form::named_groups)
        {
          text.comment("Any number of subsections, with names of your choice:");
          text.open("NAME");
        }
      text.line("");
      describe_entries(schema, text);
      if (schema.form == Form::named_groups)
        text.close();
      if (!schema.name.empty())
        text.close();
      text.line("");
    }

    /** Text for a cell of a Markdown table. */
    std::string cell(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += (c == '|' ? "\\|" : std::string(1, c));
      return result;
    }

    /** Turns indented lines of a text into list items. */
    std::string as_list(const std::string &text)
    {
      std::istringstream lines(text);
      std::string        result;
      for (std::string line; std::getline(lines, line);)
        {
          const std::size_t colon =
            std::find_if_not(line.begin() +
                               std::min<std::size_t>(2, line.size()),
                             line.end(),
                             [](const unsigned char c) {
                               return std::isalnum(c) || c == '_';
                             }) -
            line.begin();
          const bool is_item = line.compare(0, 2, "  ") == 0 && colon > 2 &&
            line.compare(colon, 2, ": ") == 0;
          result += is_item ? "- " + line.substr(2, colon - 2) + ": `" +
              line.substr(colon + 2) + '`'
                            : line;
          if (!lines.eof())
            result += '\n';
        }
      return result;
    }

    std::string code(const std::string &text)
    {
      return text.empty() ? "" : "`" + cell(text) + "`";
    }

    std::string unit(const Parameter &parameter)
    {
      return parameter.unit != "1" ? parameter.unit : "";
    }

    void write_table(const Parameters &parameters, std::ostream &out)
    {
      if (parameters.empty())
        return;
      out << "| parameter | default | unit | allowed | meaning |\n"
          << "| --- | --- | --- | --- | --- |\n";
      for (const Parameter &parameter : parameters)
        out << "| " << code(parameter.name) << " | "
            << (parameter.required ? "must be given"
                                   : code(parameter.default_value))
            << " | " << unit(parameter) << " | " << cell(parameter.allowed())
            << " | " << cell(parameter.sentence) << " |\n";
      out << '\n';
    }

    void write_heading(const SubsectionSchema &schema, std::ostream &out)
    {
      out << "## " << (schema.name.empty() ? "Top level" : schema.name)
          << "\n\n"
          << schema.sentence << "\n\n";
      if (schema.form == Form::named_groups)
        out << "Any number of `subsection NAME` inside `subsection "
            << schema.name << "`, with names of your choice, each with:\n\n";
      if (schema.form == Form::free_entries)
        out << "Any number of `set NAME = TEXT` inside `subsection "
            << schema.name << "`, with names of your choice.\n\n";
      if (schema.form == Form::path_entries)
        out << "Any number of `set SUBSECTION/PARAMETER = TEXT` inside "
            << "`subsection " << schema.name << "`.\n\n";
    }

    Json json_of(const Parameters &parameters)
    {
      Json list = Json::array();
      for (const Parameter &parameter : parameters)
        list.push_back({{"name", parameter.name},
                        {"required", parameter.required},
                        {"default", parameter.default_value},
                        {"unit", unit(parameter)},
                        {"allowed", parameter.allowed()},
                        {"meaning", parameter.sentence}});
      return list;
    }

    std::string name_of(const Form form)
    {
      switch (form)
        {
          case Form::fixed:
            return "fixed";
          case Form::named_groups:
            return "named groups";
          case Form::free_entries:
            return "free entries";
          case Form::path_entries:
            return "path entries";
        }
      return "";
    }
  } // namespace



  std::string describe_parameters(const std::vector<SubsectionSchema> &schemas)
  {
    TerminalText text;
    for (const Chapter &chapter : chapters())
      {
        text.comment(chapter.heading + ":");
        for (const std::string &paragraph : chapter.paragraphs)
          text.comment(paragraph);
        text.line("");
      }
    for (const SubsectionSchema &schema : schemas)
      describe_subsection(schema, text);
    return text.text();
  }



  std::string
  describe_parameters_markdown(const std::vector<SubsectionSchema> &schemas)
  {
    std::ostringstream out;
    out << "# Parameters\n\n"
           "Generated by `auxfem` from its declarations.\n\n";
    for (const Chapter &chapter : chapters())
      {
        out << "## " << chapter.heading << "\n\n";
        for (const std::string &paragraph : chapter.paragraphs)
          out << as_list(paragraph) << "\n\n";
      }
    for (const SubsectionSchema &schema : schemas)
      {
        write_heading(schema, out);
        write_table(schema.parameters, out);
        for (const SubsectionVariant &variant : schema.variants)
          {
            out << "### " << schema.choice << " = " << variant.name << "\n\n"
                << variant.sentence << "\n\n";
            write_table(variant.parameters, out);
          }
      }
    return out.str();
  }



  std::string
  describe_parameters_json(const std::vector<SubsectionSchema> &schemas)
  {
    Json subsections = Json::array();
    for (const SubsectionSchema &schema : schemas)
      {
        Json subsection = {{"name", schema.name},
                           {"form", name_of(schema.form)},
                           {"meaning", schema.sentence},
                           {"parameters", json_of(schema.parameters)}};
        if (!schema.variants.empty())
          subsection["choice"] = schema.choice;
        for (const SubsectionVariant &variant : schema.variants)
          subsection["variants"].push_back(
            {{"value", variant.name},
             {"meaning", variant.sentence},
             {"parameters", json_of(variant.parameters)}});
        subsections.push_back(subsection);
      }
    return json_text({{"subsections", subsections}}) + '\n';
  }



  namespace
  {
    /** The @p values of a subsection, each written by @p list. */
    template <class List>
    std::string listed(const SubsectionSchema             &schema,
                       const std::vector<ParameterValues> &values,
                       const List                         &list)
    {
      TerminalText text;
      if (!schema.name.empty())
        text.open(schema.name);
      for (const ParameterValues &one : values)
        {
          if (schema.form == Form::named_groups)
            text.open(one.name());
          list(text, one);
          if (schema.form == Form::named_groups)
            text.close();
        }
      if (!schema.name.empty())
        text.close();
      text.line("");
      return text.text();
    }
  } // namespace

  std::string listing_of(const SubsectionSchema             &schema,
                         const std::vector<ParameterValues> &values)
  {
    if (values.empty())
      return "";
    return listed(schema,
                  values,
                  [](TerminalText &text, const ParameterValues &one) {
                    text.list(one);
                  });
  }

  std::string changes_in(const SubsectionSchema             &schema,
                         const std::vector<ParameterValues> &values)
  {
    const auto has_changes = [](const ParameterValues &one) {
      return std::any_of(one.parameters.begin(),
                         one.parameters.end(),
                         [&one](const Parameter &parameter) {
                           return !one.is_default(parameter);
                         });
    };
    if (values.empty() ||
        (schema.form == Form::fixed && !has_changes(values.front())))
      return "";
    return listed(schema,
                  values,
                  [&schema](TerminalText &text, const ParameterValues &one) {
                    text.list_changes(one, schema.form);
                  });
  }
} // namespace auxfem
