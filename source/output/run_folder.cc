#include <auxfem/output/run_folder.h>
#include <auxfem/parameters/errors.h>

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
  {
    const bool is_continued = former_results == FormerResults::continued;
    const std::string &path = scene.output.directory;
    errno                   = 0;
    log_file.open(path + "/log.txt",
                  is_continued ? std::ios::app : std::ios::out);
    if (!log_file)
      folder.refuse("log.txt cannot be written", errno);

    std::error_code error;
    if (is_copied(scene) && !is_continued)
      fs::copy_file(scene.file, path + "/original.prm", error);
    if (error)
      folder.refuse("original.prm cannot be written", error.value());

    errno = 0;
    std::ofstream parameters(path + "/parameters.prm");
    parameters << scene.all_parameters;
    parameters.close();
    if (!parameters)
      folder.refuse("parameters.prm cannot be written", errno);
  }

  void RunFolder::claim_series(const std::string &name)
  {
    folder.claim_series(name);
  }

  void replace_file(const std::string &file, const std::string &text)
  {
    const std::string temporary = file + ".part";
    errno                       = 0;
    std::ofstream stream(temporary);
    stream << text;
    stream.close();

    std::error_code error;
    if (!stream)
      error = {errno, std::generic_category()};
    else
      fs::rename(temporary, file, error);
    if (error)
      throw ComputationError("Cannot write " + file + ": " + error.message() +
                             ".");
  }
} // namespace auxfem
