#ifndef auxfem_output_run_files_h
#define auxfem_output_run_files_h

#include <auxfem/output/output_folder.h>
#include <auxfem/scene/scene.h>

#include <optional>

namespace auxfem
{
  /** Files of @p scene besides those of every run. */
  FolderContents further_contents(const Scene &scene);

  /** Time between frames for ParaView (s); empty: none within the run. */
  std::optional<double> frame_interval(const Scene &scene);
} // namespace auxfem

#endif
