#include <auxfem/parameters/scene_context.h>

#include <filesystem>

namespace auxfem
{
  std::string absolute_file(const std::string  &file,
                            const SceneContext &context)
  {
    namespace fs = std::filesystem;
    return (fs::absolute(context.directory) / file).lexically_normal().string();
  }
} // namespace auxfem
