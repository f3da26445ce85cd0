#include <auxfem/parameters/json.h>
#include <auxfem/scene/scene_sections.h>

#include <deal.II/base/utilities.h>

#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;

    /** `a number > 0 in m`, without the unit words, which every unit has. */
    std::string allowed(const DeclaredEntry &entry)
    {
      return entry.rule ? entry.rule->allowed() : entry.allowed();
    }

    std::string allowed_sentence(const DeclaredEntry &entry)
    {
      const bool free_text =
        entry.rule && entry.rule->kind == ValueRule::Kind::text;
      return free_text ? "" : " Allowed: " + allowed(entry) + ".";
    }

    /** Lines of a commented .prm file, indented as it would be. */
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

      void entries(const std::vector<DeclaredEntry> &list)
      {
        for (const DeclaredEntry &entry : list)
          {
            comment(entry.sentence + allowed_sentence(entry) +
                    (entry.required() ? " Must be given." : ""));
            line(
              "set " + entry.name + " =" +
              (entry.default_value.empty() ? "" : " " + entry.default_value));
          }
      }

      std::string text() const
      {
        return out.str();
      }

    private:
      std::ostringstream out;
      unsigned int       depth = 0;
    };

    void describe_entries(const SubsectionKind &kind, TerminalText &text)
    {
      text.entries(declared_entries(kind.declare));
      for (const SubsectionVariant &variant : kind.variants)
        {
          text.line("");
          text.comment("With " + kind.choice + " = " + variant.name + ": " +
                       variant.sentence);
          text.indent();
          text.entries(declared_entries(variant.declare));
          text.unindent();
        }
    }

    void describe_kind(const SubsectionKind &kind, TerminalText &text)
    {
      if (!kind.name.empty())
        text.open(kind.name);
      text.comment(kind.sentence);
      if (kind.form == Form::free_entries)
        text.line("set NAME = TEXT   # any number, the names are yours");
      if (kind.form == Form::named_groups)
        {
          text.comment("Any number of subsections, the names are yours:");
          text.open("NAME");
        }
      text.line("");
      describe_entries(kind, text);
      if (kind.form == Form::named_groups)
        text.close();
      if (!kind.name.empty())
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

    std::string code(const std::string &text)
    {
      return text.empty() ? "" : "`" + cell(text) + "`";
    }

    std::string unit(const DeclaredEntry &entry)
    {
      return entry.rule && entry.rule->unit != "1" ? entry.rule->unit : "";
    }

    void write_table(const std::vector<DeclaredEntry> &entries,
                     std::ostream                     &out)
    {
      if (entries.empty())
        return;
      out << "| parameter | default | unit | allowed | meaning |\n"
          << "| --- | --- | --- | --- | --- |\n";
      for (const DeclaredEntry &entry : entries)
        out << "| " << code(entry.name) << " | "
            << (entry.required() ? "must be given" : code(entry.default_value))
            << " | " << unit(entry) << " | " << cell(allowed(entry)) << " | "
            << cell(entry.sentence) << " |\n";
      out << '\n';
    }

    void write_heading(const SubsectionKind &kind, std::ostream &out)
    {
      out << "## " << (kind.name.empty() ? "Top level" : kind.name) << "\n\n"
          << kind.sentence << "\n\n";
      if (kind.form == Form::named_groups)
        out << "Any number of `subsection NAME` inside `subsection "
            << kind.name << "`, the names are yours, each with:\n\n";
      if (kind.form == Form::free_entries)
        out << "Any number of `set NAME = TEXT` inside `subsection "
            << kind.name << "`, the names are yours.\n\n";
    }

    Json json_of(const std::vector<DeclaredEntry> &entries)
    {
      Json list = Json::array();
      for (const DeclaredEntry &entry : entries)
        list.push_back({{"name", entry.name},
                        {"required", entry.required()},
                        {"default", entry.default_value},
                        {"unit", unit(entry)},
                        {"allowed", allowed(entry)},
                        {"meaning", entry.sentence}});
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
        }
      return "";
    }
  } // namespace



  std::string describe_all_parameters()
  {
    TerminalText text;
    for (const SubsectionKind &kind : subsection_kinds())
      describe_kind(kind, text);
    return text.text();
  }



  std::string describe_all_parameters_markdown()
  {
    std::ostringstream out;
    out << "# Parameters\n\n"
           "Made by `auxfem` from its own declarations. A number without unit "
           "word is in the unit of its row; any fitting unit word may follow "
           "it (`10 mm`, `70 GPa`, `20 kN/m`). Functions of time are "
           "expressions in `t` or `table: FILE.csv`, both in SI.\n\n";
    for (const SubsectionKind &kind : subsection_kinds())
      {
        write_heading(kind, out);
        write_table(declared_entries(kind.declare), out);
        for (const SubsectionVariant &variant : kind.variants)
          {
            out << "### " << kind.choice << " = " << variant.name << "\n\n"
                << variant.sentence << "\n\n";
            write_table(declared_entries(variant.declare), out);
          }
      }
    return out.str();
  }



  std::string describe_all_parameters_json()
  {
    Json subsections = Json::array();
    for (const SubsectionKind &kind : subsection_kinds())
      {
        Json subsection = {{"name", kind.name},
                           {"form", name_of(kind.form)},
                           {"meaning", kind.sentence},
                           {"parameters",
                            json_of(declared_entries(kind.declare))}};
        if (!kind.variants.empty())
          subsection["choice"] = kind.choice;
        for (const SubsectionVariant &variant : kind.variants)
          subsection["variants"].push_back(
            {{"value", variant.name},
             {"meaning", variant.sentence},
             {"parameters", json_of(declared_entries(variant.declare))}});
        subsections.push_back(subsection);
      }
    return json_text({{"subsections", subsections}}) + '\n';
  }
} // namespace auxfem
