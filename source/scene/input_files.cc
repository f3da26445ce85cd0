#include <auxfem/loads/time_function.h>
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
          if (subsection.name == "Lattice" && entry.name == "File")
            refer(entry.value);
          const std::optional<TableText> table = table_text(entry.value);
          if (!table)
            continue;
          // A comma may be part of the name, or stand before a column.
          refer(table->file);
          refer(trim(table->file.substr(0, table->file.rfind(','))));
        }
      for (const ParameterSubsection &child : subsection.subsections)
        {
          files.insert(child.place.file);
          collect_files(child, directory, files);
        }
    }
  } // namespace

  std::vector<std::string> input_files(const ParameterSubsection &root,
                                       const std::string         &file)
  {
    std::set<std::string> files = {file};
    collect_files(root, std::filesystem::path(file).parent_path(), files);
    return {files.begin(), files.end()};
  }
} // namespace auxfem
