#include <auxfem/parameters/suggest.h>
#include <auxfem/scene/scene_sections.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using Form = SubsectionKind::Form;

    const DeclaredEntry *find(const std::vector<DeclaredEntry> &entries,
                              const std::string                &name)
    {
      for (const DeclaredEntry &entry : entries)
        if (entry.name == name)
          return &entry;
      return nullptr;
    }

    const SubsectionVariant *
    find(const std::vector<SubsectionVariant> &variants,
         const std::string                    &name)
    {
      for (const SubsectionVariant &variant : variants)
        if (variant.name == name)
          return &variant;
      return nullptr;
    }

    /** Names become columns, paths of overrides and file names. */
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

    /** Checks one subsection that holds entries against one kind. */
    class SubsectionCheck
    {
    public:
      SubsectionCheck(const ParameterSubsection &found,
                      const std::string         &path,
                      const SubsectionKind      &kind,
                      Mistakes                  &mistakes)
        : found(found)
        , path(path)
        , kind(kind)
        , mistakes(mistakes)
        , allowed(declared_entries(kind.declare))
      {
        choose_variant();
      }

      bool run()
      {
        for (const ParameterEntry &entry : found.entries)
          if (const DeclaredEntry *declared = find(allowed, entry.name))
            check_value(entry, *declared);
          else
            report_stray(entry);
        for (const DeclaredEntry &declared : allowed)
          if (declared.required())
            check_given(declared);
        return good;
      }

      void declare_and_set(dealii::ParameterHandler &prm) const
      {
        kind.declare(prm);
        if (variant != nullptr && variant->declare)
          variant->declare(prm);
        for (const ParameterEntry &entry : found.entries)
          prm.set(entry.name, entry.value);
      }

    private:
      void choose_variant()
      {
        if (kind.choice.empty())
          return;
        const ParameterEntry *entry = found.find_entry(kind.choice);
        variant =
          find(kind.variants,
               entry != nullptr ? entry->value
                                : find(allowed, kind.choice)->default_value);
        if (variant != nullptr)
          for (const DeclaredEntry &own : declared_entries(variant->declare))
            allowed.push_back(own);
      }

      void report(const FilePlace &place, const std::string &message)
      {
        good = false;
        mistakes.add(place.text() + ": " + message);
      }

      std::string path_of(const std::string &name) const
      {
        return path.empty() ? name : path + "/" + name;
      }

      void check_value(const ParameterEntry &entry,
                       const DeclaredEntry  &declared)
      {
        const std::string problem = declared.problem(entry.value);
        if (!problem.empty())
          report(entry.place,
                 path_of(entry.name) + " = " + entry.value + ": " + problem +
                   "\n  Allowed: " + declared.allowed() +
                   "\n  Meaning: " + declared.sentence);
      }

      void check_given(const DeclaredEntry &declared)
      {
        const ParameterEntry *entry = found.find_entry(declared.name);
        if (entry == nullptr || entry->value.empty())
          report(entry == nullptr ? found.place : entry->place,
                 path_of(declared.name) + " must be given: " +
                   declared.sentence + "\n  Allowed: " + declared.allowed());
      }

      /** An entry that is not allowed: of another choice, or of none. */
      void report_stray(const ParameterEntry &entry)
      {
        std::vector<std::string> owners;
        for (const SubsectionVariant &other : kind.variants)
          if (find(declared_entries(other.declare), entry.name) != nullptr)
            owners.push_back(other.name);
        // without a valid choice, nothing can be said about its entries
        if (!owners.empty() && variant == nullptr)
          good = false;
        else if (!owners.empty())
          report(entry.place,
                 path_of(entry.name) + ": belongs to " + kind.choice + " = " +
                   joined(owners) + ", but here " + kind.choice + " = " +
                   variant->name +
                   ".\n  Remove it or change the choice. Allowed here: " +
                   joined(names_of(allowed)));
        else
          report(entry.place,
                 path_of(entry.name) + ": unknown parameter" +
                   did_you_mean(entry.name, names_of(allowed)) +
                   "\n  Allowed here: " + joined(names_of(allowed)));
      }

      const ParameterSubsection &found;
      const std::string          path;
      const SubsectionKind      &kind;
      Mistakes                  &mistakes;
      std::vector<DeclaredEntry> allowed;
      const SubsectionVariant   *variant = nullptr;
      bool                       good    = true;
    };

    /** Adds subsections inside @p found, where none are allowed. */
    void refuse_subsections(const ParameterSubsection &found,
                            const std::string         &path,
                            Mistakes                  &mistakes)
    {
      for (const ParameterSubsection &inner : found.subsections)
        mistakes.add(inner.place.text() + ": " + path + "/" + inner.name +
                     ": no subsection is allowed in " + path +
                     "; check the \"end\" lines before it");
    }

    using Checked = std::vector<CheckedSubsection>;

    Checked check_fixed(const ParameterSubsection &root,
                        const SubsectionKind      &kind,
                        dealii::ParameterHandler  &prm,
                        Mistakes                  &mistakes)
    {
      ParameterSubsection absent;
      absent.place                     = root.place;
      const ParameterSubsection *found = &root;
      if (!kind.name.empty())
        {
          found = root.find_subsection(kind.name);
          found = (found == nullptr ? &absent : found);
          refuse_subsections(*found, kind.name, mistakes);
        }
      SubsectionCheck check(*found, kind.name, kind, mistakes);
      if (!check.run())
        return {};
      if (!kind.name.empty())
        prm.enter_subsection(kind.name);
      check.declare_and_set(prm);
      if (!kind.name.empty())
        prm.leave_subsection();
      return {{"", kind.name, found->place}};
    }

    Checked check_named_groups(const ParameterSubsection &root,
                               const SubsectionKind      &kind,
                               dealii::ParameterHandler  &prm,
                               Mistakes                  &mistakes)
    {
      const ParameterSubsection *found = root.find_subsection(kind.name);
      if (found == nullptr)
        return {};
      for (const ParameterEntry &entry : found->entries)
        mistakes.add(entry.place.text() + ": " + kind.name + "/" + entry.name +
                     ": a parameter cannot stand here; put it into a "
                     "subsection of " +
                     kind.name + " with a name of your choice");
      Checked result;
      prm.enter_subsection(kind.name);
      for (const ParameterSubsection &group : found->subsections)
        {
          const std::string path    = kind.name + "/" + group.name;
          const std::string problem = name_problem(group.name);
          if (!problem.empty())
            mistakes.add(group.place.text() + ": " + path + ": " + problem);
          refuse_subsections(group, path, mistakes);
          SubsectionCheck check(group, path, kind, mistakes);
          if (!check.run() || !problem.empty())
            continue;
          prm.enter_subsection(group.name);
          check.declare_and_set(prm);
          prm.leave_subsection();
          result.push_back({group.name, path, group.place});
        }
      prm.leave_subsection();
      return result;
    }

    Checked check_free_entries(const ParameterSubsection &root,
                               const SubsectionKind      &kind,
                               dealii::ParameterHandler  &prm,
                               Mistakes                  &mistakes)
    {
      const ParameterSubsection *found = root.find_subsection(kind.name);
      if (found == nullptr)
        return {};
      refuse_subsections(*found, kind.name, mistakes);
      Checked result;
      prm.enter_subsection(kind.name);
      for (const ParameterEntry &entry : found->entries)
        {
          const std::string path    = kind.name + "/" + entry.name;
          std::string       problem = name_problem(entry.name);
          if (problem.empty() && entry.value.empty())
            problem = "there is no value";
          if (!problem.empty())
            {
              mistakes.add(entry.place.text() + ": " + path + ": " + problem);
              continue;
            }
          declare(prm, Text{entry.name, "", "", true});
          prm.set(entry.name, entry.value);
          result.push_back({entry.name, path, entry.place});
        }
      prm.leave_subsection();
      return result;
    }
  } // namespace



  std::vector<CheckedSubsection>
  check_and_declare(const ParameterSubsection &root,
                    const SubsectionKind      &kind,
                    dealii::ParameterHandler  &prm,
                    Mistakes                  &mistakes)
  {
    switch (kind.form)
      {
        case Form::fixed:
          return check_fixed(root, kind, prm, mistakes);
        case Form::named_groups:
          return check_named_groups(root, kind, prm, mistakes);
        case Form::free_entries:
          return check_free_entries(root, kind, prm, mistakes);
      }
    return {};
  }



  void check_subsection_names(const ParameterSubsection &root,
                              const Model                model,
                              Mistakes                  &mistakes)
  {
    std::vector<std::string> known, others;
    for (const SubsectionKind &kind : subsection_kinds())
      if (!kind.name.empty())
        (kind.serves(model) ? known : others).push_back(kind.name);
    const auto is_among = [](const std::vector<std::string> &names,
                             const std::string              &name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const ParameterSubsection &found : root.subsections)
      if (is_among(others, found.name))
        mistakes.add(found.place.text() + ": subsection \"" + found.name +
                     "\" has no meaning with Model = " + name_of(model) +
                     ". Remove it or choose another Model\n  Allowed here: " +
                     joined(known));
      else if (!is_among(known, found.name))
        mistakes.add(found.place.text() + ": unknown subsection \"" +
                     found.name + "\"" + did_you_mean(found.name, known) +
                     "\n  Allowed here: " + joined(known));
  }
} // namespace auxfem
