#include <auxfem/output/output_file.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/parameter_file.h>
#include <auxfem/study/kept_runs.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::array<std::string, 3> without_influence = {"Output",
                                                          "Study",
                                                          "Quantities"};

    /** Without what does not change a run. */
    std::string influential_values(ParameterSubsection root)
    {
      root.subsections.erase(
        std::remove_if(root.subsections.begin(),
                       root.subsections.end(),
                       [](const ParameterSubsection &subsection) {
                         return std::find(without_influence.begin(),
                                          without_influence.end(),
                                          subsection.name) !=
                           without_influence.end();
                       }),
        root.subsections.end());
      return values_text(root, "");
    }

    std::string hash_of(const std::string &text)
    {
      constexpr unsigned int hexadecimal = 16;
      std::string            digits;
      for (std::size_t rest = std::hash<std::string>()(text); rest > 0;
           rest /= hexadecimal)
        digits += "0123456789abcdef"[rest % hexadecimal];
      return digits;
    }

    std::string contents(const std::string &file)
    {
      std::ifstream stream(file);
      return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::string file_of(const std::string &folder, const std::string &key)
    {
      return folder + "/" + hash_of(key) + ".json";
    }
  } // namespace



  std::string key_of(const Scene &scene, const unsigned int n_ranks)
  {
    std::string text = "auxfem " + version_text() + " on " +
      std::to_string(n_ranks) + " ranks\n";
    text += influential_values(
      parse_parameter_text(scene.all_parameters, scene.file));
    for (const std::string &file : scene.input_files)
      if (file != scene.file)
        text += file + " " + hash_of(contents(file)) + '\n';
    return text;
  }



  std::optional<MeasuredRun> kept_run(const std::string &folder,
                                      const std::string &key)
  {
    std::ifstream stream(file_of(folder, key));
    try
      {
        const Json json = Json::parse(stream);
        // Another run may have the same hash.
        if (json.at("key") == key)
          return measured_run_of(json.at("run"));
      }
    catch (const Json::exception &)
      {
        // There is none, or its file is damaged.
      }
    return {};
  }



  void keep_run(const std::string &folder,
                const std::string &key,
                const MeasuredRun &run)
  {
    if (const std::error_code error = make_output_subfolder(folder))
      throw ComputationError("Cannot make the folder " + folder + ": " +
                             output_error_text(error.value()) + ".");
    replace_file(file_of(folder, key),
                 Json{{"key", key}, {"run", json_of(run)}}
                   .dump(-1, ' ', false, Json::error_handler_t::replace));
  }
} // namespace auxfem
