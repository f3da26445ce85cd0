#include <auxfem/output/figure_files.h>
#include <auxfem/output/response_files.h>
#include <auxfem/output/run_files.h>
#include <auxfem/output/singular_point_files.h>

namespace auxfem
{
  FolderContents further_contents(const Scene &scene)
  {
    FolderContents contents;
    if (scene.analysis == Analysis::static_path)
      contents = path_contents();
    else if (scene.analysis == Analysis::effective_response)
      contents = response_contents();
    for (const std::string &file : figure_files(scene))
      contents.files.push_back(file);
    return contents;
  }

  std::optional<double> frame_interval(const Scene &scene)
  {
    if (!scene.output.graphics)
      return std::nullopt;
    constexpr unsigned int n_frames = 50;
    const double           interval =
      scene.output.graphics_interval.value_or(scene.time.end_time / n_frames);
    return interval > 0 ? std::optional(interval) : std::nullopt;
  }
} // namespace auxfem
