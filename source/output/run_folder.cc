#include <auxfem/output/output_file.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/input_file.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace auxfem
{
  namespace
  {
    namespace fs = std::filesystem;

    /** A scene may come from memory, or be the original.prm of a former run. */
    bool is_copied(const Scene &scene)
    {
      std::error_code ignored;
      return fs::is_regular_file(scene.file, ignored) &&
        !fs::equivalent(scene.file,
                        scene.output.directory + "/original.prm",
                        ignored);
    }

    FolderContents contents_of(const Scene          &scene,
                               const FolderContents &further)
    {
      FolderContents contents{
        {"log.txt",
         "parameters.prm",
         "history.csv",
         "history.units.csv",
         "summary.json",
         "summary.json.part",
         "checkpoint_a",
         "checkpoint_a.part",
         "checkpoint_b",
         "checkpoint_b.part"},
        {"solution", "rigid_parts", "connectors", "contacts", "plates"}};
      if (is_copied(scene))
        contents.files.emplace_back("original.prm");
      contents.files.insert(contents.files.end(),
                            further.files.begin(),
                            further.files.end());
      contents.series.insert(contents.series.end(),
                             further.series.begin(),
                             further.series.end());
      return contents;
    }
  } // namespace

  FileRules with_inputs_of(const Scene &scene, FileRules rules)
  {
    rules.input_files.insert(rules.input_files.end(),
                             scene.input_files.begin(),
                             scene.input_files.end());
    return rules;
  }

  RunFolder::RunFolder(const Scene          &scene,
                       const FileRules      &rules,
                       const FolderContents &further,
                       const FormerResults   former_results)
    : folder(scene.output.directory,
             contents_of(scene, further),
             with_inputs_of(scene, rules),
             former_results)
    , path(scene.output.directory)
  {
    const bool is_continued = former_results == FormerResults::continued;
    errno                   = 0;
    log_file                = open_output_file(path + "/log.txt",
                                is_continued ? std::ios::app : std::ios::out);
    if (!log_file)
      folder.refuse("log.txt cannot be written", errno);

    if (is_copied(scene) && !is_continued)
      write("original.prm", read_input_file(scene.file));
    write("parameters.prm", scene.all_parameters);
  }

  void RunFolder::write(const std::string &name, const std::string &text) const
  {
    errno                = 0;
    std::ofstream stream = open_output_file(path + "/" + name);
    stream << text;
    stream.close();
    if (!stream)
      folder.refuse(name + " cannot be written", errno);
  }

  void RunFolder::claim_series(const std::string &name)
  {
    folder.claim_series(name);
  }

  void replace_file(const std::string &file, const std::string &text)
  {
    const std::string temporary = file + ".part";
    std::error_code   error;
    fs::remove(temporary, error);
    errno                = 0;
    std::ofstream stream = open_output_file(temporary);
    stream << text;
    stream.close();

    if (!stream)
      error = {errno, std::generic_category()};
    else
      fs::rename(temporary, file, error);
    if (error)
      throw ComputationError("Cannot write " + file + ": " + error.message() +
                             ".");
  }
} // namespace auxfem
