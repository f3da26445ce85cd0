#ifndef auxfem_scene_input_files_h
#define auxfem_scene_input_files_h

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The files that read_scene() with the same arguments reads, if they exist:
   * the parameter file with those it includes, tables, the mesh file. Throws
   * InputError as read_parameter_file().
   */
  std::vector<std::string>
  input_files(const std::string              &file,
              const std::vector<std::string> &overrides);
} // namespace auxfem

#endif
