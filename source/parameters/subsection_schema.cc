#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/registry.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionSchema::Form;

    /** Names become column names, paths of overrides and file names. */
    std::string name_problem(const std::string &name)
    {
      const bool good = std::all_of(name.begin(), name.end(), [](const char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
          (c >= '0' && c <= '9') || c == '_' || c == '-' || c == ' ';
      });
      return good ? ""
                  : "the name may consist of letters, digits, _, - and "
                    "blanks only";
    }

    /** Checks one subsection with entries against one schema. */
    class SubsectionCheck
    {
    public:
      SubsectionCheck(const ParameterSubsection &found,
                      const std::string         &path,
                      const SubsectionSchema    &schema,
                      const SceneContext        &context,
                      Mistakes                  &mistakes)
        : found(found)
        , path(path)
        , schema(schema)
        , context(context)
        , mistakes(mistakes)
        , allowed(schema.parameters)
      {
        choose_variant();
      }

      bool run()
      {
        for (const ParameterEntry &entry : found.entries)
          if (const Parameter *declared = find_by_name(allowed, entry.name))
            check_value(entry, *declared);
          else
            report_unexpected(entry);
        for (const Parameter &declared : allowed)
          if (declared.required)
            check_required(declared);
        return good;
      }

      ParameterValues values() const
      {
        SceneContext own(context);
        own.path = path;
        ParameterValues values(allowed, own, found.location);
        for (const ParameterEntry &entry : found.entries)
          values.set(entry.name, entry.value);
        return values;
      }

    private:
      void choose_variant()
      {
        if (schema.choice.empty())
          return;
        const ParameterEntry *entry = found.find_entry(schema.choice);
        variant =
          find_by_name(schema.variants,
                       entry != nullptr
                         ? entry->value
                         : find_by_name(allowed, schema.choice)->default_value);
        if (variant != nullptr)
          allowed.insert(allowed.end(),
                         variant->parameters.begin(),
                         variant->parameters.end());
      }

      void report(const FileLocation &location, const std::string &message)
      {
        good = false;
        mistakes.add(location.text() + ": " + message);
      }

      std::string path_of(const std::string &name) const
      {
        return path.empty() ? name : path + "/" + name;
      }

      void check_value(const ParameterEntry &entry, const Parameter &declared)
      {
        const std::string problem = declared.problem(
          declared.with_constants(entry.value, context.constants));
        if (!problem.empty())
          report(entry.location,
                 path_of(entry.name) + " = " + entry.value + ": " + problem +
                   "\n  Allowed: " + declared.allowed_with_units() +
                   "\n  Meaning: " + declared.sentence);
      }

      void check_required(const Parameter &declared)
      {
        const ParameterEntry *entry = found.find_entry(declared.name);
        if (entry == nullptr || entry->value.empty())
          report(entry == nullptr ? found.location : entry->location,
                 path_of(declared.name) +
                   " must be given: " + declared.sentence +
                   "\n  Allowed: " + declared.allowed_with_units());
      }

      /** Reports an entry of another choice or an unknown one. */
      void report_unexpected(const ParameterEntry &entry)
      {
        std::vector<std::string> owners;
        for (const SubsectionVariant &other : schema.variants)
          if (find_by_name(other.parameters, entry.name) != nullptr)
            owners.push_back(other.name);
        // Without a valid choice, its entries cannot be judged.
        if (!owners.empty() && variant == nullptr)
          good = false;
        else if (!owners.empty())
          report(entry.location,
                 path_of(entry.name) + ": belongs to " + schema.choice + " = " +
                   joined(owners) + ", but here " + schema.choice + " = " +
                   variant->name +
                   ".\n  Remove it or change the choice. Allowed here: " +
                   joined(names_of(allowed)));
        else
          report(entry.location,
                 path_of(entry.name) + ": unknown parameter" +
                   did_you_mean(entry.name, names_of(allowed)) +
                   "\n  Allowed here: " + joined(names_of(allowed)));
      }

      const ParameterSubsection &found;
      const std::string          path;
      const SubsectionSchema    &schema;
      const SceneContext        &context;
      Mistakes                  &mistakes;
      Parameters                 allowed;
      const SubsectionVariant   *variant = nullptr;
      bool                       good    = true;
    };

    /** Reports subsections inside @p found, where none are allowed. */
    void refuse_subsections(const ParameterSubsection &found,
                            const std::string         &path,
                            Mistakes                  &mistakes)
    {
      for (const ParameterSubsection &inner : found.subsections)
        mistakes.add(inner.location.text() + ": " + path + "/" + inner.name +
                     ": no subsection is allowed in " + path +
                     "; check the \"end\" lines before it");
    }

    std::vector<ParameterValues> check_fixed(const ParameterSubsection &root,
                                             const SubsectionSchema    &schema,
                                             const SceneContext        &context,
                                             Mistakes &mistakes)
    {
      ParameterSubsection absent;
      absent.location                  = root.location;
      const ParameterSubsection *found = &root;
      if (!schema.name.empty())
        {
          found = root.find_subsection(schema.name);
          found = (found == nullptr ? &absent : found);
          refuse_subsections(*found, schema.name, mistakes);
        }
      SubsectionCheck check(*found, schema.name, schema, context, mistakes);
      if (!check.run())
        return {};
      return {check.values()};
    }

    std::vector<ParameterValues>
    check_named_groups(const ParameterSubsection &found,
                       const SubsectionSchema    &schema,
                       const SceneContext        &context,
                       Mistakes                  &mistakes)
    {
      for (const ParameterEntry &entry : found.entries)
        mistakes.add(entry.location.text() + ": " + schema.name + "/" +
                     entry.name +
                     ": a parameter cannot stand here; put it into a "
                     "subsection of " +
                     schema.name + " with a name of your choice");
      std::vector<ParameterValues> result;
      for (const ParameterSubsection &group : found.subsections)
        {
          const std::string path    = schema.name + "/" + group.name;
          const std::string problem = name_problem(group.name);
          if (!problem.empty())
            mistakes.add(group.location.text() + ": " + path + ": " + problem);
          refuse_subsections(group, path, mistakes);
          SubsectionCheck check(group, path, schema, context, mistakes);
          if (check.run() && problem.empty())
            result.push_back(check.values());
        }
      return result;
    }

    /** Path of a parameter without blanks around its parts. */
    std::string trimmed_path(const std::string &path)
    {
      std::string text;
      for (const std::string &part :
           dealii::Utilities::split_string_list(path, '/'))
        text += (text.empty() ? "" : "/") + part;
      return text;
    }

    std::vector<ParameterValues>
    check_free_entries(const ParameterSubsection &found,
                       const SubsectionSchema    &schema,
                       SceneContext               context,
                       Mistakes                  &mistakes)
    {
      refuse_subsections(found, schema.name, mistakes);
      std::vector<ParameterValues> result;
      std::set<std::string>        names;
      const bool has_paths = schema.form == Form::path_entries;
      for (const ParameterEntry &entry : found.entries)
        {
          const std::string name =
            has_paths ? trimmed_path(entry.name) : entry.name;
          context.path = schema.name + "/" + name;
          // Paths are names of parameters, which a case will check.
          std::string problem = has_paths ? "" : name_problem(name);
          if (problem.empty() && entry.value.empty())
            problem = "there is no value";
          if (!names.insert(name).second)
            problem = "it is given twice. Remove one of them";
          if (!problem.empty())
            {
              mistakes.add(entry.location.text() + ": " + context.path + ": " +
                           problem);
              continue;
            }
          result.emplace_back(Parameters{Text{name, entry.value, ""}},
                              context,
                              entry.location);
        }
      return result;
    }
  } // namespace



  const std::string &text_of_free_entry(const ParameterValues &values)
  {
    return values.text(values.parameters.front());
  }



  std::vector<ParameterValues> check_subsection(const ParameterSubsection &root,
                                                const SubsectionSchema &schema,
                                                const SceneContext     &context,
                                                Mistakes &mistakes)
  {
    if (schema.form == Form::fixed)
      return check_fixed(root, schema, context, mistakes);
    const ParameterSubsection *found = root.find_subsection(schema.name);
    if (found == nullptr)
      return {};
    return schema.form == Form::named_groups
      ? check_named_groups(*found, schema, context, mistakes)
      : check_free_entries(*found, schema, context, mistakes);
  }
} // namespace auxfem
