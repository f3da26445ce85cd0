#ifndef auxfem_scene_constants_h
#define auxfem_scene_constants_h

#include <auxfem/parameters/parameter_values.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** The parameter `Constants` at the top of the file. */
  const Parameter &constants_parameter();

  /**
   * Reads the names and values of `Constants`. Throws InputError for one that
   * is not understood, has a meaning already or is given twice.
   */
  std::vector<std::pair<std::string, double>>
  read_constants(const ParameterValues &values);

  /** Name of the constant that @p path, `Constants/NAME`, means; none for other
   * paths. */
  std::optional<std::string> constant_in(const std::string &path);

  /** Text of the constant @p name in the file; none if it is not defined. */
  std::optional<std::string> text_of_constant(const ParameterSubsection &root,
                                              const std::string         &name);

  /** Defines the constant @p name anew as @p text. Throws InputError if it is
   * not defined. */
  void set_constant(ParameterSubsection &root,
                    const std::string   &name,
                    const std::string   &text);
} // namespace auxfem

#endif
