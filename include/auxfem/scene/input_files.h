#ifndef auxfem_scene_input_files_h
#define auxfem_scene_input_files_h

#include <auxfem/parameters/parameter_file.h>

#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The files that a scene with the parameters @p root is read from, each at
   * most once: the parameter file @p file with those it includes, tables, the
   * mesh file.
   */
  std::vector<std::string> input_files(const ParameterSubsection &root,
                                       const std::string         &file);
} // namespace auxfem

#endif
