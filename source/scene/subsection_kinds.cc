#include <auxfem/parameters/json.h>
#include <auxfem/scene/scene_sections.h>

#include <deal.II/base/patterns.h>

// Boost asks for this before its JSON reader is included
#define BOOST_BIND_GLOBAL_PLACEHOLDERS

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  const std::vector<SubsectionKind> &subsection_kinds()
  {
    static const std::vector<SubsectionKind> kinds = [] {
      std::vector<SubsectionKind> all;
      for (const auto &group : {general_kinds(),
                                {reduced_cell_kind()},
                                structure_kinds(),
                                load_kinds(),
                                time_kinds(),
                                output_kinds()})
        all.insert(all.end(), group.begin(), group.end());
      return all;
    }();
    return kinds;
  }



  bool SubsectionKind::serves(const Model model) const
  {
    return std::find(models.begin(), models.end(), model) != models.end();
  }



  bool DeclaredEntry::required() const
  {
    return rule && rule->required;
  }



  std::string DeclaredEntry::problem(const std::string &value) const
  {
    // an empty line is no way to ask for a default
    if (value.empty())
      return default_value.empty() ? "" : "there is no value";
    if (rule)
      return rule->problem(value);
    return dealii::Patterns::pattern_factory(pattern)->match(value)
      ? ""
      : "the value does not match";
  }



  std::string DeclaredEntry::allowed() const
  {
    return rule ? rule->allowed_with_units()
                : dealii::Patterns::pattern_factory(pattern)->description(
                    dealii::Patterns::PatternBase::Text);
  }



  std::vector<DeclaredEntry> declared_entries(
    const std::function<void(dealii::ParameterHandler &)> &declare)
  {
    dealii::ParameterHandler prm;
    if (declare)
      declare(prm);
    // ParameterHandler has no other way to list its entries and patterns
    std::stringstream json;
    prm.print_parameters(json,
                         dealii::ParameterHandler::JSON |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    const Json tree = Json::parse(json);

    std::vector<DeclaredEntry> entries;
    for (const auto &[name, node] : tree.items())
      {
        DeclaredEntry entry;
        entry.name          = name;
        entry.default_value = node.at("default_value");
        entry.pattern       = node.at("pattern_description");
        entry.rule          = rule_from_description(entry.pattern);
        entry.sentence      = node.at("documentation");
        // the allowed values after it are known from the rule
        entry.sentence = entry.sentence.substr(0, entry.sentence.find('\n'));
        entries.push_back(entry);
      }
    return entries;
  }



  std::vector<std::string> names_of(const std::vector<DeclaredEntry> &entries)
  {
    std::vector<std::string> names;
    for (const DeclaredEntry &entry : entries)
      names.push_back(entry.name);
    return names;
  }
} // namespace auxfem
