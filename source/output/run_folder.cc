#include <auxfem/output/run_folder.h>
#include <auxfem/parameters/errors.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

namespace auxfem
{
  namespace
  {
    namespace fs = std::filesystem;

    [[noreturn]] void refuse(const std::string     &folder,
                             const std::string     &what,
                             const std::error_code &reason)
    {
      throw InputError(
        "The output folder `" + folder + "` cannot be used.\n  " + what + ": " +
        reason.message() +
        "\nIt must be a folder that can be made and written to. Give another "
        "one with --output DIR or the parameter Output/Directory.");
    }

    std::error_code last_error()
    {
      return {errno, std::generic_category()};
    }

    /** Whether @p file is one of a graphics series called @p series. */
    bool belongs_to(const std::string &series, const fs::path &file)
    {
      const std::string extension = file.extension();
      return file.filename().string().rfind(series + "_", 0) == 0 &&
        (extension == ".vtu" || extension == ".pvtu");
    }

    void remove_former_results(const fs::path &folder)
    {
      std::error_code ignored;
      for (const char *name :
           {"summary.json", "history.csv", "history.units.csv"})
        fs::remove(folder / name, ignored);
      for (const std::string series : {"solution", "rigid_parts", "connectors"})
        {
          fs::remove(folder / (series + ".pvd"), ignored);
          std::error_code       no_folder;
          std::vector<fs::path> files;
          for (const fs::directory_entry &entry :
               fs::directory_iterator(folder / series, no_folder))
            if (belongs_to(series, entry.path()))
              files.push_back(entry.path());
          for (const fs::path &file : files)
            fs::remove(file, ignored);
          // With something else in it, the folder cannot be removed, and stays.
          if (fs::is_directory(folder / series, ignored))
            fs::remove(folder / series, ignored);
        }
    }

    void keep_original(const std::string &scene_file, const fs::path &copy)
    {
      std::error_code error;
      // A scene may come from memory, or be the original.prm of a former run.
      if (!fs::is_regular_file(scene_file, error) ||
          fs::equivalent(scene_file, copy, error))
        return;
      fs::copy_file(scene_file,
                    copy,
                    fs::copy_options::overwrite_existing,
                    error);
      if (error)
        refuse(copy.parent_path(), "original.prm cannot be written", error);
    }
  } // namespace

  std::ofstream open_run_folder(const Scene &scene, const std::string &folder)
  {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      refuse(folder, "It cannot be made", error);
    if (!fs::is_directory(folder, error))
      refuse(folder,
             "It is not a folder",
             std::make_error_code(std::errc::not_a_directory));

    errno = 0;
    std::ofstream log(folder + "/log.txt");
    if (!log)
      refuse(folder, "log.txt cannot be written", last_error());

    remove_former_results(folder);
    keep_original(scene.file, fs::path(folder) / "original.prm");

    errno = 0;
    std::ofstream parameters(folder + "/parameters.prm");
    parameters << scene.all_parameters;
    parameters.close();
    if (!parameters)
      refuse(folder, "parameters.prm cannot be written", last_error());
    return log;
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
      error = last_error();
    else
      fs::rename(temporary, file, error);
    if (error)
      throw ComputationError("Cannot write " + file + ": " + error.message() +
                             ".");
  }
} // namespace auxfem
