#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/inheritance.h>
#include <auxfem/parameters/registry.h>

#include <algorithm>
#include <set>

namespace auxfem
{
  namespace
  {
    class Inheritance
    {
    public:
      Inheritance(const SubsectionSchema &schema,
                  const Parameter        &base,
                  ParameterSubsection    &groups,
                  Mistakes               &mistakes)
        : schema(schema)
        , base(base)
        , groups(groups)
        , mistakes(mistakes)
      {}

      void run()
      {
        for (ParameterSubsection &group : groups.subsections)
          complete(group);
      }

    private:
      /** Adds the values that @p group inherits. */
      void complete(ParameterSubsection &group)
      {
        const ParameterEntry *const entry = group.find_entry(base.name);
        if (done.count(group.name) > 0 || entry == nullptr ||
            entry->value == base.default_value)
          return;
        // The entry moves as values are added.
        const ParameterEntry       given  = *entry;
        ParameterSubsection *const source = groups.find_subsection(given.value);
        if (source == nullptr)
          return refuse(given,
                        group,
                        "there is no such section" +
                          did_you_mean(given.value,
                                       names_of(groups.subsections)) +
                          "\n  Allowed: " + names_of_others(group));
        if (!open.insert(group.name).second)
          return refuse(given, group, "it inherits from itself");
        complete(*source);
        open.erase(group.name);
        done.insert(group.name);
        for (const ParameterEntry &value : source->entries)
          if (group.find_entry(value.name) == nullptr &&
              is_inherited(value.name, group))
            group.entries.push_back(value);
      }

      std::string names_of_others(const ParameterSubsection &group) const
      {
        std::vector<std::string> names;
        for (const ParameterSubsection &other : groups.subsections)
          if (other.name != group.name)
            names.push_back(other.name);
        names.push_back(base.default_value);
        return joined(names);
      }

      void refuse(const ParameterEntry      &entry,
                  const ParameterSubsection &group,
                  const std::string         &problem)
      {
        if (done.insert(group.name).second)
          mistakes.add(entry.location.text() + ": " + groups.name + "/" +
                       group.name + "/" + base.name + " = " + entry.value +
                       ": " + problem);
      }

      /** Whether the choice of @p group has the parameter @p name. */
      bool is_inherited(const std::string         &name,
                        const ParameterSubsection &group) const
      {
        const ParameterEntry *const choice  = group.find_entry(schema.choice);
        const SubsectionVariant    *variant = choice == nullptr
             ? nullptr
             : find_by_name(schema.variants, choice->value);
        return variant == nullptr || find_by_name(schema.parameters, name) ||
          find_by_name(variant->parameters, name);
      }

      const SubsectionSchema &schema;
      const Parameter        &base;
      ParameterSubsection    &groups;
      Mistakes               &mistakes;
      /** Groups whose values are being completed, or are complete. */
      std::set<std::string> open, done;
    };
  } // namespace

  void inherit_values(const SubsectionSchema &schema,
                      const Parameter        &base,
                      ParameterSubsection    &root,
                      Mistakes               &mistakes)
  {
    if (ParameterSubsection *const groups = root.find_subsection(schema.name))
      Inheritance(schema, base, *groups, mistakes).run();
  }
} // namespace auxfem
