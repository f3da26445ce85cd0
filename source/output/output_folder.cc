#include <auxfem/output/failures.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/view_script_template.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/parameters/text.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

namespace auxfem
{
  std::ofstream open_output_file(const std::string       &file,
                                 const std::ios::openmode mode)
  {
    const bool    may_be_new = (mode & std::ios::in) == 0;
    std::ofstream stream;
    const int     descriptor = ::open(file.c_str(),
                                  O_WRONLY | O_NOFOLLOW | O_NONBLOCK |
                                    O_CLOEXEC | (may_be_new ? O_CREAT : 0),
                                  0666);
    if (descriptor < 0)
      {
        stream.setstate(std::ios::failbit);
        return stream;
      }
    // Reopening by name could follow a link created in the meantime.
    stream.open("/proc/self/fd/" + std::to_string(descriptor), mode);
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return stream;
  }

  std::error_code make_output_subfolder(const std::string &path)
  {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (!error &&
        std::filesystem::is_symlink(
          std::filesystem::symlink_status(path, error)))
      error = {ELOOP, std::generic_category()};
    return error;
  }

  std::string output_error_text(const int error)
  {
    return error == ELOOP ? "it is a link, and output never goes through links"
                          : std::generic_category().message(error);
  }

  namespace
  {
    namespace fs = std::filesystem;

    const std::string list_name = ".auxfem-files", view_script_name = "view.py";

    const std::string list_head =
      "# Written here by auxfem, which replaces these and nothing else:\n";

    bool exists(const fs::path &file)
    {
      // A dangling link exists, too.
      std::error_code ignored;
      return fs::exists(fs::symlink_status(file, ignored));
    }

    std::vector<fs::path> entries(const fs::path &folder)
    {
      std::error_code       no_folder;
      std::vector<fs::path> found;
      for (const fs::directory_entry &entry :
           fs::directory_iterator(folder, no_folder))
        found.push_back(entry.path());
      std::sort(found.begin(), found.end());
      return found;
    }

    /**
     * Whether @p text has the form "_12.vtu", "_12.pvtu" or, for a rank,
     * "_12.3.vtu".
     */
    bool is_number_of_file(std::string_view text)
    {
      const auto remove_number_after = [&text](const char first) {
        const std::size_t end =
          std::min(text.find_first_not_of("0123456789", 1), text.size());
        if (end < 2 || text[0] != first)
          return false;
        text.remove_prefix(end);
        return true;
      };
      if (!remove_number_after('_'))
        return false;
      remove_number_after('.');
      return text == ".vtu" || text == ".pvtu";
    }

    bool is_file_of_series(const std::string &file, const std::string &series)
    {
      return file.compare(0, series.size(), series) == 0 &&
        is_number_of_file(std::string_view(file).substr(series.size()));
    }
  } // namespace

  std::vector<std::string> FolderContents::names() const
  {
    std::vector<std::string> all = files;
    for (const std::string &name : series)
      all.push_back(name + ".pvd");
    return all;
  }

  OutputFolder::OutputFolder(const std::string    &path,
                             const FolderContents &contents,
                             const FileRules      &rules,
                             const FormerResults   former_results)
    : path(path)
  {
    make_folder();
    refuse_links(contents, former_results);
    // A refused folder must remain unchanged, also without a new list.
    if (exists(file(list_name)))
      {
        lock();
        read_list();
      }
    if (former_results == FormerResults::continued)
      return;
    const std::vector<std::string> names = existing_results(contents);
    refuse_input(names, rules.input_files);
    if (!rules.replaces_files_of_others)
      refuse_files_of_others(names);
    if (list.number < 0)
      lock();
    remove(contents, names);
    remove_results_of_other_kinds(rules);
    own_names.insert(contents.files.begin(), contents.files.end());
    write_list();
  }

  void OutputFolder::refuse_links(const FolderContents &contents,
                                  const FormerResults   former_results) const
  {
    std::vector<std::string> names = contents.series;
    names.push_back(list_name);
    // Otherwise they are removed or refused later.
    if (former_results == FormerResults::continued)
      for (const std::string &name : contents.names())
        names.push_back(name);
    std::error_code ignored;
    for (const std::string &name : names)
      if (fs::is_symlink(fs::symlink_status(file(name), ignored)))
        refuse(name + " cannot be written", ELOOP);
  }

  OutputFolder::Descriptor::~Descriptor()
  {
    if (number >= 0)
      close(number);
  }

  void OutputFolder::claim_series(const std::string &name)
  {
    own_names.insert({name + ".pvd", name + "/"});
    write_list();
  }

  void OutputFolder::refuse(const std::string &what, const int reason) const
  {
    throw InputError("The output folder `" + path + "` cannot be used.\n  " +
                     what + ": " + output_error_text(reason) +
                     "\nThe folder must be writable. Give another one "
                     "with --output DIR or the parameter Output/Directory.");
  }

  void OutputFolder::make_folder() const
  {
    std::error_code error;
    fs::create_directories(path, error);
    if (error)
      refuse("It cannot be made", error.value());
    if (!fs::is_directory(path, error))
      refuse("It is not a folder", ENOTDIR);
  }

