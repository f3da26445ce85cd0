#include <auxfem/parameters/parameter_file.h>
#include <auxfem/scene/input_files.h>

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <set>

namespace auxfem
{
  namespace
  {
    using dealii::Utilities::trim;

    /** Adds the files that @p subsection lies in and refers to. */
    void collect_files(const ParameterSubsection &subsection,
                       const std::string         &directory,
                       std::set<std::string>     &files)
    {
      const auto refer = [&](const std::string &name) {
        files.insert((std::filesystem::path(directory) / name).string());
      };
      for (const ParameterEntry &entry : subsection.entries)
        {
          files.insert(entry.place.file);
          const std::string table = "table:";
          if (subsection.name == "Lattice" && entry.name == "File")
            refer(entry.value);
          if (entry.value.compare(0, table.size(), table) != 0)
            continue;
          // A comma may be part of the name, or stand before a column.
          const std::string name = trim(entry.value.substr(table.size()));
          refer(name);
          refer(trim(name.substr(0, name.rfind(','))));
        }
      for (const ParameterSubsection &child : subsection.subsections)
        {
          files.insert(child.place.file);
          collect_files(child, directory, files);
        }
    }
  } // namespace

  std::vector<std::string>
  input_files(const std::string              &file,
              const std::vector<std::string> &overrides)
  {
    ParameterSubsection root = read_parameter_file(file);
    for (const std::string &assignment : overrides)
      apply_override(root, assignment);
    std::set<std::string> files = {file};
    collect_files(root, std::filesystem::path(file).parent_path(), files);
    return {files.begin(), files.end()};
  }
} // namespace auxfem