  void OutputFolder::lock()
  {
    list.number = ::open(file(list_name).c_str(),
                         O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC,
                         0666);
    if (list.number < 0)
      refuse(list_name + " cannot be written", errno);
    // A file system without locks cannot protect runs from each other.
    if (flock(list.number, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
      return;
    throw InputError(
      "Another run of auxfem is writing into the output folder `" + path +
      "`.\nWait for its end, or give another folder with "
      "--output DIR or the parameter Output/Directory.");
  }

  void OutputFolder::read_list()
  {
    std::ifstream stream(file(list_name));
    std::string   line;
    // A run that was killed at its start leaves an empty list.
    if (!std::getline(stream, line))
      return;
    if (line + '\n' != list_head)
      refuse(list_name + " was not written by auxfem", EEXIST);
    while (std::getline(stream, line))
      own_names.insert(line);
  }

  void OutputFolder::write_list()
  {
    std::string text = list_head;
    for (const std::string &name : own_names)
      text += name + '\n';
    if (ftruncate(list.number, 0) != 0 ||
        pwrite(list.number, text.data(), text.size(), 0) !=
          ssize_t(text.size()))
      refuse(list_name + " cannot be written", errno);
  }

  std::vector<std::string>
  OutputFolder::existing_results(const FolderContents &contents) const
  {
    std::vector<std::string> names;
    for (const std::string &name : contents.files)
      if (exists(file(name)))
        names.push_back(name);
    for (const std::string &series : contents.series)
      {
        if (exists(file(series + ".pvd")))
          names.push_back(series + ".pvd");
        for (const fs::path &entry : entries(file(series)))
          if (const std::string name = entry.filename().string();
              is_file_of_series(name, series))
            names.push_back(series + "/" + name);
      }
    return names;
  }

  bool OutputFolder::is_own(const std::string &name) const
  {
    // The list names the folder of a series instead of its many files.
    return own_names.count(name) > 0 ||
      own_names.count(name.substr(0, name.find('/') + 1)) > 0;
  }

  bool OutputFolder::is_one_of(const std::string              &name,
                               const std::vector<std::string> &files) const
  {
    std::error_code ignored;
    return std::any_of(files.begin(), files.end(), [&](const auto &other) {
      return fs::equivalent(file(name), other, ignored);
    });
  }

  void
  OutputFolder::refuse_input(const std::vector<std::string> &names,
                             const std::vector<std::string> &input_files) const
  {
    for (const std::string &name : names)
      for (const std::string &input : input_files)
        if (is_one_of(name, {input}))
          throw InputError(
            "The run reads " + input + ", and would replace it by its " + name +
            " in the output folder `" + path +
            "`.\nGive another folder with --output DIR or the parameter "
            "Output/Directory, or move the file and update the references to "
            "it.");
  }

  void OutputFolder::refuse_files_of_others(
    const std::vector<std::string> &names) const
  {
    unsigned int n = 0;
    std::string  text;
    for (const std::string &name : names)
      if (!is_own(name) && n++ < max_listed_items)
        text += (text.empty() ? "" : ", ") + name;
    if (n == 0)
      return;
    if (n > max_listed_items)
      text += " and " + std::to_string(n - max_listed_items) + " more";
    throw InputError(
      "The output folder `" + path +
      "` has files that auxfem has not written there and would replace:\n  " +
      text +
      "\nGive another folder with --output DIR or the parameter "
      "Output/Directory, move these files away, or replace them with --force.");
  }

  void OutputFolder::remove(const FolderContents           &contents,
                            const std::vector<std::string> &names)
  {
    std::error_code ignored;
    for (const std::string &name : names)
      {
        if (!fs::is_directory(fs::symlink_status(file(name), ignored)))
          fs::remove(file(name), ignored);
        own_names.erase(name);
      }
    for (const std::string &series : contents.series)
      {
        // The folder remains if it has other files.
        if (own_names.erase(series + "/") > 0 &&
            fs::is_directory(file(series), ignored))
          fs::remove(file(series), ignored);
      }
  }

  void OutputFolder::remove_results_of_other_kinds(const FileRules &rules)
  {
    std::error_code ignored;
    for (const std::string &name : rules.results_of_other_kinds)
      if (own_names.count(name) > 0 && !is_one_of(name, rules.input_files))
        {
          fs::remove(file(name), ignored);
          own_names.erase(name);
        }
  }

  namespace
  {
    namespace fs = std::filesystem;

    /**
     * Whether the scene file is copied: not if the scene comes from memory or
     * is the original.prm of an earlier run.
     */
    bool is_copied(const Scene &scene)
    {
      std::error_code ignored;
      return fs::is_regular_file(scene.file, ignored) &&
        !fs::equivalent(scene.file,
                        scene.output.directory + "/original.prm",
                        ignored);
    }

    /** The script for ParaView. Its own folder is not known where ParaView runs
     * it from a menu, so that the present one stands in it. */
    std::string view_script(const std::string &folder)
    {
      std::string       text   = view_script_template;
      const std::string marker = "FOLDER_OF_THE_RUN";
      return text.replace(text.find(marker),
                          marker.size(),
                          Json(fs::absolute(folder).string()).dump());
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
         view_script_name,
         "checkpoint_a",
         "checkpoint_a.part",
         "checkpoint_b",
         "checkpoint_b.part"},
        {"solution", "rigid_parts", "connectors", "contacts", "plates"}};
      if (is_copied(scene))
        contents.files.emplace_back("original.prm");
      const auto may_break = [](const SectionDefinition &definition) {
        return definition.section.law && definition.section.law->failure_time();
      };
      if (std::any_of(scene.sections.begin(), scene.sections.end(), may_break))
        contents.files.emplace_back(broken_struts_table);
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
    if (scene.output.graphics)
      write(view_script_name, view_script(path));
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
